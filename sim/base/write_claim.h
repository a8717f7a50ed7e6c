// One writer for a file: whoever is going to write one says so first.
#pragma once

#include <filesystem>

#include "sim/base/descriptor.h"

namespace robosim {

/// From here to its end nobody else on this machine can claim the file, under whatever name. It ends with its
/// process, too, however that ends, and leaves nothing behind: the claim is a name of Linux's abstract
/// sockets. Devices and pipes, which any number may write, are not claimed.
class WriteClaim {
 public:
  /// Throws InputError if somebody else is writing the file. It need not be there yet.
  explicit WriteClaim(const std::filesystem::path& file);

 private:
  Descriptor name_;
};

}  // namespace robosim
