// The differences between the targets that sketches are compiled for, as data: programs, flags, and the way
// to link objects. The steps from a sketch to its image (build.cpp) are the same for all.
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

/// A further file made from the linked image: `program arguments IMAGE FILE`.
struct Product {
  const char* ending;
  Program program;
  std::vector<std::string> arguments;
};

/// Additional options for checks; empty = the target has none.
struct Sanitizer {
  std::vector<std::string> undefined;    ///< checks of the sketch and its libraries
  std::vector<std::string> addresses;    ///< as above, and for the core, except the code that the checks call
  std::vector<std::string> definitions;  ///< for the code that the checks call
  std::vector<std::string> link;
  /// Warnings that need this compilation; for the sketch itself, with the compiler's standard warnings.
  std::vector<std::string> warnings = {};
};

/// Additional options to count the lines that ran; empty = the target cannot.
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
  bool chip;         ///< the image is for the board's chip, else for a runner
  /// The folder below hal that completes hal/arduino to a core; null = the whole genuine core, with its
  /// libraries.
  const char* hal;

  // Options for the compiler. `own` is for the sketch and its libraries, `core` for the Arduino core.
  std::vector<std::string> code;
  std::vector<std::string> cxx_code;
  std::vector<std::string> c_code;
  std::vector<std::string> own;
  const char* own_level;
  /// Added to `own` if registers are memory (toolchain.h), and for sketches compiled as for an AVR. Empty =
  /// the target has the chip's registers.
  std::vector<std::string> memory;
  std::vector<std::string> as_avr;
  Sanitizer sanitizer;
  Counting coverage;
  std::vector<std::string> core;
  const char* core_level;
  std::vector<std::string> definitions;
  const char* prefix_map;  ///< the option that removes names of this machine: `OPTION=FROM=TO`

  std::vector<std::string> link;
  /// Name and text of files that `link` names.
  std::vector<std::pair<const char*, const char*>> link_files;
  std::vector<Product> products;
};

/// Returns the target. Throws InputError, which lists the existing ones.
const Target& find_target(const std::string& name);

}  // namespace robosim::build
