#include "sim/runner/known_hash.h"

#include <sys/stat.h>

#include <array>
#include <map>

#include "sim/base/file.h"

namespace robosim::runner {
namespace {

/// What changes when the content does.
using Stamp = std::array<long long, 7>;

Stamp stamp_of(const std::filesystem::path& file) {
  struct stat s {};
  if (::stat(file.c_str(), &s) != 0) return {};
  return {static_cast<long long>(s.st_dev),
          static_cast<long long>(s.st_ino),
          s.st_size,
          s.st_mtim.tv_sec,
          s.st_mtim.tv_nsec,
          s.st_ctim.tv_sec,
          s.st_ctim.tv_nsec};
}

struct Known {
  Stamp stamp;
  std::string sha256;
};

}  // namespace

const std::string& known_sha256(const std::filesystem::path& file) {
  static std::map<std::filesystem::path, Known> all;
  const Stamp stamp = stamp_of(file);
  Known& known = all[file];
  if (known.sha256.empty() || known.stamp != stamp) known = {stamp, sha256_of_file(file)};
  return known.sha256;
}

}  // namespace robosim::runner
