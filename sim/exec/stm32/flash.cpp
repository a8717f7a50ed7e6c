#include "sim/exec/stm32/flash.h"

#include <algorithm>

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr SimTime kProgram = 52'500 * kNanosecond, kErase = 30 * kMillisecond;

}  // namespace

void Flash::reset(Address) {
  state_.access = 0x30;
  state_.control = kFlashLock;
  state_.status = state_.address = 0;
  state_.first_key = false;
}

std::uint32_t Flash::read(Address address) {
  switch (address) {
    case kFlashAcr:
      return state_.access | (state_.access & kPrefetch) << 1;
    case kFlashSr:
      return state_.status;
    case kFlashCr:
      return state_.control;
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
      state_.access = value & 0x1F;
      return true;
    case kFlashKeyr:
      if (value == kFlashKey2 && state_.first_key) state_.control &= ~kFlashLock;
      state_.first_key = value == kFlashKey1;
      return true;
    case kFlashSr:
      state_.status &= ~(value & (kFlashPgErr | kFlashDone | 1u << 4));
      return true;
    case kFlashCr:
      if (state_.control & kFlashLock) return true;
      if (value & ~(kFlashPg | kFlashPer | kFlashStart | kFlashLock)) return false;
      state_.control = value & ~kFlashStart;
      if (value & kFlashStart && value & kFlashPer) erase();
      return true;
    case kFlashAr:
      state_.address = value;
      return true;
    default:
      return false;
  }
}

void Flash::erase() {
  const Address offset = (state_.address - kFlash) / kPageBytes * kPageBytes;
  if (state_.address < kFlash || offset >= kFlashBytes) return;
  memory_.erase(offset);
  changed_ = kFlash + offset;
  link_.clock.now += link_.clock.cycles_in(kErase);
  state_.status |= kFlashDone;
}

std::uint32_t Flash::read_memory(Address address, unsigned size) const {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < size; ++i)
    value |= (owns_memory(address + i) ? std::uint32_t{memory_.data()[address + i - kFlash]} : 0xFFu)
             << (8 * i);
  return value;
}

bool Flash::programs(Address address, unsigned size) const {
  return owns_memory(address) && size == 2 && state_.control & kFlashPg && !(state_.control & kFlashLock);
}

void Flash::program(Address address, std::uint32_t value) {
  const std::uint8_t* const half = memory_.data() + (address - kFlash);
  const unsigned before = half[0] | half[1] << 8;
  link_.clock.now += link_.clock.cycles_in(kProgram);
  if (before != 0xFFFF && value != 0) {  // a halfword that is not erased accepts only the value 0
    state_.status |= kFlashPgErr;
    return;
  }
  memory_.program(address - kFlash, static_cast<std::uint16_t>(value));
  changed_ = address / kPageBytes * kPageBytes;
  state_.status |= kFlashDone;
}

}  // namespace robosim::exec::stm32
