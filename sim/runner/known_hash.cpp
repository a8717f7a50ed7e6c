#include "sim/runner/known_hash.h"

#include <map>

#include "sim/base/file.h"
#include "sim/runner/stamp.h"

namespace robosim::runner {
namespace {

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
