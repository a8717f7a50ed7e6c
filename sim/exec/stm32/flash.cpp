#include "sim/exec/stm32/flash.h"

#include <algorithm>

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr SimTime kProgram = 52'500 * kNanosecond, kErase = 30 * kMillisecond;

}  // namespace

std::uint32_t Flash::read(Address address) const {
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
  if (!owns_page(address_)) return;
  const auto page = static_cast<std::ptrdiff_t>((address_ - kEepromFlash) / kPageBytes * kPageBytes);
  std::fill_n(pages_.begin() + page, kPageBytes, std::uint8_t{0xFF});
  link_.clock.now += link_.clock.cycles_in(kErase);
  status_ |= kFlashDone;
}

std::uint32_t Flash::read_page(Address address, unsigned size) const {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < size && owns_page(address + i); ++i)
    value |= static_cast<std::uint32_t>(pages_[address + i - kEepromFlash]) << (8 * i);
  return value;
}

bool Flash::program(Address address, std::uint32_t value, unsigned size) {
  if (control_ & kFlashLock || !(control_ & kFlashPg) || size != 2) return false;
  const std::uint32_t before = read_page(address, 2);
  link_.clock.now += link_.clock.cycles_in(kProgram);
  if (before != 0xFFFF && value != 0) {  // only an erased half, or to zeros
    status_ |= kFlashPgErr;
    return true;
  }
  pages_[address - kEepromFlash] = static_cast<std::uint8_t>(value);
  pages_[address - kEepromFlash + 1] = static_cast<std::uint8_t>(value >> 8);
  status_ |= kFlashDone;
  return true;
}

}  // namespace robosim::exec::stm32
