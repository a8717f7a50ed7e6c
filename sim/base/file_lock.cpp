#include "sim/base/file_lock.h"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <string>
#include <system_error>

#include "sim/base/error.h"
#include "sim/base/file.h"

namespace robosim {
namespace fs = std::filesystem;

void check_can_be_written(const fs::path& file) {
  std::error_code error;
  const fs::file_status there = fs::status(file, error);
  if (fs::is_directory(there))
    throw InputError({file.string()}, "cannot be written: expected the name of a file, got a folder");
  if (fs::exists(there) && !fs::is_regular_file(there)) return;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
    throw InputError({file.string()},
                     fmt::format("cannot be written: the folder {} does not exist; create it "
                                 "first",
                                 folder.string()));
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw InputError({file.string()}, fmt::format("cannot be written: {}", std::strerror(errno)));
}

FileLock::FileLock(const fs::path& file) {
  check_can_be_written(file);
  std::error_code error;
  const fs::file_status there = fs::status(file, error);
  if (fs::exists(there) && !fs::is_regular_file(there)) return;
  const fs::path whole = fs::weakly_canonical(fs::absolute(file, error), error);
  name_ = Descriptor(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = "robosim writes " + sha256(whole.string());
  std::memcpy(address.sun_path + 1, name.data(), name.size());  // a name after a 0 byte is abstract
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  // Ignores other failures: without sockets, files are written without a lock.
  if (::bind(name_.get(), reinterpret_cast<const sockaddr*>(&address), size) != 0 && errno == EADDRINUSE)
    throw InputError(
        {file.string()},
        "this file is already being written by another robosim, or by another option of this command; "
        "name another file, or wait until the other robosim has ended");
}

}  // namespace robosim
