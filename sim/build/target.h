// Describes as data how the targets of sketches differ: programs, flags, and the way to link objects. The
// steps from a sketch to its image (build.cpp) are the same for all targets.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace robosim::build {

/// A program, and the Debian package that contains it.
struct Program {
  const char* name;
  const char* package;
};

/// A further file that a program makes from the linked image: `program arguments IMAGE FILE`.
struct Product {
  const char* ending;
  Program program;
  std::vector<std::string> arguments;
};

/// Additional options for the run-time checks of --sanitize; empty = the target has no checks.
struct Sanitizer {
  std::vector<std::string> undefined;    ///< checks of the sketch and its libraries
  std::vector<std::string> addresses;    ///< also for the core, except the code that the checks call
  std::vector<std::string> definitions;  ///< for the code that the checks call
  std::vector<std::string> link;
  /// Warnings about the sketch itself that the compiler can give only with these options. They are added to
  /// the compiler's standard warnings.
  std::vector<std::string> warnings = {};
};

/// Additional options to count the lines that ran; empty = the target cannot count.
struct Counting {
  std::vector<std::string> own;          ///< for the sketch's own sources
  std::vector<std::string> definitions;  ///< for the core
  std::vector<std::string> link;
};

struct Target {
  const char* name;
  const char* image_ending;
  Program cxx;
  Program cc;
  Program archiver;  ///< null = the core is one object file
  bool native;       ///< compiles for the machine that Robosim itself runs on
  bool chip;         ///< the image is for the board's chip, otherwise for a runner
  /// The folder in hal that forms the core together with hal/arduino. Null = the whole genuine core, with its
  /// libraries.
  const char* hal;

  // Compiler options. `own` is for the sketch and its libraries, `core` for the Arduino core.
  std::vector<std::string> code;
  std::vector<std::string> cxx_code;
  std::vector<std::string> c_code;
  std::vector<std::string> own;
  const char* own_level;
  /// Options added to `own`: `memory` if registers are bytes in memory (Registers, toolchain.h), and also
  /// `as_avr` if the code is compiled as for an AVR. Both are empty if the target has the chip's registers.
  std::vector<std::string> memory;
  std::vector<std::string> as_avr;
  Sanitizer sanitizer;
  Counting coverage;
  std::vector<std::string> core;
  const char* core_level;
  std::vector<std::string> definitions;
  const char* prefix_map;  ///< the option that removes names of this machine's folders: `OPTION=FROM=TO`

  std::vector<std::string> link;
  /// Names and texts of the files that `link` mentions.
  std::vector<std::pair<const char*, const char*>> link_files;
  std::vector<Product> products;
};

/// Returns the target. Throws InputError with a list of the existing targets.
const Target& find_target(const std::string& name);

}  // namespace robosim::build
