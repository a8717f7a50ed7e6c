// Images that are in the cache: under which key, and what is made of them.
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

/// In keys: an untrusted sketch sees less.
const char* seen_by(const Toolchain& toolchain);
/// Of the image of a sketch whose libraries are looked for in `folders`.
std::string image_key(const Toolchain& toolchain, const Sketch& sketch,
                      const std::vector<std::filesystem::path>& folders);
/// Whether a unit's object goes into the cache: not that of the joined .ino files, nor one with notes beside
/// it.
bool is_cached(const Toolchain& toolchain, const Unit& unit);
std::string unit_key(const Toolchain& toolchain, const Unit& unit);
/// Of the notes of gcov on an image.
std::string notes_key(const Entry& entry);

/// What the entry of an image says, and the target's products, which are made if need be.
Image image_of(const Target& target, const Sketch& sketch, const Entry& entry, const Cache& cache,
               bool from_cache);

}  // namespace robosim::build
