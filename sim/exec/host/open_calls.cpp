#include "sim/exec/host/open_calls.h"

#include <unwind.h>

namespace robosim::exec {
namespace {

constexpr std::size_t kMostAddresses = 40;  // limit of addresses that are looked up for one source line

// Returns the word on the stack at `address`, even where a sanitizer forbids access.
__attribute__((no_sanitize("address"))) const void* word_at(const std::byte* address) {
  const void* word = nullptr;
  __builtin_memcpy(&word, address, sizeof word);
  return word;
}

struct Walk {
  const LoadedImage& image;
  std::vector<CodeAddress>& addresses;
  bool inside = false, through = false;
};

_Unwind_Reason_Code step(_Unwind_Context* frame, void* data) {
  Walk& walk = *static_cast<Walk*>(data);
  const auto* const pc = reinterpret_cast<const void*>(_Unwind_GetIP(frame));
  const bool inside = walk.image.has_code(pc);
  walk.through = walk.inside && !inside;
  if (walk.through) return _URC_END_OF_STACK;
  walk.inside = inside;
  if (inside) walk.addresses.push_back({pc, true});
  return walk.addresses.size() < kMostAddresses ? _URC_NO_REASON : _URC_END_OF_STACK;
}

}  // namespace

void OpenCalls::add_stack(const std::byte* from, std::vector<CodeAddress>& addresses) const {
  constexpr int kMostWords = 4096;
  const auto misaligned = reinterpret_cast<std::uintptr_t>(from) % sizeof(void*);
  from -= misaligned;
  if (!stack_.contains(from)) return;
  for (int i = 0; i < kMostWords && addresses.size() < kMostAddresses; ++i, from += sizeof(void*)) {
    if (from + sizeof(void*) > stack_.end()) return;
    const void* const word = word_at(from);
    if (image_.has_code(word)) addresses.push_back({word, true});
  }
}

void OpenCalls::add_callers(std::vector<CodeAddress>& addresses) const {
  Walk walk{image_, addresses};
  _Unwind_Backtrace(step, &walk);
  if (!walk.through) add_stack(static_cast<const std::byte*>(__builtin_frame_address(0)), addresses);
}

}  // namespace robosim::exec
