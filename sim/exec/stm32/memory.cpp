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
                                            0xFF,  // offsets 0 to 7: size of flash in KB
                                            0x33,
                                            0xFF,
                                            0xD7,
                                            0x05,
                                            0x52,
                                            0x4F,
                                            0x42,
                                            0x4F,  // offsets 8 to 19: unique number
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
                                            0x00,  // offsets 32 to 47: option bytes
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

FlashMemory::FlashMemory(const std::vector<std::uint8_t>& program)
    : AlignedBytes(kFlashBytes, 0xFF),
      program_(program.begin(), program.begin() + static_cast<std::ptrdiff_t>(
                                                      std::min<std::size_t>(program.size(), kFlashBytes))) {
  std::copy(program_.begin(), program_.end(), data());
}

void FlashMemory::program(Address offset, std::uint16_t half) {
  data()[offset] = static_cast<std::uint8_t>(half);
  data()[offset + 1] = static_cast<std::uint8_t>(half >> 8);
  unsaved_.insert(offset / kPageBytes * kPageBytes);
}

void FlashMemory::erase(Address offset) {
  const Address begin = offset / kPageBytes * kPageBytes;
  std::fill_n(data() + begin, kPageBytes, std::uint8_t{0xFF});
  unsaved_.insert(begin);
}

FlashMemory::State FlashMemory::save() const {
  for (const Address offset : unsaved_) {
    auto page = std::make_shared<Page>();
    std::copy_n(data() + offset, kPageBytes, page->begin());
    state_[offset] = std::move(page);
  }
  unsaved_.clear();
  return state_;
}

std::vector<Address> FlashMemory::restore(const State& saved) {
  std::set<Address> changed = unsaved_;
  for (const auto& [offset, page] : saved)
    if (const auto now = state_.find(offset); now == state_.end() || now->second != page)
      changed.insert(offset);
  for (const auto& [offset, page] : state_)
    if (!saved.contains(offset)) changed.insert(offset);
  for (const Address offset : changed) {
    std::uint8_t* const to = data() + offset;
    if (const auto page = saved.find(offset); page != saved.end()) {
      std::copy(page->second->begin(), page->second->end(), to);
    } else {
      std::fill_n(to, kPageBytes, std::uint8_t{0xFF});
      if (offset < program_.size())
        std::copy_n(program_.data() + offset, std::min<std::size_t>(kPageBytes, program_.size() - offset),
                    to);
    }
  }
  state_ = saved;
  unsaved_.clear();
  return {changed.begin(), changed.end()};
}

}  // namespace robosim::exec::stm32
