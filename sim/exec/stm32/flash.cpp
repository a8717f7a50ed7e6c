#include "sim/exec/stm32/flash.h"

#include <algorithm>

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr SimTime kProgram = 52'500 * kNanosecond, kErase = 30 * kMillisecond;

}  // namespace

void Flash::reset(Address) {
  access_ = 0x30;
  control_ = kFlashLock;
  status_ = address_ = 0;
  first_key_ = false;
}

std::uint32_t Flash::read(Address address) {
  switch (address) {
    case kFlashAcr:
      return access_ | (access_ & kPrefetch) << 1;
    case kFlashSr:
      return status_;
    case kFlashCr:
      return control_;
    case kFlashIf + 0x1C:
      return 0x03FFFFFC;  // FLASH_OBR: no read protection
    case kFlashIf + 0x20:
      return 0xFFFFFFFF;  // FLASH_WRPR: no write protection
    default:
      return 0;
  }
}

bool Flash::write(Address address, std::uint32_t value) {
  switch (address) {
    case kFlashAcr:
      access_ = value & 0x1F;
      return true;
    case kFlashKeyr:
      if (value == kFlashKey2 && first_key_) control_ &= ~kFlashLock;
      first_key_ = value == kFlashKey1;
      return true;
    case kFlashSr:
      status_ &= ~(value & (kFlashPgErr | kFlashDone | 1u << 4));
      return true;
    case kFlashCr:
      if (control_ & kFlashLock) return true;
      if (value & ~(kFlashPg | kFlashPer | kFlashStart | kFlashLock)) return false;
      control_ = value & ~kFlashStart;
      if (value & kFlashStart && value & kFlashPer) erase();
      return true;
    case kFlashAr:
      address_ = value;
      return true;
    default:
      return false;
  }
}

void Flash::erase() {
  const Address offset = (address_ - kFlash) / kPageBytes * kPageBytes;
  if (address_ < kFlash || offset >= kFlashBytes) return;
  std::fill_n(memory_.data() + offset, kPageBytes, std::uint8_t{0xFF});
  changed_ = kFlash + offset;
  link_.clock.now += link_.clock.cycles_in(kErase);
  status_ |= kFlashDone;
}

std::uint32_t Flash::read_memory(Address address, unsigned size) const {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < size; ++i)
    value |= (owns_memory(address + i) ? std::uint32_t{memory_.data()[address + i - kFlash]} : 0xFFu)
             << (8 * i);
  return value;
}

bool Flash::programs(Address address, unsigned size) const {
  return owns_memory(address) && size == 2 && control_ & kFlashPg && !(control_ & kFlashLock);
}

void Flash::program(Address address, std::uint32_t value) {
  std::uint8_t* const half = memory_.data() + (address - kFlash);
  const unsigned before = half[0] | half[1] << 8;
  link_.clock.now += link_.clock.cycles_in(kProgram);
  if (before != 0xFFFF && value != 0) {  // only an erased half, or to zeros
    status_ |= kFlashPgErr;
    return;
  }
  half[0] = static_cast<std::uint8_t>(value);
  half[1] = static_cast<std::uint8_t>(value >> 8);
  changed_ = address / kPageBytes * kPageBytes;
  status_ |= kFlashDone;
}

}  // namespace robosim::exec::stm32
