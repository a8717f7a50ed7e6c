#include "sim/exec/host/kept_state.h"

#include <algorithm>
#include <cstring>

#include "sim/exec/host/under_asan.h"

namespace robosim::exec {
namespace {

#ifdef ROBOSIM_ASAN
// Whatever a sanitizer forbids to others: stacks and heaps have gaps that nobody may read.
__attribute__((no_sanitize("address"))) bool is_like_copy(KeptState::Memory memory,
                                                          const std::vector<std::byte>& copy) {
  if (memory.size() != copy.size()) return false;
  for (std::size_t i = 0; i < copy.size(); ++i)
    if (memory[i] != copy[i]) return false;
  return true;
}

__attribute__((no_sanitize("address"))) void copy(KeptState::Memory memory, std::vector<std::byte>& to) {
  to.resize(memory.size());
  for (std::size_t i = 0; i < memory.size(); ++i) to[i] = memory[i];
}
#else
bool is_like_copy(KeptState::Memory memory, const std::vector<std::byte>& copy) {
  return memory.size() == copy.size() &&
         (copy.empty() || std::memcmp(memory.data(), copy.data(), copy.size()) == 0);
}

void copy(KeptState::Memory memory, std::vector<std::byte>& to) {
  to.resize(memory.size());
  if (!to.empty()) std::memcpy(to.data(), memory.data(), to.size());
}
#endif

}  // namespace

KeptState::KeptState(const LoadedImage& image) {
  const auto* const begin = reinterpret_cast<const std::byte*>(image.entry().clockwork_begin);
  const auto* const end = reinterpret_cast<const std::byte*>(image.entry().clockwork_end);
  for (const MemoryRange& variables : image.variables()) {
    if (begin < variables.begin || end > variables.end) {
      variables_.push_back({variables.begin, variables.end});
      continue;
    }
    variables_.push_back({variables.begin, begin});
    variables_.push_back({end, variables.end});
  }
  copies_.resize(variables_.size());
}

void KeptState::take(Memory heap, Memory stack) {
  copy(heap, heap_);
  copy(stack, stack_);
  for (std::size_t i = 0; i < variables_.size(); ++i) copy(variables_[i], copies_[i]);
}

bool KeptState::is_like(Memory heap, Memory stack) const {
  if (!is_like_copy(stack, stack_) || !is_like_copy(heap, heap_)) return false;
  for (std::size_t i = 0; i < variables_.size(); ++i)
    if (!is_like_copy(variables_[i], copies_[i])) return false;
  return true;
}

KeptState::Memory used_heap(const host::FirmwareState& state) {
  constexpr std::size_t kPage = 4096;
  const std::size_t whole = (state.heap_used + kPage - 1) / kPage * kPage;
  return {reinterpret_cast<const std::byte*>(state.heap), std::min(whole, state.heap_bytes)};
}

}  // namespace robosim::exec
