#include "sim/exec/host/firmware_snapshot.h"

#include <algorithm>
#include <cstring>

#include "sim/exec/host/asan_build.h"

namespace robosim::exec {
namespace {

#ifdef ROBOSIM_ASAN
// Compares memory even where a sanitizer forbids access, since parts of stacks and heaps are forbidden.
__attribute__((no_sanitize("address"))) bool is_like_copy(FirmwareSnapshot::Memory memory,
                                                          const std::vector<std::byte>& copy) {
  if (memory.size() != copy.size()) return false;
  for (std::size_t i = 0; i < copy.size(); ++i)
    if (memory[i] != copy[i]) return false;
  return true;
}

__attribute__((no_sanitize("address"))) void copy(FirmwareSnapshot::Memory memory,
                                                  std::vector<std::byte>& to) {
  to.resize(memory.size());
  for (std::size_t i = 0; i < memory.size(); ++i) to[i] = memory[i];
}
#else
bool is_like_copy(FirmwareSnapshot::Memory memory, const std::vector<std::byte>& copy) {
  return memory.size() == copy.size() &&
         (copy.empty() || std::memcmp(memory.data(), copy.data(), copy.size()) == 0);
}

void copy(FirmwareSnapshot::Memory memory, std::vector<std::byte>& to) {
  to.resize(memory.size());
  if (!to.empty()) std::memcpy(to.data(), memory.data(), to.size());
}
#endif

FirmwareSnapshot::Memory memory_of(const char* begin, const char* end) {
  return {reinterpret_cast<const std::byte*>(begin), reinterpret_cast<const std::byte*>(end)};
}

// Returns the used part of the heap, rounded up to whole pages. A faulty sketch may have written to the bytes
// that the rounding adds.
FirmwareSnapshot::Memory used_heap(const host::FirmwareState& state) {
  constexpr std::size_t kPage = 4096;
  const std::size_t whole = (state.heap_used + kPage - 1) / kPage * kPage;
  return {reinterpret_cast<const std::byte*>(state.heap), std::min(whole, state.heap_bytes)};
}

void leave_out(FirmwareSnapshot::Memory part, std::vector<FirmwareSnapshot::Memory>& of) {
  for (std::size_t i = 0; i < of.size(); ++i) {
    const FirmwareSnapshot::Memory whole = of[i];
    if (part.data() < whole.data() || part.data() + part.size() > whole.data() + whole.size()) continue;
    of[i] = {whole.begin(), part.begin()};
    of.emplace_back(part.end(), whole.end());
    return;
  }
}

}  // namespace

FirmwareSnapshot::FirmwareSnapshot(const LoadedImage& image) {
  const host::Image& entry = image.entry();
  settings_.memory = memory_of(entry.settings_begin, entry.settings_end);
  std::vector<Memory> all;
  for (const MemoryRange& variables : image.variables()) all.emplace_back(variables.begin, variables.end);
  leave_out(memory_of(entry.clockwork_begin, entry.clockwork_end), all);
  leave_out(settings_.memory, all);
  for (const Memory& memory : all)
    if (!memory.empty()) variables_.push_back({memory});
}

void FirmwareSnapshot::take(Memory heap, Memory stack) {
  copy(heap, heap_);
  copy(stack, stack_);
  copy(settings_.memory, settings_.copy);
  for (Part& part : variables_) copy(part.memory, part.copy);
}

bool FirmwareSnapshot::all_but_settings_are_like(Memory heap, Memory stack) const {
  if (!is_like_copy(stack, stack_) || !is_like_copy(heap, heap_)) return false;
  for (const Part& part : variables_)
    if (!is_like_copy(part.memory, part.copy)) return false;
  return true;
}

bool FirmwareSnapshot::is_like(Memory heap, Memory stack) const {
  return all_but_settings_are_like(heap, stack) && is_like_copy(settings_.memory, settings_.copy);
}

void FirmwareSnapshot::take(host::FirmwareState& state, Memory stack) {
  take(used_heap(state), stack);
  state.touched = false;
}

bool FirmwareSnapshot::is_like(host::FirmwareState& state, Memory stack) const {
  if (!all_but_settings_are_like(used_heap(state), stack)) return false;
  if (state.touched && !is_like_copy(settings_.memory, settings_.copy)) return false;
  state.touched = false;
  return true;
}

}  // namespace robosim::exec
