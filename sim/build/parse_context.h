// Provides options for another parser, such as clang's. With these options, it reads a sketch as the
// sketch's own compiler does.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/build/sketch.h"
#include "sim/build/source.h"

namespace robosim::build {

struct ParseContext {
  Sketch sketch;
  std::vector<std::string> words;  ///< options of a C++ compiler: the language, macros, folders of headers
  std::vector<std::filesystem::path> readable;  ///< files that a compiler can read (run_within())
};

/// Builds the sketch for the host or an AVR, to check that the sketch compiles, and returns the context.
/// Throws the exceptions of build().
ParseContext parse_context_of(const Request& request);

}  // namespace robosim::build
