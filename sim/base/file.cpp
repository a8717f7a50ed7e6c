#include "sim/base/file.h"

#include <fcntl.h>
#include <sha2.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <vector>

#include "sim/base/descriptor.h"
#include "sim/base/error.h"

// Defined in tests that toolchain/cmake/robosim_functions.cmake makes: the prefix of an installed Robosim; ""
// = none.
extern "C" const char* robosim_installation() __attribute__((weak));

namespace robosim {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const char* verb, int error) {
  throw InputError({path.string()}, std::string("cannot be ") + verb + ": " + std::strerror(error));
}

/// Of the installed Robosim whose libraries a program links that is not itself installed with it; else empty.
fs::path linked_installation() {
  return robosim_installation ? fs::path(robosim_installation()) : fs::path();
}

fs::path executable_folder() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path();
}

}  // namespace

std::string read_file(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) fail(path, "read", errno);
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) fail(path, "read", errno);
  if (S_ISDIR(info.st_mode)) fail(path, "read", EISDIR);
  std::string content(static_cast<std::size_t>(info.st_size), '\0');
  std::size_t got = 0;
  for (;;) {
    if (got == content.size()) content.resize(got + (S_ISREG(info.st_mode) ? 1 : 65536));
    const ssize_t n = ::read(file.get(), content.data() + got, content.size() - got);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path, "read", errno);
    if (n == 0) break;
    got += static_cast<std::size_t>(n);
  }
  content.resize(got);
  return content;
}

void write_file(const fs::path& path, std::string_view content) {
  const fs::path temporary = path.string() + ".tmp" + std::to_string(::getpid());
  {
    const Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (!file.is_open()) fail(path, "written", errno);
    while (!content.empty()) {
      const ssize_t n = ::write(file.get(), content.data(), content.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) {
        const int error = errno;
        ::unlink(temporary.c_str());
        fail(path, "written", error);
      }
      content.remove_prefix(static_cast<std::size_t>(n));
    }
  }
  std::error_code error;
  fs::rename(temporary, path, error);
  if (error) {
    ::unlink(temporary.c_str());
    fail(path, "written", error.value());
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
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) fail(path, "read", errno);
  SHA2_CTX context;
  SHA256Init(&context);
  std::vector<std::uint8_t> chunk(256 * 1024);
  for (;;) {
    const ssize_t n = ::read(file.get(), chunk.data(), chunk.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path, "read", errno);
    if (n == 0) break;
    SHA256Update(&context, chunk.data(), static_cast<std::size_t>(n));
  }
  char hex[SHA256_DIGEST_STRING_LENGTH];
  SHA256End(&context, hex);
  return hex;
}

fs::path data_folder() {
  if (const fs::path prefix = linked_installation(); !prefix.empty()) return prefix / "share/robosim";
  std::error_code error;
  const fs::path installed = executable_folder() / "../share/robosim";
  if (fs::is_directory(installed, error)) return fs::canonical(installed);
  const fs::path beside_helper = executable_folder() / "../../share/robosim";
  if (fs::is_directory(beside_helper, error)) return fs::canonical(beside_helper);
  return ROBOSIM_SOURCE_DIR;
}

fs::path helper_folder() {
  if (const fs::path prefix = linked_installation(); !prefix.empty()) return prefix / "libexec/robosim";
  std::error_code error;
  const fs::path installed = executable_folder() / "../libexec/robosim";
  if (fs::is_directory(installed, error)) return fs::canonical(installed);
  return ROBOSIM_HELPER_DIR;
}

}  // namespace robosim
