// Lists the calls of firmware that have not returned yet, innermost first.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/exec/host/fiber.h"
#include "sim/exec/host/image_file.h"

namespace robosim::exec {

class OpenCalls {
 public:
  /// Both arguments must outlive this object.
  OpenCalls(const LoadedImage& image, const GuardedMemory& stack) : image_(image), stack_(stack) {}

  /// Adds the callers of the running function. Must be called on the fiber. Uses the unwind tables. If these
  /// do not lead out of the firmware, also adds words on the stack that look like return addresses.
  void add_callers(std::vector<CodeAddress>& addresses) const;
  /// Adds the return addresses on the stack from `from` on. Some of these may be old addresses in unused
  /// bytes of the stack.
  void add_stack(const std::byte* from, std::vector<CodeAddress>& addresses) const;

 private:
  const LoadedImage& image_;
  const GuardedMemory& stack_;
};

}  // namespace robosim::exec
