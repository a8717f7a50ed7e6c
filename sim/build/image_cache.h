// Images in the cache: their keys, and the products made from them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/build/cache.h"
#include "sim/build/compile.h"
#include "sim/build/sketch.h"
#include "sim/build/source.h"
#include "sim/build/toolchain.h"

namespace robosim::build {

/// For keys: an untrusted sketch sees less.
const char* seen_by(const Toolchain& toolchain);
/// Returns the key of a sketch's image, with libraries from `folders`.
std::string image_key(const Toolchain& toolchain, const Sketch& sketch,
                      const std::vector<std::filesystem::path>& folders);
/// Returns whether a unit's object is cached: not that of the joined .ino files, nor one with a file of
/// notes.
bool is_cached(const Toolchain& toolchain, const Unit& unit);
std::string unit_key(const Toolchain& toolchain, const Unit& unit);
/// Returns the key of gcov's notes on an image.
std::string notes_key(const Entry& entry);

/// Returns the image of an entry, with the target's products, which are made if necessary.
Image image_of(const Target& target, const Sketch& sketch, const Entry& entry, const Cache& cache,
               bool from_cache);

}  // namespace robosim::build
