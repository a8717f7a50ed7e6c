// The only place where tests get folders for their files. Tests run in parallel, so each test has folders of
// its own: two tests with a file of the same name would overwrite each other's file.
#pragma once

#include <stdlib.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

namespace robosim::test {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "robosim-test-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), name);
    path_ = std::filesystem::canonical(name);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// Makes this process store its builds in a cache that all tests share, so that each sketch is compiled once.
/// Several processes can use the cache at the same time.
inline void use_shared_cache() {
  const std::filesystem::path cache = std::filesystem::temp_directory_path() / "robosim-test-cache";
  ::setenv("XDG_CACHE_HOME", cache.c_str(), 1);
}

}  // namespace robosim::test
