// Identifies a file and its state, in order to detect an unchanged file without reading it.
#pragma once

#include <array>
#include <filesystem>

namespace robosim::runner {

/// Device, inode, size and times of a file; all zero if the file does not exist. If the content of a file has
/// changed, its identity has changed. The exception is a file that was written twice within the resolution of
/// the file system's times.
using FileIdentity = std::array<long long, 7>;

/// Returns the size of the file in bytes.
constexpr long long size_in(const FileIdentity& identity) { return identity[2]; }

FileIdentity identity_of(const std::filesystem::path& file);

/// Returns whether any later write will change this identity: the file's times are older than `now` by more
/// than the resolution of these times. `now` is the time at which the identity was read, in ns since 1970.
bool is_settled(const FileIdentity& identity, long long now);

}  // namespace robosim::runner
