// Checks the sources of a sketch with further compilers, which produce no program. Their warnings are shown
// with those of the build. There are two checks:
//
//   - The AVR's compiler checks a sketch that is built for the host, if the sketch's board has an AVR. An
//     AVR's int has 16 bits. Therefore only this compiler reports that 4 * 10000 overflows.
//   - The static analyser of the host's g++ checks a sketch that is built with --sanitize. It reports local
//     variables that may be used before they have a value. It knows which branches exclude each other.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/build/compile.h"
#include "sim/build/source.h"
#include "sim/build/toolchain.h"

namespace robosim::build {

/// A part of each warning about a variable that may be unset.
inline constexpr std::string_view kUnset = "may be used before it has a value";

class StaticCheck {
 public:
  struct Kind;

  StaticCheck(const Kind& kind, Toolchain checker) : kind_(kind), checker_(std::move(checker)) {}

  /// Returns a command that checks the unit. `unit` is a unit of the sketch's build. The command may fail,
  /// because its compiler may reject code that is accepted by the build's compiler.
  Command command(const Unit& unit, const std::filesystem::path& scratch) const;

  /// Returns the messages of this check in the command's output that concern the sketch's own files.
  /// Skips mistakes that the build's compiler has reported in `build_messages`.
  std::string warnings(const Sketch& sketch, const std::string& output,
                       const std::string& build_messages) const;

 private:
  const Kind& kind_;
  const Toolchain checker_;
};

/// Returns the checks of a build with this toolchain. Skips checks whose compiler is not installed.
std::vector<StaticCheck> static_checks(const Toolchain& build, const GenuineCore& core,
                                       const std::filesystem::path& cache);

/// Returns the identities of the checks' compilers. The result of the build depends on them.
std::string static_checks_identity(const Toolchain& build);

}  // namespace robosim::build
