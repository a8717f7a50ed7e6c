// Lets the AVR's compiler look at a sketch that is built for the host. Only this
// compiler reports that 4 * 10000 overflows, because an AVR's int has 16 bits.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/build/compile.h"
#include "sim/build/source.h"
#include "sim/build/toolchain.h"

namespace robosim::build {

class WidthCheck {
 public:
  /// Returns the check for a build with this toolchain; null if the build needs none, or the AVR's compiler
  /// is not installed. A build for the host needs the check if it shows warnings and the board has an AVR.
  static std::unique_ptr<const WidthCheck> of(const Toolchain& host, const GenuineCore& core,
                                              const std::filesystem::path& cache);

  /// Returns a command that checks the unit without compiling it. `unit` is a unit of the host's build. The
  /// command may fail, because a sketch may be for the host only.
  Command command(const Unit& unit, const std::filesystem::path& scratch) const;

  /// Returns the warnings in the command's output that depend on the width of int and are about the sketch's
  /// own files. Skips lines for which the host's compiler has such a warning, too.
  std::string warnings(const Sketch& sketch, const std::string& output,
                       const std::string& host_messages) const;

 private:
  explicit WidthCheck(Toolchain avr) : avr_(std::move(avr)) {}
  Toolchain avr_;
};

/// Returns the identity of the AVR's compiler, which affects a build with a WidthCheck. Returns an empty text
/// for other builds.
std::string width_check_identity(const Toolchain& host);

}  // namespace robosim::build
