// Address checks: which bytes of an image with checks may be accessed. gcc's AddressSanitizer calls
// before every access of the sketch, its libraries and the core; what it calls is in addresses.cpp. gcc's own
// runtime is not used: it would have to be the first library in the process, and ends the process.
//
// One byte of the shadow stands for 8 bytes of memory: 0 = all may be accessed, 1..7 = so many of them, from
// 0x80 on = none, and why. It lies where gcc expects it, since functions write the shadow of their own frames
// themselves.
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

// Marks of our own and of gcc's code for a function's frame, as LLVM's compiler-rt numbers them.
constexpr uint8_t kStackBefore = 0xF1;
constexpr uint8_t kStackBetween = 0xF2;
constexpr uint8_t kStackBehind = 0xF3;
constexpr uint8_t kOutOfScope = 0xF8;
constexpr uint8_t kGlobalGap = 0xF9;
constexpr uint8_t kHeapGap = 0xFA;
constexpr uint8_t kHeapFreed = 0xFD;
constexpr uint8_t kArrayBefore = 0xCA;  // of an array whose length is known only at run time
constexpr uint8_t kArrayBehind = 0xCB;

/// A block of the heap: what malloc was asked for.
struct HeapBlock {
  uintptr_t begin;
  size_t bytes;
};
/// The last block that begins at or before the address, in use or given back; all zero if there is none.
HeapBlock block_around(uintptr_t address);

#ifdef ROBOSIM_SANITIZE
/// `begin` is a multiple of 8. A last piece of less than 8 bytes is marked by its length.
void allow(const void* begin, size_t bytes);
/// `begin` and `bytes` are multiples of 8.
void forbid(const void* begin, size_t bytes, uint8_t mark);
/// Bytes that have not been set yet hold the same pattern as local variables
/// (-ftrivial-auto-var-init=pattern).
void fill_unset(void* begin, size_t bytes);
#else
inline void allow(const void*, size_t) {}
inline void forbid(const void*, size_t, uint8_t) {}
inline void fill_unset(void*, size_t) {}
#endif

}  // namespace host
}  // namespace robosim
