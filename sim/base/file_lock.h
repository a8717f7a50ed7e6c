// Ensures that a file has one writer at a time. A writer locks the file first.
#pragma once

#include <filesystem>

#include "sim/base/descriptor.h"

namespace robosim {

/// Throws InputError if the file plainly cannot be written later: its folder is missing, or is not writable.
void check_can_be_written(const std::filesystem::path& file);

/// Holds a lock, during which no other process on this machine can lock the file, under whatever name. The
/// lock is a name of Linux's abstract sockets. So it ends with its process, however that ends, and leaves
/// nothing behind. Devices and pipes, which may have several writers, are not locked.
class FileLock {
 public:
  /// Locks a file, which need not exist yet. Throws InputError if another process is writing it, and as
  /// check_can_be_written() does.
  explicit FileLock(const std::filesystem::path& file);

 private:
  Descriptor name_;
};

}  // namespace robosim
