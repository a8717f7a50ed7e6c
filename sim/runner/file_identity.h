// Identifies a file and its state, in order to detect an unchanged file without reading it.
#pragma once

#include <array>
#include <filesystem>

namespace robosim::runner {

/// Identity, size and times of a file. Identities differ if the content differs, unless the file was written
/// twice within the resolution of the file system's times. All zero if there is no such file.
using FileIdentity = std::array<long long, 7>;

/// Returns the size of the file in bytes.
constexpr long long size_in(const FileIdentity& identity) { return identity[2]; }

FileIdentity identity_of(const std::filesystem::path& file);

/// Returns whether an identity read at `now` (ns since 1970) is so old that any later write changes it.
bool is_settled(const FileIdentity& identity, long long now);

}  // namespace robosim::runner
