#include "sim/build/cache.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/utf8.h"
#include "sim/build/sketch.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

constexpr const char* kHeader = "robosim cache 2";
constexpr const char* kAbsent = "-";
constexpr const char* kInner[] = {"entries", "results", "work"};
constexpr auto kKept = std::chrono::hours(24 * 30);

std::string checksum(std::string_view text) {
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

/// Returns whether a path has a part that can lead elsewhere: `.`, `..` or an empty part.
bool has_detour(std::string_view path) {
  for (const std::string_view part : {"//", "/./", "/../"})
    if (path.find(part) != path.npos) return true;
  return path.ends_with("/.") || path.ends_with("/..");
}

/// Returns whether only the system's administrator, or the user who installed Robosim, can write to the file.
/// The paths of those folders of the cache that hold links to installed files start with `stages`.
bool is_installed(const fs::path& path, const std::string& stages) {
  static const std::array<std::string, 3> folders = {"/usr/", (data_folder() / "hal" / "").string(),
                                                     (data_folder() / "firmware" / "").string()};
  const std::string& name = path.native();
  const bool is_below = std::any_of(folders.begin(), folders.end(),
                                    [&](const std::string& folder) { return name.starts_with(folder); });
  return (is_below || name.starts_with(stages)) && !has_detour(name);
}

std::string hash_file(const fs::path& path, const std::string& stages) {
  try {
    return is_installed(path, stages) ? checksum(read_file(path)) : sha256_of_file(path);
  } catch (const InputError&) {
    return kAbsent;
  }
}

bool is_whole(const fs::path& result, std::string_view sum) {
  try {
    return checksum(read_file(result)) == sum;
  } catch (const InputError&) {
    return false;
  }
}

bool has_content(const fs::path& result, std::string_view content) {
  try {
    return read_file(result) == content;
  } catch (const InputError&) {
    return false;
  }
}

std::string hash_folder(const fs::path& path) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error))
    names.push_back(entry->path().filename().string());
  if (error) return kAbsent;
  std::sort(names.begin(), names.end());
  return sha256(key_of(names));
}

std::string escape(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\\\";
    else if (c == '\n')
      result += "\\n";
    else
      result += c;
  }
  return result;
}

std::string unescape(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size())
      result += text[++i] == 'n' ? '\n' : text[i];
    else
      result += text[i];
  }
  return result;
}

std::string_view word(std::string_view& rest) {
  const std::size_t end = std::min(rest.find(' '), rest.size());
  const std::string_view first = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return first;
}

bool changed_after(const Inputs& inputs, fs::file_time_type since) {
  return std::any_of(inputs.files.begin(), inputs.files.end(), [&](const fs::path& file) {
    std::error_code error;
    const fs::file_time_type time = fs::last_write_time(file, error);
    return error || time > since;
  });
}

/// Returns whether the cache may use a folder. The folder must belong to this user: another user's folder may
/// contain that user's images.
bool usable(const fs::path& folder) {
  if (!is_utf8(folder.string())) return false;  // runners receive the paths of images in JSON
  std::error_code error;
  fs::create_directories(folder, error);
  struct stat info {};
  return ::stat(folder.c_str(), &info) == 0 && info.st_uid == ::geteuid() &&
         ::access(folder.c_str(), R_OK | W_OK | X_OK) == 0;
}

void remove_old(const fs::path& folder) {
  std::error_code error;
  const fs::file_time_type limit = fs::file_time_type::clock::now() - kKept;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code one;
    if (fs::last_write_time(entry->path(), one) < limit && !one) fs::remove_all(entry->path(), one);
  }
}

/// Opens and locks a folder. The result is not open if the folder is missing or the file system has no locks.
/// With LOCK_NB in `how`, the result is also not open if another process has the lock.
Descriptor hold(const fs::path& folder, int how) {
  Descriptor held(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  while (held.is_open() && ::flock(held.get(), how) != 0)
    if (errno != EINTR) held.close();
  return held;
}

/// Removes the work folders of processes that have ended without removing these folders.
void remove_unheld(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const Descriptor held = hold(entry->path(), LOCK_EX | LOCK_NB);
    std::error_code one;
    if (held.is_open()) fs::remove_all(entry->path(), one);
  }
}

/// Removes a folder whose path is `file`, so that the file can be written. Returns `file`. The cache owns
/// everything below its folder.
const fs::path& make_way(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(fs::symlink_status(file, error))) fs::remove_all(file, error);
  return file;
}

}  // namespace

std::string key_of(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += fmt::format("{} {}\n", word.size(), word);
  return text;
}

fs::path cache_folder() {
  const char* xdg = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  if (xdg && *xdg == '/' && usable(fs::path(xdg) / "robosim")) return fs::path(xdg) / "robosim";
  if (home && *home == '/' && usable(fs::path(home) / ".cache/robosim"))
    return fs::path(home) / ".cache/robosim";
  const fs::path fallback = fs::temp_directory_path() / fmt::format("robosim-{}", ::getuid());
  struct stat info {};
  if (!usable(fallback) || ::lstat(fallback.c_str(), &info) != 0 || info.st_uid != ::getuid())
    throw InputError(
        {fallback.string()},
        "not a folder for compiled sketches: expected one that this user owns and can write; set "
        "XDG_CACHE_HOME to another folder");
  fs::permissions(fallback, fs::perms::owner_all);
  return fallback;
}

Cache::Cache(fs::path folder) : folder_(std::move(folder)) {
  for (const char* inner : kInner) fs::create_directories(folder_ / inner);
}

std::optional<Entry> Cache::find(const std::string& key) const {
  std::string text;
  const fs::path file = folder_ / "entries" / sha256(key);
  try {
    text = read_file(file);
  } catch (const InputError&) {
    return std::nullopt;
  }
  Entry entry;
  const std::string stages = folder_ / kStage;
  std::string_view rest = text;
  bool complete = false;
  for (bool first = true; !rest.empty(); first = false) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (first) {
      if (line != kHeader) return std::nullopt;
      continue;
    }
    const std::string_view kind = word(line);
    const std::string_view value = word(line);
    if (kind == "file" && hash_file(line, stages) != value) return std::nullopt;
    if (kind == "folder" && hash_folder(line) != value) return std::nullopt;
    if (kind == "fact") entry.facts[std::string(value)] = unescape(line);
    if (kind == "result") {
      entry.result = folder_ / "results" / unescape(line);
      if (!is_whole(entry.result, value)) return std::nullopt;
    }
    if (kind == "end") complete = true;
  }
  if (!complete || entry.result.empty()) return std::nullopt;
  // Marks the entry's file and the result as recently used, so that they are not removed as old.
  std::error_code none;
  const auto now = fs::file_time_type::clock::now();
  fs::last_write_time(file, now, none);
  fs::last_write_time(entry.result, now, none);
  return entry;
}

Entry Cache::store(const std::string& key, const Inputs& inputs, std::string_view content,
                   const std::string& name, std::map<std::string, std::string> facts,
                   fs::file_time_type since) const {
  const std::string hash = sha256(content);
  const fs::path base = name;
  const std::string stored =
      fmt::format("{}-{}{}", base.stem().string(), hash.substr(0, 32), base.extension().string());
  const Entry entry{folder_ / "results" / stored, std::move(facts)};
  // Keeps an equal file: another process may be using it, and its sandbox may let it read only that file.
  if (!has_content(entry.result, content)) write_file(make_way(entry.result), content);

  std::string text = fmt::format("{}\nresult {} {}\n", kHeader, checksum(content), escape(stored));
  for (const auto& [fact, value] : entry.facts) text += fmt::format("fact {} {}\n", fact, escape(value));
  bool sound = !changed_after(inputs, since);
  const std::string stages = folder_ / kStage;
  for (const auto& [kind, paths] : {std::pair{"file", &inputs.files}, {"folder", &inputs.folders}}) {
    std::vector<fs::path> sorted = *paths;
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    for (const fs::path& path : sorted) {
      if (path.string().find('\n') != std::string::npos) sound = false;
      text += fmt::format("{} {} {}\n", kind, kind[1] == 'i' ? hash_file(path, stages) : hash_folder(path),
                          path.string());
    }
  }
  text += "end\n";
  if (sound) write_file(make_way(folder_ / "entries" / sha256(key)), text);
  return entry;
}

CacheLock::CacheLock(const Cache& cache)
    : lock_(::open((cache.folder() / "lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666)) {
  // Without a lock, work may be done twice, which is harmless.
  while (lock_.is_open() && ::flock(lock_.get(), LOCK_EX) != 0 && errno == EINTR) {
  }
}

WorkFolder::WorkFolder(const Cache& cache) {
  remove_unheld(cache.folder() / "work");
  for (const char* folder : kInner) remove_old(cache.folder() / folder);
  static std::atomic<int> count{0};
  for (;;) {
    path_ = cache.folder() / "work" / fmt::format("{}-{}", ::getpid(), count++);
    if (!fs::create_directory(path_)) continue;
    held_ = hold(path_, LOCK_SH);
    std::error_code error;
    if (fs::exists(path_, error)) return;  // if it is missing, another process has removed it
  }
}

fs::path WorkFolder::given() const {
  fs::path folder = path_ / "given";
  fs::create_directory(folder);
  return folder;
}

fs::path WorkFolder::give(const fs::path& result) const {
  fs::path here = given() / result.filename();
  std::error_code error;
  fs::create_hard_link(result, here, error);
  if (error && !fs::exists(here))
    fs::copy_file(result, here);  // the file system has no links, or another user owns the file
  return here;
}

fs::path WorkFolder::scratch() {
  fs::path folder = path_ / std::to_string(scratch_folders_++);
  fs::create_directory(folder);
  return folder;
}

std::string read_made(const fs::path& file) {
  const Descriptor made(::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat info {};
  if (!made.is_open() || ::fstat(made.get(), &info) != 0 || !S_ISREG(info.st_mode))
    throw InputError({file.filename().string()}, "the compiler did not write this file");
  return read_file(made, file.filename(), kMostFile_bytes);
}

WorkFolder::~WorkFolder() {
  std::error_code none;
  fs::remove_all(path_, none);
}

}  // namespace robosim::build
