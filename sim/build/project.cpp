#include "sim/build/project.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/file_scope.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostShared = 1000, kMostSource_bytes = std::size_t{4} << 20;
/// Limits the number of names in #include directives, in all files together. Files after the limit are not
/// shared.
constexpr std::size_t kMostNames = 20'000;

bool is_below(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

std::vector<std::string> included_by(const fs::path& file) {
  std::vector<std::string> names;
  std::string text;
  try {
    text = read_file(file, kMostSource_bytes);
  } catch (const InputError&) {
    return names;
  }
  const auto blanks = [&](std::size_t at) { return text.find_first_not_of(" \t", at); };
  for (std::size_t line = 0; line < text.size();
       line = std::min(text.find('\n', line), text.size() - 1) + 1) {
    std::size_t at = blanks(line);
    if (at == text.npos || text[at] != '#') continue;
    at = blanks(at + 1);
    if (at == text.npos || text.compare(at, 7, "include") != 0) continue;
    at = blanks(at + 7);
    if (at == text.npos || text[at] != '"') continue;
    const std::size_t end = text.find_first_of("\"\n", at + 1);
    if (end != text.npos && text[end] == '"') names.push_back(text.substr(at + 1, end - at - 1));
  }
  return names;
}

class Shared {
 public:
  Shared(fs::path folder, fs::path reach) : folder_(std::move(folder)), reach_(std::move(reach)) {}

  /// Visits `file`, and all files that it includes directly or indirectly.
  void look_at(const fs::path& file) {
    for (pending_.push_back(file); !pending_.empty();) {
      const fs::path next = std::move(pending_.back());
      pending_.pop_back();
      look_at_one(next);
    }
  }

  std::vector<fs::path> all() const { return {seen_.begin(), seen_.end()}; }

 private:
  void look_at_one(const fs::path& file) {
    std::error_code error;
    const fs::path real = fs::canonical(file, error);
    if (error || !fs::is_regular_file(real, error) || seen_.size() > kMostShared) return;
    if (!is_below(real, folder_)) {
      if (!is_below(real, reach_) || !(is_source(real) || is_header(real) || is_ino(real))) return;
      if (!seen_.insert(real).second) return;
    } else if (!own_.insert(real).second) {
      return;
    }
    for (const std::string& name : included_by(real))
      if (names_++ < kMostNames)
        for (const fs::path& from : {file.parent_path(), folder_}) pending_.push_back(from / name);
  }

  fs::path folder_, reach_;
  std::vector<fs::path> pending_;
  std::set<fs::path> seen_, own_;
  std::size_t names_ = 0;
};

}  // namespace

fs::path reach_of(const fs::path& sketch_folder) {
  const char* const home = std::getenv("HOME");
  const auto too_far = [&](const fs::path& folder) {
    return folder == folder.root_path() || (home && is_below(home, folder)) || !is_in_scope(folder);
  };
  const fs::path beside = sketch_folder.parent_path();
  const auto is_checkout = [](const fs::path& folder) {
    std::error_code none;
    return fs::exists(folder / ".git", none);
  };
  if (!is_checkout(sketch_folder))
    for (fs::path folder = beside; !too_far(folder); folder = folder.parent_path())
      if (is_checkout(folder)) return folder;
  return too_far(beside) ? sketch_folder : beside;
}

std::vector<fs::path> shared_files(const Sketch& sketch, const fs::path& reach) {
  Shared shared(sketch.folder, reach);
  for (const auto* names : {&sketch.inos, &sketch.sources, &sketch.assembler, &sketch.headers})
    for (const std::string& name : *names) shared.look_at(sketch.folder / name);
  return shared.all();
}

bool lies_in(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  if (error) return false;
  const fs::path real_folder = fs::canonical(folder, error);
  return !error && is_below(real, real_folder);
}

void check_links(const fs::path& folder) {
  std::error_code error, none;
  const fs::path itself =
      folder.has_filename() ? folder : folder.parent_path();  // without a slash at the end
  if (fs::is_symlink(itself, none))
    throw InputError(
        {itself.string()},
        fmt::format("the sketch's folder is a link to {}; with --untrusted, name that folder instead",
                    fs::read_symlink(itself, none).string()));
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (!entry->is_symlink(none) || lies_in(entry->path(), folder)) continue;
    throw InputError(
        {entry->path().string()},
        fmt::format("a link to {}, outside of the sketch's folder; --untrusted does not follow it",
                    fs::read_symlink(entry->path(), none).string()));
  }
  if (error && fs::exists(folder, none))
    throw InputError({folder.string()},
                     fmt::format("a folder in it cannot be read ({}); --untrusted must read all folders, "
                                 "to find links that lead outside",
                                 error.message()));
}

}  // namespace robosim::build
