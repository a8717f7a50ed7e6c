#include "sim/exec/stm32/memory.h"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

AlignedBytes::AlignedBytes(std::size_t size, std::uint8_t fill)
    : bytes_(static_cast<std::uint8_t*>(std::aligned_alloc(4096, size)), std::free) {
  if (!bytes_) throw std::bad_alloc();
  std::fill_n(data(), size, fill);
}

const std::uint8_t* chip_facts(Address address, unsigned bytes) {
  constexpr Address kBegin = 0x1FFFF7E0;
  static constexpr std::uint8_t kFacts[] = {kFlashBytes / 1024,
                                            0,
                                            0xFF,
                                            0xFF,
                                            0xFF,
                                            0xFF,
                                            0xFF,
                                            0xFF,  // flash in KB
                                            0x33,
                                            0xFF,
                                            0xD7,
                                            0x05,
                                            0x52,
                                            0x4F,
                                            0x42,
                                            0x4F,  // the unique number: 12 bytes
                                            0x53,
                                            0x49,
                                            0x4D,
                                            0x43,
                                            0xFF,
                                            0xFF,
                                            0xFF,
                                            0xFF,
                                            0xFF,
                                            0xFF,
                                            0xFF,
                                            0xFF,
                                            0xFF,
                                            0xFF,
                                            0xFF,
                                            0xFF,
                                            0xA5,
                                            0x5A,
                                            0xFF,
                                            0x00,
                                            0xFF,
                                            0x00,
                                            0xFF,
                                            0x00,  // option bytes
                                            0xFF,
                                            0x00,
                                            0xFF,
                                            0x00,
                                            0xFF,
                                            0x00,
                                            0xFF,
                                            0x00};
  static_assert(sizeof kFacts == 48);
  return address >= kBegin && address - kBegin <= sizeof kFacts - bytes ? kFacts + (address - kBegin)
                                                                        : nullptr;
}

FlashMemory::FlashMemory(const std::vector<std::uint8_t>& program) : AlignedBytes(kFlashBytes, 0xFF) {
  std::copy_n(program.begin(), std::min<std::size_t>(program.size(), kFlashBytes), data());
}

}  // namespace robosim::exec::stm32
