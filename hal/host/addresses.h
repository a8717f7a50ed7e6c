// Checks memory accesses of an image that is built with checks (--sanitize). gcc's AddressSanitizer inserts
// calls of functions in addresses.cpp before every access by the sketch, its libraries and the core. gcc's
// own library for these calls is not used, for two reasons: it must be the first library of the process, and
// it ends the process at a finding.
//
// One shadow byte describes 8 bytes of memory: 0 = all are accessible, n = 1..7 = only the first n, 0x80 and
// above = none (the value is the reason). The shadow is at the address that gcc expects, because instrumented
// functions write the shadow of their own stack frames.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace robosim {
namespace host {

#ifndef ROBOSIM_SANITIZE
constexpr uintptr_t kShadow = 0;
#elif defined(__x86_64__)
constexpr uintptr_t kShadow = 0x7FFF8000;
#elif defined(__aarch64__)
constexpr uintptr_t kShadow = uintptr_t{1} << 36;
#else
constexpr uintptr_t kShadow = uintptr_t{1} << 29;
#endif

// Marks: shadow bytes of inaccessible memory. They are set by Robosim, or by gcc's code for a stack frame.
// The values are those of LLVM's compiler-rt.
constexpr uint8_t kStackBefore = 0xF1;
constexpr uint8_t kStackBetween = 0xF2;
constexpr uint8_t kStackBehind = 0xF3;
constexpr uint8_t kOutOfScope = 0xF8;
constexpr uint8_t kGlobalGap = 0xF9;
constexpr uint8_t kHeapGap = 0xFA;
constexpr uint8_t kHeapFreed = 0xFD;
constexpr uint8_t kArrayBefore = 0xCA;  // an array whose length is known only at run time
constexpr uint8_t kArrayBehind = 0xCB;

/// A block of the heap, with the size requested from malloc().
struct HeapBlock {
  uintptr_t begin;
  size_t bytes;
};
/// Returns the last block, in use or freed, that begins at or before the address. Returns zeros if there is
/// no such block.
HeapBlock block_around(uintptr_t address);

#ifdef ROBOSIM_SANITIZE
/// Allows access to `bytes` bytes from `begin`, a multiple of 8. If fewer than 8 bytes remain at the end,
/// their shadow byte is their number.
void allow(const void* begin, size_t bytes);
/// Forbids access, with the reason `mark`. `begin` and `bytes` are multiples of 8.
void forbid(const void* begin, size_t bytes, uint8_t mark);
/// Fills uninitialised bytes with gcc's pattern for local variables (-ftrivial-auto-var-init=pattern).
void fill_unset(void* begin, size_t bytes);
#else
inline void allow(const void*, size_t) {}
inline void forbid(const void*, size_t, uint8_t) {}
inline void fill_unset(void*, size_t) {}
#endif

}  // namespace host
}  // namespace robosim
