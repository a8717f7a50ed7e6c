// Maps the shadow memory that the address checks of firmware use (hal/host/addresses.h). The runtime of gcc's
// AddressSanitizer is not used, because it would reserve 16 TB of addresses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace robosim::exec {

struct MemoryRange {
  const std::byte* begin;
  const std::byte* end;
};

/// The shadow of some ranges of memory. Initially the shadow is all zero, which permits all accesses. If
/// Robosim itself runs under AddressSanitizer, the shadow exists already, and the destructor permits all
/// accesses again.
class ShadowMemory {
 public:
  /// Maps the shadow of `memory`. `offset` is host::Image::shadow; 0 = the image needs no shadow. Throws
  /// std::runtime_error if the shadow's address range is in use.
  ShadowMemory(std::uintptr_t offset, std::vector<MemoryRange> memory);
  ~ShadowMemory();
  ShadowMemory(const ShadowMemory&) = delete;
  ShadowMemory& operator=(const ShadowMemory&) = delete;

 private:
  std::vector<MemoryRange> memory_;
  std::vector<std::uintptr_t> pages_;
};

}  // namespace robosim::exec
