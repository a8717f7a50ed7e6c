#include "sim/base/namespace_sandbox.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "sim/base/child.h"

namespace robosim {
namespace fs = std::filesystem;

namespace {

// The initial mount point of the new root, and the temporary mount point of the old root.
constexpr const char* kNew = "/tmp";
constexpr const char* kOld = "/.old";

bool write_text(const char* file, const char* text, std::size_t bytes) {
  const int fd = ::open(file, O_WRONLY | O_CLOEXEC);
  if (fd < 0) return false;
  const bool written = ::write(fd, text, bytes) == static_cast<ssize_t>(bytes);
  ::close(fd);
  return written;
}

bool pivot() {
  return ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
         ::mount("robosim", kNew, "tmpfs", MS_NOSUID | MS_NODEV, "mode=0755") == 0 && ::chdir(kNew) == 0 &&
         ::mkdir(kOld + 1, 0700) == 0 && ::syscall(SYS_pivot_root, ".", kOld + 1) == 0 && ::chdir("/") == 0;
}

unsigned long mount_flags(const fs::path& path) {
  struct statvfs facts {};
  if (::statvfs(path.c_str(), &facts) != 0) return 0;
  unsigned long flags = 0;
  for (const auto& [is, flag] : {std::pair<unsigned long, unsigned long>{ST_NOSUID, MS_NOSUID},
                                 {ST_NODEV, MS_NODEV},
                                 {ST_NOEXEC, MS_NOEXEC},
                                 {ST_NOATIME, MS_NOATIME},
                                 {ST_NODIRATIME, MS_NODIRATIME},
                                 {ST_RELATIME, MS_RELATIME},
                                 {ST_RDONLY, MS_RDONLY}})
    if (facts.f_flag & is) flags |= flag;
  return flags;
}

/// Prevents later programs from getting capabilities. Otherwise a program that root starts would have all
/// capabilities in its namespace. The program could then make the visible files writable again.
bool drop_capabilities() {
  for (unsigned long one = 0; ::prctl(PR_CAPBSET_READ, one, 0, 0, 0) >= 0; ++one)
    if (::prctl(PR_CAPBSET_DROP, one, 0, 0, 0) != 0) return false;
  return true;
}

}  // namespace

NamespaceSandbox::NamespaceSandbox(const std::vector<fs::path>& read, const std::vector<fs::path>& write)
    : user_map_(fmt::format("{0} {0} 1", ::getuid())), group_map_(fmt::format("{0} {0} 1", ::getgid())) {
  for (const fs::path& path : read) add(path, false);
  for (const fs::path& path : write) add(path, true);
  // Sorts inner folders after outer folders.
  std::stable_sort(places_.begin(), places_.end(),
                   [](const Place& a, const Place& b) { return a.path.size() < b.path.size(); });
}

void NamespaceSandbox::add(const fs::path& path, bool writable) {
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  if (error) return;
  for (const fs::path& name : {real, fs::absolute(path, error).lexically_normal()}) {
    if (std::any_of(places_.begin(), places_.end(),
                    [&](const Place& one) { return one.path == name.string(); }))
      continue;
    Place& place = places_.emplace_back();
    place.path = name.string();
    place.real = kOld + real.string();
    place.folder = fs::is_directory(real, error);
    place.writable = writable;
    place.flags = mount_flags(real);
    for (fs::path above = place.folder ? name : name.parent_path(); above.has_relative_path();
         above = above.parent_path())
      place.above.insert(place.above.begin(), above.string());
  }
}

bool NamespaceSandbox::show(const Place& place) const {
  for (const std::string& folder : place.above) ::mkdir(folder.c_str(), 0755);  // the folder may exist
  if (!place.folder) {
    const int fd = ::open(place.path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0444);
    if (fd >= 0) ::close(fd);
  }
  if (::mount(place.real.c_str(), place.path.c_str(), nullptr, MS_BIND | MS_REC, nullptr) != 0) return false;
  if (place.writable) return true;
  return ::mount(nullptr, place.path.c_str(), nullptr, MS_BIND | MS_REMOUNT | MS_RDONLY | place.flags,
                 nullptr) == 0;
}

bool NamespaceSandbox::enter() const {
  if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
  write_text("/proc/self/setgroups", "deny", 4);  // the file is missing in older kernels
  if (!write_text("/proc/self/uid_map", user_map_.data(), user_map_.size()) ||
      !write_text("/proc/self/gid_map", group_map_.data(), group_map_.size()) || !pivot())
    return false;
  for (const Place& place : places_)
    if (!show(place)) return false;
  return ::umount2(kOld, MNT_DETACH) == 0 && ::rmdir(kOld) == 0 &&
         ::mount(nullptr, "/", nullptr, MS_BIND | MS_REMOUNT | MS_RDONLY | MS_NOSUID | MS_NODEV, nullptr) ==
             0 &&
         drop_capabilities();
}

bool NamespaceSandbox::possible() {
  static const bool is = [] {
    const NamespaceSandbox walls({"/usr"}, {"/dev/null"});
    return Child([&] { return walls.enter() ? 0 : 1; }).wait().ok();
  }();
  return is;
}

}  // namespace robosim
