#include "sim/build/walls.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <utility>

#include "sim/base/file_scope.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kRead =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kAll = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;  // of version 1, which each has
constexpr std::uint64_t kOfFiles =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE;
constexpr std::uint64_t kTruncate = 1u << 14;  // version 3

constexpr const char* kSystem[] = {"/usr",
                                   "/lib",
                                   "/lib64",
                                   "/bin",
                                   "/opt",
                                   "/nix",
                                   "/etc/ld.so.cache",
                                   "/etc/ld.so.preload",
                                   "/etc/alternatives",
                                   "/dev/urandom"};

/// 0 where there is none.
long version() {
  return std::max(0l, ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION));
}

void allow(int rules, const fs::path& path, std::uint64_t what) {
  const Descriptor place = open_to_show(path);
  struct stat facts {};
  if (!place.is_open() || ::fstat(place.get(), &facts) != 0) return;
  if (!S_ISDIR(facts.st_mode)) what &= kOfFiles | kTruncate;
  landlock_path_beneath_attr rule{};
  rule.allowed_access = what;
  rule.parent_fd = place.get();
  ::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
}

/// What goes on in spite of the signal at `most` is killed a little later.
bool limit(int what, rlim_t most, rlim_t more = 0) {
  rlimit now{};
  ::getrlimit(static_cast<__rlimit_resource_t>(what), &now);
  now.rlim_max = std::min(now.rlim_max, most + more);
  now.rlim_cur = std::min({now.rlim_cur, now.rlim_max, most});
  return ::setrlimit(static_cast<__rlimit_resource_t>(what), &now) == 0;
}

}  // namespace

Walls::Walls(const std::vector<fs::path>& read, fs::path scratch) : scratch_(std::move(scratch)) {
  const long known = version();
  if (known == 0) {
    if (!NamespaceWalls::possible()) return;
    std::vector<fs::path> all(std::begin(kSystem), std::end(kSystem));
    all.insert(all.end(), read.begin(), read.end());
    own_files_.emplace(all, std::vector<fs::path>{scratch_, "/dev/null"});
    return;
  }
  const std::uint64_t all = kAll | (known >= 3 ? kTruncate : 0);
  landlock_ruleset_attr handled{};
  handled.handled_access_fs = all;
  rules_ = Descriptor(static_cast<int>(
      ::syscall(SYS_landlock_create_ruleset, &handled, sizeof handled.handled_access_fs, 0)));
  if (!rules_.is_open()) return;
  for (const char* path : kSystem) allow(rules_.get(), path, kRead);
  for (const fs::path& path : read) allow(rules_.get(), path, kRead);
  allow(rules_.get(), scratch_, all);
  allow(rules_.get(), "/dev/null", all);
}

bool Walls::enter(const char* folder) const {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit(RLIMIT_CPU, kCompileSeconds, 5);
  limit(RLIMIT_DATA, kCompileBytes);
  limit(RLIMIT_FSIZE, kCompileBytes);
  limit(RLIMIT_CORE, 0);
  if (own_files_ && !own_files_->enter()) return false;
  if (::chdir(folder) != 0) return false;
  if (own_files_) return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
  if (!rules_.is_open()) return true;
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         ::syscall(SYS_landlock_restrict_self, rules_.get(), 0) == 0;
}

std::string Walls::missing() {
  if (version() > 0) return "";
  const bool off = errno == EOPNOTSUPP;
  if (NamespaceWalls::possible()) return "";
  return std::string(off ? "Landlock is switched off in this kernel" : "the kernel has no Landlock") +
         ", and namespaces of users are not allowed";
}

}  // namespace robosim::build
