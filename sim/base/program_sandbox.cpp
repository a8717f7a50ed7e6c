#include "sim/base/program_sandbox.h"

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
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <utility>

#include "sim/base/file_scope.h"
#include "sim/base/refused_calls.h"

namespace robosim {
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kRead =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kAll = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;  // of Landlock 1: always supported
constexpr std::uint64_t kOfFiles =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE;
constexpr std::uint64_t kTruncate = 1u << 14;  // of Landlock 3

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

/// Returns the version of Landlock; 0 = no Landlock.
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

/// Limits a resource to `most`. A program that ignores the signal at `most` is killed at `most` + `more`.
bool limit(int what, rlim_t most, rlim_t more = 0) {
  rlimit now{};
  ::getrlimit(static_cast<__rlimit_resource_t>(what), &now);
  now.rlim_max = std::min(now.rlim_max, most + more);
  now.rlim_cur = std::min({now.rlim_cur, now.rlim_max, most});
  return ::setrlimit(static_cast<__rlimit_resource_t>(what), &now) == 0;
}

/// Returns the absolute folders of $PATH. Relative folders are unsafe, because the compiler works in the
/// sketch's folder.
std::vector<fs::path> program_folders() {
  const char* path = std::getenv("PATH");
  std::string_view rest = path && *path ? path : "/usr/local/bin:/usr/bin:/bin";
  std::vector<fs::path> folders;
  while (!rest.empty()) {
    const std::size_t colon = std::min(rest.find(':'), rest.size());
    if (fs::path folder = rest.substr(0, colon); folder.is_absolute()) folders.push_back(std::move(folder));
    rest.remove_prefix(std::min(colon + 1, rest.size()));
  }
  return folders;
}

/// Returns an environment that contains only PATH from the user's environment. A sketch could make the
/// compiler print other variables.
std::vector<std::string> bare_environment(const fs::path& scratch) {
  std::string path;
  for (const fs::path& folder : program_folders()) path += (path.empty() ? "" : ":") + folder.string();
  return {
      "PATH=" + path,        "HOME=" + scratch.string(), "TMPDIR=" + scratch.string(), "LC_ALL=C",
      "SOURCE_DATE_EPOCH=0", "CCACHE_DISABLE=1"};  // the compiler may be ccache, whose folder is not visible
}

std::vector<char*> null_ended(const std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (const std::string& text : texts) result.push_back(const_cast<char*>(text.c_str()));
  result.push_back(nullptr);
  return result;
}

}  // namespace

ProgramSandbox::ProgramSandbox(const std::vector<fs::path>& read, fs::path scratch)
    : scratch_(std::move(scratch)) {
  const long known = version();
  if (known == 0) {
    if (!NamespaceSandbox::possible()) return;
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

bool ProgramSandbox::enter(const char* folder, unsigned long bytes, int seconds) const {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit(RLIMIT_CPU, seconds, 5);
  limit(RLIMIT_DATA, bytes);
  limit(RLIMIT_FSIZE, kMadeBytes);
  limit(RLIMIT_CORE, 0);
  if (own_files_ && !own_files_->enter()) return false;
  if (::chdir(folder) != 0) return false;
  const bool is_sealed = ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
  if (is_sealed) refuse_needless_calls();
  if (!own_files_ && !rules_.is_open()) return true;
  return is_sealed && (own_files_ || ::syscall(SYS_landlock_restrict_self, rules_.get(), 0) == 0);
}

std::string ProgramSandbox::missing() {
  if (version() > 0) return "";
  const bool off = errno == EOPNOTSUPP;
  if (NamespaceSandbox::possible()) return "";
  return std::string(off ? "Landlock is switched off in this kernel" : "the kernel has no Landlock") +
         ", and user namespaces are not allowed";
}

/// Makes only async-signal-safe calls after the fork.
Child start_within(const ProgramSandbox& sandbox, const ChildStart& start, unsigned long bytes, int seconds) {
  constexpr int kCannotStart = 127;
  const std::vector<std::string> settings = bare_environment(sandbox.scratch());
  const std::vector<char*> words = null_ended(start.words), environment = null_ended(settings);
  return Child([&] {
    const int input = start.input >= 0 ? start.input : ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    const bool ready = ::dup2(input, STDIN_FILENO) == STDIN_FILENO &&
                       ::dup2(start.output, STDOUT_FILENO) == STDOUT_FILENO &&
                       ::dup2(start.errors, STDERR_FILENO) == STDERR_FILENO &&
                       sandbox.enter(start.folder.c_str(), bytes, seconds);
    if (ready) ::execve(words[0], words.data(), environment.data());
    return kCannotStart;
  });
}

std::string output_within(const ProgramSandbox& sandbox, ChildStart start, std::size_t most_bytes) {
  std::string output;
  try {
    Pipe pipe;
    const Descriptor nothing(::open("/dev/null", O_WRONLY | O_CLOEXEC));
    start.output = pipe.write.get();
    start.errors = nothing.get();
    Child child = start_within(sandbox, start, kCompileBytes, kLookupSeconds);
    pipe.write.close();
    char buffer[4096];
    while (output.size() < most_bytes) {
      const ssize_t got = ::read(pipe.read.get(), buffer, sizeof buffer);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) break;
      output.append(buffer, static_cast<std::size_t>(got));
    }
  } catch (const std::system_error&) {
    return "";
  }
  return output;
}

fs::path find_program(const std::string& name) {
  for (const fs::path& folder : program_folders())
    if (fs::path candidate = folder / name; ::access(candidate.c_str(), X_OK) == 0) return candidate;
  return {};
}

}  // namespace robosim
