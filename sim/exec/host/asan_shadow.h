// Maps the shadow memory of address checks (hal/host/addresses.h), but only for memory that firmware may
// access. gcc's own runtime would reserve 16 TB.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace robosim::exec {

struct MemoryRange {
  const std::byte* begin;
  const std::byte* end;
};

/// The shadow is initially all zero, which permits all accesses. If Robosim itself runs under
/// AddressSanitizer, the shadow exists already, and is restored at the end.
class ShadowMemory {
 public:
  /// `offset` is host::Image::shadow; 0 = no shadow. Throws std::runtime_error if the shadow's address range
  /// is in use.
  ShadowMemory(std::uintptr_t offset, std::vector<MemoryRange> memory);
  ~ShadowMemory();
  ShadowMemory(const ShadowMemory&) = delete;
  ShadowMemory& operator=(const ShadowMemory&) = delete;

 private:
  std::vector<MemoryRange> memory_;
  std::vector<std::uintptr_t> pages_;
};

}  // namespace robosim::exec
