// The parts of a sketch outside of its folder: files that it shares with sketches next to it, and the targets
// of links.
#pragma once

#include <filesystem>
#include <vector>

#include "sim/build/source.h"

namespace robosim::build {

/// Returns how far a sketch may reach for shared code: its checkout (the nearest folder above with a .git),
/// else its parent folder. If that is the user's home, or above, only the sketch's own folder.
std::filesystem::path reach_of(const std::filesystem::path& sketch_folder);

/// Returns sources and headers within `reach`, outside of the sketch's folder. Its files include them
/// ("../common/pid.h"), directly or not, or links in its folder lead there. Canonical.
std::vector<std::filesystem::path> shared_files(const Sketch& sketch, const std::filesystem::path& reach);

/// Returns whether a file, or a link's target, is below `folder`; false if there is none.
bool lies_in(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Throws InputError for a link in the folder that leads out of it.
void check_links(const std::filesystem::path& folder);

}  // namespace robosim::build
