// Lists the open calls of firmware, the innermost first.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/exec/host/fiber.h"
#include "sim/exec/host/image_file.h"

namespace robosim::exec {

class OpenCalls {
 public:
  /// Both outlive this.
  OpenCalls(const LoadedImage& image, const GuardedMemory& stack) : image_(image), stack_(stack) {}

  /// Adds the callers. Called on the fiber, from within one of them. Uses the unwind tables; where they lead
  /// no further, also words on the stack that look like calls.
  void add_callers(std::vector<CodeAddress>& addresses) const;
  /// Adds return addresses on the stack from `from` on. Old ones in unused slots may be among them.
  void add_stack(const std::byte* from, std::vector<CodeAddress>& addresses) const;

 private:
  const LoadedImage& image_;
  const GuardedMemory& stack_;
};

}  // namespace robosim::exec
