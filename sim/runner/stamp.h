// Identity and state of a file, to detect without reading it that it is unchanged.
#pragma once

#include <array>
#include <filesystem>

namespace robosim::runner {

/// Identity, size and times. Two stamps differ if the content does, unless it was written twice within the
/// resolution of the file system's times. All zero if there is no such file.
using Stamp = std::array<long long, 7>;

/// Returns the size of the file in bytes.
constexpr long long size_in(const Stamp& stamp) { return stamp[2]; }

Stamp stamp_of(const std::filesystem::path& file);

/// Returns whether a stamp taken at `now` (ns since 1970) is so old that any later write changes it.
bool is_settled(const Stamp& stamp, long long now);

}  // namespace robosim::runner
