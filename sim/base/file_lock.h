// Ensures that a file has one writer at a time. Each writer locks the file first.
#pragma once

#include <filesystem>

#include "sim/base/descriptor.h"

namespace robosim {

/// Throws InputError if the file clearly cannot be written later: its folder is missing, or is not writable.
void check_can_be_written(const std::filesystem::path& file);

/// Holds a lock on a file. As long as this object exists, no other process on this machine can lock the file,
/// even by another path. The lock is the name of an abstract Linux socket. The lock therefore always ends
/// with its process, and leaves no files. Devices and pipes, which may have several writers, are not locked.
class FileLock {
 public:
  /// Locks a file, which need not exist yet. Throws InputError if another process is writing the file, or if
  /// check_can_be_written() throws.
  explicit FileLock(const std::filesystem::path& file);

 private:
  Descriptor name_;
};

}  // namespace robosim
