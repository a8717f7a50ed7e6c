// How the targets that sketches are compiled for differ, as data: programs, flags, and how objects are
// linked. The way from a sketch to its image (build.cpp) is the same for all.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace robosim::build {

/// A program, and the Debian package that brings it.
struct Program {
  const char* name;
  const char* package;
};

/// A further file made of the linked image: `program arguments IMAGE FILE`.
struct Product {
  const char* ending;
  Program program;
  std::vector<std::string> arguments;
};

/// What is added where checks are wanted; empty = the target has none.
struct Sanitizer {
  std::vector<std::string> undefined;    ///< checks of the sketch and its libraries
  std::vector<std::string> addresses;    ///< the same, and for the core, but for what serves the checks
  std::vector<std::string> definitions;  ///< for what serves the checks
  std::vector<std::string> link;
  /// What only this compilation can see; for the sketch itself, with the compiler's standard warnings.
  std::vector<std::string> warnings = {};
};

/// What is added to count the lines that ran; empty = the target cannot.
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
  /// The folder below hal that completes hal/arduino to a core; null = the genuine core, all of it, and its
  /// libraries.
  const char* hal;

  // Words for the compiler. `own` is for the sketch and its libraries, `core` for the Arduino core.
  std::vector<std::string> code;
  std::vector<std::string> cxx_code;
  std::vector<std::string> c_code;
  std::vector<std::string> own;
  const char* own_level;
  /// What is added to `own` where registers are memory (toolchain.h), and where it is an AVR's besides; empty
  /// = the chip's registers are the target's own.
  std::vector<std::string> memory;
  std::vector<std::string> as_avr;
  Sanitizer sanitizer;
  Counting coverage;
  std::vector<std::string> core;
  const char* core_level;
  std::vector<std::string> definitions;
  const char* prefix_map;  ///< the option that takes names of this machine out: `OPTION=FROM=TO`

  std::vector<std::string> link;
  /// Name and text of files that `link` names.
  std::vector<std::pair<const char*, const char*>> link_files;
  std::vector<Product> products;
};

/// Throws InputError, naming those there are.
const Target& find_target(const std::string& name);

}  // namespace robosim::build
