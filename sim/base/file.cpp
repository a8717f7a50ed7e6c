#include "sim/base/file.h"

#include <fcntl.h>
#include <sha2.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/file_scope.h"

// Returns the prefix of an installed Robosim; "" = none. Defined only in tests built with
// toolchain/cmake/robosim_functions.cmake.
extern "C" const char* robosim_installation() __attribute__((weak));

namespace robosim {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const char* verb, int error) {
  throw InputError({path.string()}, std::string("cannot be ") + verb + ": " + std::strerror(error));
}

/// Returns the prefix of the installed Robosim that this test links; empty in Robosim's own programs.
fs::path linked_installation() {
  return robosim_installation ? fs::path(robosim_installation()) : fs::path();
}

fs::path executable_folder() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path();
}

fs::path find_data_folder() {
  if (const fs::path prefix = linked_installation(); !prefix.empty()) return prefix / "share/robosim";
  std::error_code error;
  const fs::path installed = executable_folder() / "../share/robosim";
  if (fs::is_directory(installed, error)) return fs::canonical(installed);
  const fs::path beside_helper = executable_folder() / "../../share/robosim";
  if (fs::is_directory(beside_helper, error)) return fs::canonical(beside_helper);
  return ROBOSIM_SOURCE_DIR;
}

fs::path find_helper_folder() {
  if (const fs::path prefix = linked_installation(); !prefix.empty()) return prefix / "libexec/robosim";
  std::error_code error;
  const fs::path installed = executable_folder() / "../libexec/robosim";
  if (fs::is_directory(installed, error)) return fs::canonical(installed);
  if (executable_folder().parent_path().filename() == "libexec")
    return executable_folder();  // this process is a helper
  return ROBOSIM_HELPER_DIR;
}

}  // namespace

Descriptor open_to_read(const fs::path& path) {
  Descriptor file = open_in_scope(path, O_RDONLY | O_NONBLOCK);  // O_NONBLOCK: does not wait for a writer
  check_is_file(file, path);
  return file;
}

void check_is_file(const Descriptor& file, const fs::path& path) {
  if (!file.is_open() && errno == EXDEV) throw out_of_scope(path);
  if (!file.is_open()) fail(path, "read", errno);
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) fail(path, "read", errno);
  if (S_ISDIR(info.st_mode)) fail(path, "read", EISDIR);
  if (!S_ISREG(info.st_mode)) {
    const char* what = S_ISFIFO(info.st_mode) ? "a pipe" : "a device";
    throw InputError({path.string()}, std::string("cannot be read: expected a file, got ") + what);
  }
}

std::string read_file(const fs::path& path, std::size_t most_bytes) {
  return read_file(open_to_read(path), path, most_bytes);
}

std::string read_file(const Descriptor& file, const fs::path& path, std::size_t most_bytes) {
  struct stat info {};
  ::fstat(file.get(), &info);
  std::string content;
  content.resize(std::min(static_cast<std::size_t>(info.st_size), most_bytes) + 1);
  std::size_t got = 0;
  for (;;) {
    if (got == content.size()) content.resize(got + 65536);
    const ssize_t n = ::read(file.get(), content.data() + got, content.size() - got);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path, "read", errno);
    if (n == 0) break;
    got += static_cast<std::size_t>(n);
    if (got > most_bytes)
      throw InputError({path.string()}, "the file is too large: expected at most " +
                                            std::to_string(most_bytes >> 10) + " KiB");
  }
  content.resize(got);
  return content;
}

namespace {

/// Returns the temporary name of a file that is being written, in the file's folder.
fs::path beside(const fs::path& path) { return path.string() + ".tmp" + std::to_string(::getpid()); }

/// Replaces a file like rename(), but without waiting for the disk. On ext4, rename() first writes the file
/// to the disk.
bool replace([[maybe_unused]] const fs::path& fresh, [[maybe_unused]] const fs::path& old) {
#ifdef RENAME_EXCHANGE
  const auto change_places = [&] {
    return ::renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, old.c_str(), RENAME_EXCHANGE) == 0;
  };
  if (!change_places()) return false;  // no old file, or no support by the file system
  if (::unlink(fresh.c_str()) == 0) return true;
  change_places();  // undo: `old` was a folder
#endif
  return false;
}

}  // namespace

void write_file(const fs::path& path, std::string_view content) {
  std::error_code error;
  const fs::file_status there = fs::status(path, error);
  const bool in_place = fs::exists(there) && !fs::is_regular_file(there) && !fs::is_directory(there);
  const fs::path target = in_place ? path : beside(path);
  try {
    // Removes a leftover temporary file. It may also be another user's link, which would lead elsewhere.
    if (!in_place) ::unlink(target.c_str());
    const int fresh = in_place ? O_TRUNC : O_EXCL | O_NOFOLLOW;
    const Descriptor file(::open(target.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | fresh, 0666));
    if (!file.is_open()) fail(path, "written", errno);
    if (const int problem = write_all(file.get(), content))
      throw std::system_error(problem, std::generic_category());
    if (!in_place) fs::rename(target, path);
  } catch (const std::system_error& problem) {
    if (!in_place) ::unlink(target.c_str());
    fail(path, "written", problem.code().value());
  }
}

void place_file(const Descriptor& unnamed, const fs::path& path, int error) {
  const fs::path target = beside(path);
  try {
    if (error != 0) throw std::system_error(error, std::generic_category());
    const std::string itself = "/proc/self/fd/" + std::to_string(unnamed.get());
    ::unlink(target.c_str());  // may be left by an earlier process with the same number
    if (::linkat(AT_FDCWD, itself.c_str(), AT_FDCWD, target.c_str(), AT_SYMLINK_FOLLOW) != 0)
      throw std::system_error(errno, std::generic_category());
    if (!replace(target, path)) fs::rename(target, path);
  } catch (const std::system_error& problem) {
    ::unlink(target.c_str());
    fail(path, "written", problem.code().value());
  }
}

std::string sha256(std::string_view bytes) {
  SHA2_CTX context;
  SHA256Init(&context);
  SHA256Update(&context, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  char hex[SHA256_DIGEST_STRING_LENGTH];
  SHA256End(&context, hex);
  return hex;
}

std::string sha256_of_file(const fs::path& path) {
  const Descriptor file = open_to_read(path);
  SHA2_CTX context;
  SHA256Init(&context);
  struct stat info {};
  ::fstat(file.get(), &info);
  // Limits the buffer to the file's size: most files are small, and clearing the buffer touches all its
  // pages.
  std::vector<std::uint8_t> chunk(
      std::clamp<std::size_t>(static_cast<std::size_t>(info.st_size), 1, 256 * 1024));
  for (;;) {
    const ssize_t n = ::read(file.get(), chunk.data(), chunk.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path, "read", errno);
    if (n == 0) break;
    SHA256Update(&context, chunk.data(), static_cast<std::size_t>(n));
  }
  ::explicit_bzero(chunk.data(), chunk.size());  // the file may be a program that later runs must not read
  char hex[SHA256_DIGEST_STRING_LENGTH];
  SHA256End(&context, hex);
  return hex;
}

const fs::path& data_folder() {
  static const fs::path folder = find_data_folder();
  return folder;
}

const fs::path& helper_folder() {
  static const fs::path folder = find_helper_folder();
  return folder;
}

}  // namespace robosim
