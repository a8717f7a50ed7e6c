// Finds the parts of a sketch outside its folder: files that it shares with neighbouring sketches, and the
// targets of links.
#pragma once

#include <filesystem>
#include <vector>

#include "sim/build/source.h"

namespace robosim::build {

/// Returns the folder within which a sketch may share code: the sketch's checkout (the nearest folder above
/// with a .git), or else its parent folder. If the sketch's own folder has a .git, returns the folder above
/// it. The user's home, and folders above it, do not count as checkouts. Without a checkout, if the parent
/// folder is the user's home or above, returns the sketch's own folder.
std::filesystem::path reach_of(const std::filesystem::path& sketch_folder);

/// Returns the canonical paths of shared files: sources and headers within `reach`, but outside the sketch's
/// folder. A file is shared if the sketch's files include it ("../common/pid.h"), directly or indirectly. A
/// file is also shared if a link in the sketch's folder leads to it.
std::vector<std::filesystem::path> shared_files(const Sketch& sketch, const std::filesystem::path& reach);

/// Returns whether a file, or a link's target, is below `folder`; false if the file does not exist.
bool lies_in(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Throws InputError if a sketch's folder is a link, or contains a link that leads out of the folder. Also
/// throws if a folder in the sketch's folder cannot be read.
void check_links(const std::filesystem::path& folder);

}  // namespace robosim::build
