#include "sim/runner/known_hash.h"

#include <map>

#include "sim/base/file.h"
#include "sim/runner/file_identity.h"

namespace robosim::runner {
namespace {

struct Known {
  FileIdentity identity;
  std::string sha256;
};

}  // namespace

const std::string& known_sha256(const std::filesystem::path& file) {
  static std::map<std::filesystem::path, Known> all;
  const FileIdentity identity = identity_of(file);
  Known& known = all[file];
  if (known.sha256.empty() || known.identity != identity) known = {identity, sha256_of_file(file)};
  return known.sha256;
}

}  // namespace robosim::runner
