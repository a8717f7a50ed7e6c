// Which file a name stands for, and as of when: to see without reading it that a file is as it was.
#pragma once

#include <array>
#include <filesystem>

namespace robosim::runner {

/// Identity, size and times: two of them differ where the content does, unless it was written twice within
/// the grain of the file system's times. All zero if there is no such file.
using Stamp = std::array<long long, 7>;

/// Of the file, bytes.
constexpr long long size_in(const Stamp& stamp) { return stamp[2]; }

Stamp stamp_of(const std::filesystem::path& file);

/// Whether a stamp that is taken at `now` (ns since 1970) is so much older that whoever writes to the file
/// from then on changes it.
bool is_settled(const Stamp& stamp, long long now);

}  // namespace robosim::runner
