// What another parser than the compiler needs to read a sketch as it is compiled.
#pragma once

#include <string>
#include <vector>

#include "sim/build/sketch.h"
#include "sim/build/source.h"

namespace robosim::build {

struct Reading {
  Sketch sketch;
  std::vector<std::string> words;  ///< as a C++ compiler has them: the language, macros, folders of headers
};

/// Builds the sketch first, for the host or an AVR, so that it is one that compiles. Throws as build() does.
Reading reading_of(const Request& request);

}  // namespace robosim::build
