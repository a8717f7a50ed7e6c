// What of a sketch is outside of its folder: files that it shares with sketches beside it, and where links
// lead.
#pragma once

#include <filesystem>
#include <vector>

#include "sim/build/source.h"

namespace robosim::build {

/// How far a sketch may reach for code that it shares: the checkout that it is in (the nearest folder above
/// with a .git), else the folder that it stands in; only its own where that is the user's home, or above.
std::filesystem::path reach_of(const std::filesystem::path& sketch_folder);

/// Sources and headers within `reach`, outside of the sketch's folder, that its files include
/// ("../common/pid.h"), and that those include; and those that links in its folder lead to. Canonical.
std::vector<std::filesystem::path> shared_files(const Sketch& sketch, const std::filesystem::path& reach);

/// Whether a file, or what a link leads to, is below `folder`; false if there is none.
bool lies_in(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Throws InputError for a link in the folder that leads out of it.
void check_links(const std::filesystem::path& folder);

}  // namespace robosim::build
