#include "hal/host/addresses.h"

#ifdef ROBOSIM_SANITIZE

#include <string.h>

#include "hal/host/clock.h"

extern "C" {
extern const char __ehdr_start[] __attribute__((visibility("hidden")));
extern const char _end[] __attribute__((visibility("hidden")));
}

namespace robosim {
namespace host {
namespace {

constexpr uintptr_t kGrain = 8;

uint8_t* shadow_of(uintptr_t address) { return reinterpret_cast<uint8_t*>(address / kGrain + kShadow); }

bool is_in(uintptr_t address, const void* begin, uintptr_t bytes) {
  return address - reinterpret_cast<uintptr_t>(begin) < bytes;
}

/// Returns whether the address has shadow memory: it is in the image, the stack or the heap.
bool is_ours(uintptr_t address) {
  return is_in(address, state.stack, state.stack_bytes) ||
         is_in(address, __ehdr_start, static_cast<uintptr_t>(_end - __ehdr_start)) ||
         is_in(address, state.heap, state.heap_bytes);
}

bool is_allowed(uintptr_t address) {
  const uint8_t mark = *shadow_of(address);
  return mark == 0 || (mark < kGrain && address % kGrain < mark);
}

__attribute__((noinline, noreturn)) void report(uintptr_t address, size_t bytes, bool write, uintptr_t first,
                                                const void* where) {
  BadAccess access;
  access.address = address;
  access.bytes = bytes;
  access.write = write;
  access.first = first;
  if (is_ours(first)) {
    // A mark of 1..7 means that an object ends within these 8 bytes. The next mark has the object's kind.
    const uint8_t* mark = shadow_of(first);
    access.mark = *mark < kGrain ? mark[1] : *mark;
  }
  if (is_in(first, state.heap, state.heap_bytes)) {
    const HeapBlock block = block_around(first);
    access.block = block.begin;
    access.block_bytes = block.bytes;
  }
  executor->bad_access(access, where);
  __builtin_unreachable();
}

constexpr uintptr_t kNone = UINTPTR_MAX;

/// Returns the first address in the range that must not be accessed, or kNone.
uintptr_t first_forbidden(uintptr_t address, size_t bytes) {
  for (uintptr_t at = address; at - address < bytes;) {
    if (!is_ours(at) || !is_allowed(at)) return at;
    // If all of these 8 bytes are accessible, continues after them, else with the next byte.
    at = *shadow_of(at) == 0 ? (at / kGrain + 1) * kGrain : at + 1;
  }
  return kNone;
}

inline void check(uintptr_t address, size_t bytes, bool write, const void* where) {
  const uintptr_t first = first_forbidden(address, bytes);
  if (first == kNone) return;
  // Ignores null pointers: the processor's fault follows immediately, and its report has more details.
  constexpr uintptr_t kNullPage = 4096;
  if (first < kNullPage) return;
  report(address, bytes, write, first, where);
}

/// Checks an access by a function of the C library. The executor calls these functions, too, but with memory
/// outside of the image, which is not checked.
void check_ours(const void* begin, size_t bytes, bool write, const void* where) {
  const auto address = reinterpret_cast<uintptr_t>(begin);
  if (bytes > 0 && is_ours(address)) check(address, bytes, write, where);
}

/// Replaces the C library's strlen(), which has its own checks if Robosim runs under AddressSanitizer.
size_t length(const char* text, size_t most = SIZE_MAX) {
  const volatile char* at = text;
  size_t count = 0;
  while (count < most && at[count] != '\0') ++count;
  return count;
}

}  // namespace

// Writes the shadow byte by byte (volatile). memset() would check these writes if Robosim runs under ASan.
void allow(const void* begin, size_t bytes) {
  volatile uint8_t* shadow = shadow_of(reinterpret_cast<uintptr_t>(begin));
  for (; bytes >= kGrain; bytes -= kGrain) *shadow++ = 0;
  if (bytes > 0) *shadow = static_cast<uint8_t>(bytes);
}

void forbid(const void* begin, size_t bytes, uint8_t mark) {
  volatile uint8_t* shadow = shadow_of(reinterpret_cast<uintptr_t>(begin));
  for (; bytes >= kGrain; bytes -= kGrain) *shadow++ = mark;
}

void fill_unset(void* begin, size_t bytes) { memset(begin, 0xFE, bytes); }

}  // namespace host
}  // namespace robosim

using robosim::host::check;
using robosim::host::check_ours;
using robosim::host::length;

extern "C" {

#define ROBOSIM_ACCESS(size)                                                                    \
  void __asan_load##size(uintptr_t at) { check(at, size, false, __builtin_return_address(0)); } \
  void __asan_store##size(uintptr_t at) { check(at, size, true, __builtin_return_address(0)); }

ROBOSIM_ACCESS(1)
ROBOSIM_ACCESS(2)
ROBOSIM_ACCESS(4)
ROBOSIM_ACCESS(8)
ROBOSIM_ACCESS(16)
void __asan_loadN(uintptr_t at, size_t size) { check(at, size, false, __builtin_return_address(0)); }
void __asan_storeN(uintptr_t at, size_t size) { check(at, size, true, __builtin_return_address(0)); }

void __asan_init() {}
void __asan_version_mismatch_check_v8() {}
void __asan_before_dynamic_init(const char*) {}
void __asan_after_dynamic_init() {}
void __asan_unregister_globals(const void*, size_t) {}
// Does nothing: a function that does not return ends the firmware, so the stack's shadow may stay as it is.
void __asan_handle_no_return() {}

void __asan_register_globals(const robosim::host::GlobalRecord* globals, size_t count) {
  using namespace robosim::host;
  for (const GlobalRecord* global = globals; global < globals + count; ++global) {
    const auto* const begin = reinterpret_cast<const void*>(global->begin);
    forbid(begin, global->bytes_with_gap, kGlobalGap);
    allow(begin, global->bytes);
  }
  executor->globals(globals, count);
}

void __asan_poison_stack_memory(uintptr_t begin, size_t bytes) {
  using namespace robosim::host;
  forbid(reinterpret_cast<const void*>(begin), (bytes + kGrain - 1) / kGrain * kGrain, kOutOfScope);
}

void __asan_unpoison_stack_memory(uintptr_t begin, size_t bytes) {
  robosim::host::allow(reinterpret_cast<const void*>(begin), bytes);
}

void __asan_alloca_poison(uintptr_t begin, size_t bytes) {
  using namespace robosim::host;
  constexpr uintptr_t kGap = 32;
  const uintptr_t end = begin + bytes;
  const uintptr_t grain = end / kGrain * kGrain;
  const uintptr_t gap = (end + kGap - 1) / kGap * kGap;
  forbid(reinterpret_cast<const void*>(begin - kGap), kGap, kArrayBefore);
  forbid(reinterpret_cast<const void*>(grain), gap + kGap - grain, kArrayBehind);
  if (end > grain) allow(reinterpret_cast<const void*>(grain), end - grain);
}

void __asan_allocas_unpoison(uintptr_t top, uintptr_t bottom) {
  if (top != 0 && top <= bottom) robosim::host::allow(reinterpret_cast<const void*>(top), bottom - top);
}

// Check accesses by the C library, which is not instrumented. The linker redirects calls of the library's
// functions to the functions below (--wrap).
#define ROBOSIM_READ(begin, bytes) check_ours(begin, bytes, false, __builtin_return_address(0))
#define ROBOSIM_WRITE(begin, bytes) check_ours(begin, bytes, true, __builtin_return_address(0))

void* __real_memcpy(void*, const void*, size_t);
void* __real_memmove(void*, const void*, size_t);
void* __real_memset(void*, int, size_t);
int __real_memcmp(const void*, const void*, size_t);
char* __real_strcpy(char*, const char*);
char* __real_strncpy(char*, const char*, size_t);
char* __real_strcat(char*, const char*);
char* __real_strncat(char*, const char*, size_t);
int __real_strcmp(const char*, const char*);
int __real_strncmp(const char*, const char*, size_t);
char* __real_strchr(const char*, int);
char* __real_strstr(const char*, const char*);

void* __wrap_memcpy(void* to, const void* from, size_t bytes) {
  ROBOSIM_READ(from, bytes);
  ROBOSIM_WRITE(to, bytes);
  return __real_memcpy(to, from, bytes);
}

void* __wrap_memmove(void* to, const void* from, size_t bytes) {
  ROBOSIM_READ(from, bytes);
  ROBOSIM_WRITE(to, bytes);
  return __real_memmove(to, from, bytes);
}

void* __wrap_memset(void* to, int byte, size_t bytes) {
  ROBOSIM_WRITE(to, bytes);
  return __real_memset(to, byte, bytes);
}

int __wrap_memcmp(const void* a, const void* b, size_t bytes) {
  ROBOSIM_READ(a, bytes);
  ROBOSIM_READ(b, bytes);
  return __real_memcmp(a, b, bytes);
}

size_t __wrap_strlen(const char* text) {
  const size_t count = length(text);
  ROBOSIM_READ(text, count + 1);
  return count;
}

char* __wrap_strcpy(char* to, const char* from) {
  const size_t bytes = length(from) + 1;
  ROBOSIM_READ(from, bytes);
  ROBOSIM_WRITE(to, bytes);
  return __real_strcpy(to, from);
}

char* __wrap_strncpy(char* to, const char* from, size_t most) {
  const size_t count = length(from, most);
  ROBOSIM_READ(from, count < most ? count + 1 : most);
  ROBOSIM_WRITE(to, most);
  return __real_strncpy(to, from, most);
}

char* __wrap_strcat(char* to, const char* from) {
  const size_t bytes = length(from) + 1;
  const size_t had = length(to);
  ROBOSIM_READ(from, bytes);
  ROBOSIM_READ(to, had + 1);
  ROBOSIM_WRITE(to + had, bytes);
  return __real_strcat(to, from);
}

char* __wrap_strncat(char* to, const char* from, size_t most) {
  const size_t count = length(from, most);
  const size_t had = length(to);
  ROBOSIM_READ(from, count < most ? count + 1 : most);
  ROBOSIM_READ(to, had + 1);
  ROBOSIM_WRITE(to + had, count + 1);
  return __real_strncat(to, from, most);
}

int __wrap_strcmp(const char* a, const char* b) {
  size_t same = 0;
  while (a[same] == b[same] && a[same] != '\0') ++same;
  ROBOSIM_READ(a, same + 1);
  ROBOSIM_READ(b, same + 1);
  return __real_strcmp(a, b);
}

int __wrap_strncmp(const char* a, const char* b, size_t most) {
  size_t same = 0;
  while (same < most && a[same] == b[same] && a[same] != '\0') ++same;
  ROBOSIM_READ(a, same < most ? same + 1 : most);
  ROBOSIM_READ(b, same < most ? same + 1 : most);
  return __real_strncmp(a, b, most);
}

char* __wrap_strchr(const char* text, int c) {
  ROBOSIM_READ(text, length(text) + 1);
  return __real_strchr(text, c);
}

char* __wrap_strstr(const char* text, const char* part) {
  ROBOSIM_READ(text, length(text) + 1);
  ROBOSIM_READ(part, length(part) + 1);
  return __real_strstr(text, part);
}

}  // extern "C"

#endif  // ROBOSIM_SANITIZE
