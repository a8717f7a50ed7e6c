#include "sim/exec/host/round_finder.h"

#include <algorithm>

namespace robosim::exec {
namespace {

// Whatever a sanitizer forbids to others: stacks and heaps have gaps that nobody may read.
__attribute__((no_sanitize("address"))) bool is_like(RoundFinder::Memory memory,
                                                     const std::vector<std::byte>& copy) {
  if (memory.size() != copy.size()) return false;
  for (std::size_t i = 0; i < copy.size(); ++i)
    if (memory[i] != copy[i]) return false;
  return true;
}

__attribute__((no_sanitize("address"))) void copy(RoundFinder::Memory memory, std::vector<std::byte>& to) {
  to.resize(memory.size());
  for (std::size_t i = 0; i < memory.size(); ++i) to[i] = memory[i];
}

}  // namespace

RoundFinder::RoundFinder(const LoadedImage& image, Memory heap) : kept_{heap} {
  std::vector<MemoryRange> clockworks;  // which do not come round
  for (std::size_t i = 0; i < image.entry().clockwork_count; ++i) {
    const host::Clockwork& clockwork = image.entry().clockworks[i];
    const auto* const begin = static_cast<const std::byte*>(clockwork.begin);
    clockworks.push_back({begin, begin + clockwork.bytes});
  }
  std::ranges::sort(clockworks, {}, &MemoryRange::begin);
  for (const MemoryRange& variables : image.variables()) {
    const std::byte* at = variables.begin;
    for (const MemoryRange& clockwork : clockworks) {
      if (clockwork.begin < at || clockwork.begin >= variables.end) continue;
      kept_.push_back({at, clockwork.begin});
      at = clockwork.end;
    }
    kept_.push_back({at, variables.end});
  }
}

void RoundFinder::begin() {
  place_ = nullptr;
  power_ = 1;
  since_ = 0;
}

void RoundFinder::take(const void* place, Memory stack) {
  place_ = place;
  copy(stack, stack_);
  copies_.resize(kept_.size());
  for (std::size_t i = 0; i < kept_.size(); ++i) copy(kept_[i], copies_[i]);
}

bool RoundFinder::is_taken(const void* place, Memory stack) const {
  if (place != place_ || !is_like(stack, stack_)) return false;
  for (std::size_t i = 0; i < kept_.size(); ++i)
    if (!is_like(kept_[i], copies_[i])) return false;
  return true;
}

bool RoundFinder::sees(const void* place, Memory stack) {
  if (is_taken(place, stack)) return true;
  if (place_ && ++since_ < power_) return false;
  power_ *= 2;
  since_ = 0;
  take(place, stack);
  return false;
}

}  // namespace robosim::exec
