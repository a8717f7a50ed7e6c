// The options with which a parser other than the compiler reads a sketch as it is compiled.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/build/sketch.h"
#include "sim/build/source.h"

namespace robosim::build {

struct ParseContext {
  Sketch sketch;
  std::vector<std::string> words;  ///< a C++ compiler's: the language, macros, folders of headers
  std::vector<std::filesystem::path> readable;  ///< what a compiler sees of this machine (run_within())
};

/// Builds the sketch first, for the host or an AVR, to check that it compiles. Throws as build() does.
ParseContext parse_context_of(const Request& request);

}  // namespace robosim::build
