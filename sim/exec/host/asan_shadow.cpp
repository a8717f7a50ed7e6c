#include "sim/exec/host/asan_shadow.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <map>
#include <stdexcept>

#include "sim/exec/host/asan_build.h"

namespace robosim::exec {

#ifdef ROBOSIM_ASAN

namespace {

void allow(const std::vector<MemoryRange>& memory) {
  for (const MemoryRange& range : memory)
    ASAN_UNPOISON_MEMORY_REGION(range.begin, static_cast<std::size_t>(range.end - range.begin));
}

}  // namespace

ShadowMemory::ShadowMemory(std::uintptr_t offset, std::vector<MemoryRange> memory) {
  if (offset != 0) memory_ = std::move(memory);
  allow(memory_);
}

ShadowMemory::~ShadowMemory() { allow(memory_); }

#else

namespace {

constexpr std::uintptr_t kShadowGrain = 8;
// Number of bytes below a range that also get a shadow. A function marks its stack frame in the shadow even
// if the frame overflows the stack.
constexpr std::uintptr_t kMargin = 64 * 1024;

/// Returns, for each page of the shadow, the number of memory ranges that use the page. Neighbouring ranges
/// may share a page.
std::map<std::uintptr_t, int>& holders() {
  static std::map<std::uintptr_t, int> pages;
  return pages;
}

std::size_t page_bytes() { return static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)); }

void hold(std::uintptr_t page) {
  if (holders()[page]++ > 0) return;
  void* const wanted = reinterpret_cast<void*>(page);
  void* const got = ::mmap(wanted, page_bytes(), PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_FIXED_NOREPLACE, -1, 0);
  if (got == wanted) return;
  if (got != MAP_FAILED) ::munmap(got, page_bytes());
  holders().erase(page);
  throw std::runtime_error(
      "accesses to memory cannot be checked: their shadow memory is already in use in this process");
}

void release(std::uintptr_t page) {
  if (--holders()[page] > 0) return;
  holders().erase(page);
  ::munmap(reinterpret_cast<void*>(page), page_bytes());
}

}  // namespace

ShadowMemory::ShadowMemory(std::uintptr_t offset, std::vector<MemoryRange> memory) {
  if (offset == 0) return;
  const std::uintptr_t page = page_bytes();
  for (const MemoryRange& range : memory) {
    const auto begin = (reinterpret_cast<std::uintptr_t>(range.begin) - kMargin) / kShadowGrain + offset;
    const auto end = reinterpret_cast<std::uintptr_t>(range.end) / kShadowGrain + offset;
    for (std::uintptr_t at = begin / page * page; at <= end; at += page) {
      hold(at);
      pages_.push_back(at);
    }
    // Clears the marks of memory that was mapped at this address earlier. These marks still exist if a
    // neighbouring range uses the same shadow page.
    const auto first = reinterpret_cast<std::uintptr_t>(range.begin) / kShadowGrain + offset;
    std::memset(reinterpret_cast<void*>(first), 0,
                static_cast<std::size_t>(range.end - range.begin) / kShadowGrain);
  }
}

ShadowMemory::~ShadowMemory() {
  for (const std::uintptr_t page : pages_) release(page);
}

#endif

}  // namespace robosim::exec
