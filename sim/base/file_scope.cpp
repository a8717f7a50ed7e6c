#include "sim/base/file_scope.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <vector>

#include "sim/base/file.h"

namespace robosim {
namespace fs = std::filesystem;

namespace {

constexpr int kMostLinks = 40;              // as in Linux
constexpr std::size_t kLongestLink = 4096;  // as in Linux
constexpr const char* kSystem[] = {"/usr", "/lib", "/lib64", "/opt", "/nix"};

std::deque<std::string> steps_of(const fs::path& path) {
  std::deque<std::string> steps;
  for (const fs::path& step : path)
    if (!step.empty() && step != ".") steps.push_back(step.string());
  return steps;
}

/// Returns the path's components below `folder`; nothing if `path` does not start with `folder`.
std::optional<std::deque<std::string>> steps_below(const fs::path& folder, const fs::path& path) {
  const std::deque<std::string> top = steps_of(folder);
  std::deque<std::string> steps = steps_of(path);
  if (steps.size() < top.size() || !std::equal(top.begin(), top.end(), steps.begin())) return std::nullopt;
  steps.erase(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(top.size()));
  return steps;
}

fs::path joined(const std::deque<std::string>& steps) {
  fs::path path;
  for (const std::string& step : steps) path /= step;
  return path;
}

/// Returns the target of a link; nothing if `name` is not a link.
std::optional<fs::path> link_at(int folder, const std::string& name) {
  char target[kLongestLink];
  const ssize_t size = ::readlinkat(folder, name.c_str(), target, sizeof target);
  if (size < 0) return std::nullopt;
  return fs::path(std::string(target, static_cast<std::size_t>(size)));
}

Descriptor fail(int error) {
  errno = error;
  return {};
}

}  // namespace

HeldFolder::HeldFolder(const fs::path& path)
    : path_(path), handle_(::open(path.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)) {
  if (!handle_.is_open())
    throw InputError({path.string()}, std::string("cannot be opened: ") + std::strerror(errno));
}

Descriptor HeldFolder::open(const fs::path& below, int flags, Links allowed) const {
  if (below.is_absolute()) return fail(EXDEV);
  std::vector<Descriptor> folders;  // the open folders on the way to the file; `..` closes the last one
  std::deque<std::string> left = steps_of(below);
  int links = 0;
  const auto here = [&] { return folders.empty() ? handle_.get() : folders.back().get(); };
  while (!left.empty()) {
    const std::string step = left.front();
    left.pop_front();
    if (step == "..") {
      if (folders.empty()) return fail(EXDEV);
      folders.pop_back();
      continue;
    }
    if (std::optional<fs::path> target = link_at(here(), step)) {
      if (allowed == Links::refused || ++links > kMostLinks) return fail(ELOOP);
      std::deque<std::string> more = steps_of(*target);
      if (target->is_absolute()) {
        auto inside = steps_below(path_, *target);
        if (!inside) return fail(EXDEV);
        more = std::move(*inside);
        folders.clear();
      }
      left.insert(left.begin(), more.begin(), more.end());
      continue;
    }
    const bool is_last = left.empty();
    const int how = is_last ? flags : O_PATH | O_DIRECTORY;
    Descriptor opened(::openat(here(), step.c_str(), how | O_NOFOLLOW | O_CLOEXEC));
    if (is_last || !opened.is_open()) return opened;
    folders.push_back(std::move(opened));
  }
  return Descriptor(::openat(here(), ".", flags | O_CLOEXEC));
}

std::string HeldFolder::read(const fs::path& below, std::size_t most_bytes) const {
  const Descriptor file = open(below, O_RDONLY | O_NONBLOCK);
  check_is_file(file, below);
  return read_file(file, below, most_bytes);
}

namespace {

class Scope {
 public:
  explicit Scope(const char* text) {
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    served_ = line;
    while (std::getline(lines, line)) add(line);
    for (const char* folder : kSystem) add(folder);
    for (const fs::path& folder : {data_folder(), helper_folder()}) add(folder);
  }

  void add(const fs::path& folder) { others_.push_back(folder); }
  bool has(const fs::path& folder) const {
    return std::find(others_.begin(), others_.end(), folder) != others_.end();
  }

  Descriptor open(const fs::path& path, int flags) const {
    const fs::path file = whole(path);
    const auto below = steps_below(served_, file);
    std::size_t depth = below ? depth_of(served_) : 0;
    bool is_served = below.has_value();
    bool is_other = false;
    for (const fs::path& folder : others_) {  // the innermost folder determines the permission
      if (depth_of(folder) <= depth || !holds(folder, file)) continue;
      depth = depth_of(folder);
      is_served = false;
      is_other = true;
    }
    if (is_served) return served().open(joined(*below), flags);
    return is_other ? Descriptor(::open(file.c_str(), flags | O_CLOEXEC)) : fail(EXDEV);
  }

  Descriptor open_to_show(const fs::path& path) const {
    const auto below = steps_below(served_, whole(path));
    return below ? served().open(joined(*below), O_PATH)
                 : Descriptor(::open(path.c_str(), O_PATH | O_CLOEXEC));
  }

  /// Returns whether `path` is one of Robosim's own maps, robots or sketches.
  static bool is_own(const fs::path& path) { return path.is_absolute() && holds(data_folder(), path); }

  bool leads_into_served(const fs::path& path) const {
    const auto below = steps_below(served_, whole(path));
    return below && (served().open(joined(*below), O_PATH).is_open() || errno != EXDEV);
  }

 private:
  static fs::path whole(const fs::path& path) {
    return path.is_absolute() ? path : fs::current_path() / path;
  }
  static std::size_t depth_of(const fs::path& path) { return steps_of(path).size(); }
  static bool holds(const fs::path& folder, const fs::path& file) {
    const auto below = steps_below(folder, file);
    return below && std::find(below->begin(), below->end(), "..") == below->end();
  }

  // Opens the served folder for each use. A run's process reuses descriptor numbers, so an inherited
  // descriptor could refer to another file.
  HeldFolder served() const { return HeldFolder(served_); }

  fs::path served_;
  std::vector<fs::path> others_;
};

/// Returns the scope, or null. Reads are atomic instead of locked, because a fork must not inherit a lock
/// that another thread holds.
std::atomic<const Scope*>& scope() {
  static std::atomic<const Scope*> current = [] {
    const char* const text = std::getenv(kFileScope);
    static const std::unique_ptr<const Scope> first = text ? std::make_unique<Scope>(text) : nullptr;
    return first.get();
  }();
  return current;
}

}  // namespace

std::string file_scope_variable(const std::vector<fs::path>& folders) {
  std::string text = fmt::format("{}=", kFileScope);
  for (const fs::path& folder : folders) text += folder.string() + "\n";
  return text;
}

Descriptor open_in_scope(const fs::path& path, int flags) {
  const Scope* const only = scope();
  if (!only) return Descriptor(::open(path.c_str(), flags | O_CLOEXEC));
  return only->open(path, flags);
}

Descriptor open_to_show(const fs::path& path) {
  const Scope* const only = scope();
  if (!only) return Descriptor(::open(path.c_str(), O_PATH | O_CLOEXEC));
  return only->open_to_show(path);
}

void extend_file_scope(const fs::path& folder) {
  static std::mutex mutex;
  static std::deque<Scope> extended;  // never shrinks, because another thread may be reading an element
  const std::lock_guard lock(mutex);
  const Scope* const before = scope();
  if (!before || before->has(folder)) return;
  extended.push_back(*before);
  extended.back().add(folder);
  scope() = &extended.back();
}

InputError out_of_scope(const fs::path& path, const Place& place) {
  return {place,
          fmt::format("'{}' leads out of the served folder: expected a path inside it", path.string())};
}

void check_in_scope(const fs::path& path, const Place& place) {
  if (!is_in_scope(path) && !Scope::is_own(path)) throw out_of_scope(path, place);
}

bool is_in_scope(const fs::path& folder) {
  const Scope* const only = scope();
  if (!only) return true;
  return only->leads_into_served(folder);
}

}  // namespace robosim
