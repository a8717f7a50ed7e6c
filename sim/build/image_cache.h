// Defines the keys of cached images, and makes products, such as .hex files, from images.
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

/// Returns the part of a key that marks an untrusted sketch, whose compilers see fewer files.
const char* seen_by(const Toolchain& toolchain);
/// Returns the key of a sketch's image, with libraries from `folders`.
std::string image_key(const Toolchain& toolchain, const Sketch& sketch,
                      const std::vector<std::filesystem::path>& folders);
/// Returns whether a unit's object is cached. Objects of joined .ino files, and objects with gcov's
/// notes, are not cached.
bool is_cached(const Toolchain& toolchain, const Unit& unit);
std::string unit_key(const Toolchain& toolchain, const Unit& unit);
/// Returns the key of gcov's notes (.gcno) on an image.
std::string notes_key(const Entry& entry);

/// Returns the image of an entry. Makes the target's products if the cache does not have them.
Image image_of(const Target& target, const Sketch& sketch, const Entry& entry, const Cache& cache,
               bool from_cache);

}  // namespace robosim::build
