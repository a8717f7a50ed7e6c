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

FlashMemory::FlashMemory(const std::vector<std::uint8_t>& program) : AlignedBytes(kFlashBytes, 0xFF) {
  std::copy_n(program.begin(), std::min<std::size_t>(program.size(), kFlashBytes), data());
}

}  // namespace robosim::exec::stm32
