#include "sim/build/libraries.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <sstream>
#include <system_error>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/file_scope.h"
#include "sim/build/project.h"
#include "sim/build/project/project.h"
#include "sim/build/source.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

bool is_file(const fs::path& path) {
  std::error_code none;
  return fs::is_regular_file(path, none);
}

bool is_folder(const fs::path& path) {
  std::error_code none;
  return fs::is_directory(path, none);
}

std::vector<fs::path> children(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code none;
  for (fs::directory_iterator entry(folder, none), end; entry != end; entry.increment(none))
    if (entry->path().filename().string()[0] != '.') paths.push_back(entry->path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

bool is_library_header(const fs::path& path) {
  return path.extension() == ".h" || path.extension() == ".hpp";
}

void take_sources(Library& library, const fs::path& folder) {
  library.listed.push_back(folder);
  for (const fs::path& child : children(folder)) {
    if (!is_file(child)) continue;
    const std::string name = child.lexically_relative(library.folder).string();
    if (is_source(child)) library.sources.push_back(name);
    if (child.extension() == ".S") library.assembler.push_back(name);
  }
}

/// Adds each folder once, even if several links lead to it. Skips folders outside the library.
void take_all_below(Library& library, const fs::path& folder, std::set<fs::path>& taken) {
  std::error_code error;
  const fs::path real = fs::canonical(folder, error);
  if (error || !lies_in(real, library.folder) || !taken.insert(real).second) return;
  for (const fs::path& child : children(folder))
    if (is_folder(child)) take_all_below(library, child, taken);
  take_sources(library, folder);
}

bool holds_headers(const fs::path& folder) {
  const std::vector<fs::path> files = children(folder);
  return std::any_of(files.begin(), files.end(),
                     [](const fs::path& file) { return is_library_header(file); });
}

bool is_library(const fs::path& folder) {
  return is_file(folder / "library.properties") || holds_headers(folder) || holds_headers(folder / "src") ||
         holds_headers(folder / "include");
}

/// Size limit of library.properties; a larger file is ignored.
constexpr std::uintmax_t kMostProperties_bytes = 256 << 10;

/// Returns the value of a key in a file such as library.properties; empty if the key is missing.
std::string property(const fs::path& file, const std::string& key) {
  std::error_code none;
  if (!is_file(file) || fs::file_size(file, none) > kMostProperties_bytes) return {};
  std::istringstream lines(read_file(file));
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.rfind(key + "=", 0) == 0) return line.substr(key.size() + 1);
  }
  return {};
}

// Folder into which Debian packages install Arduino libraries.
constexpr const char* kDebianLibraries = "/usr/share/arduino/libraries";

/// Adds the library folders of Arduino's IDE: in the sketchbook of its preferences, and in its default
/// folders.
void add_folders_of_ide(std::vector<fs::path>& folders, const fs::path& home) {
  const fs::path snap = home / "snap/arduino/current";
  const auto add = [&](const fs::path& folder) {
    extend_file_scope(folder);
    if (std::find(folders.begin(), folders.end(), folder) == folders.end()) folders.push_back(folder);
  };
  for (const fs::path& book : project::sketchbooks())
    if (is_folder(book / "libraries")) add(book / "libraries");
  add(home / "Arduino/libraries");
  if (is_folder(snap / "Arduino/libraries")) add(snap / "Arduino/libraries");
}

Library read_library(const fs::path& folder) {
  Library library;
  library.name = property(folder / "library.properties", "name");
  library.named = !library.name.empty();
  if (!library.named) library.name = folder.filename().string();
  library.version = property(folder / "library.properties", "version");
  library.archive = property(folder / "library.properties", "dot_a_linkage") == "true";
  library.folder = folder;
  const bool is_arduino = is_file(folder / "library.properties");
  if (is_folder(folder / "src") && (is_arduino || !holds_headers(folder))) {
    if (!is_arduino && is_folder(folder / "include")) library.includes = {folder / "include"};
    library.includes.push_back(folder / "src");
    library.listed = {folder};
    std::set<fs::path> taken;
    take_all_below(library, folder / "src", taken);
  } else {
    library.includes = {folder};
    take_sources(library, folder);
    if (is_folder(folder / "utility")) {
      library.includes.push_back(folder / "utility");
      take_sources(library, folder / "utility");
    }
  }
  std::sort(library.sources.begin(), library.sources.end());
  std::sort(library.assembler.begin(), library.assembler.end());
  return library;
}

constexpr int kUnlike = 2;

// Returns how well a library's folder name matches a header; 0 is best.
int rank(const Library& library, const std::string& header) {
  const std::string wanted = fs::path(header).stem().string();
  const std::string folder = library.folder.filename().string();
  if (folder == wanted) return 0;
  return folder.rfind(wanted, 0) == 0 ? 1 : kUnlike;
}

std::vector<Library> libraries_in(const fs::path& folder) {
  std::vector<Library> found;
  for (const fs::path& child : children(folder))
    if (is_folder(child) && is_library(child)) found.push_back(read_library(child));
  return found;
}

}  // namespace

std::vector<Library> libraries_called(const std::string& name, const std::vector<fs::path>& folders) {
  std::vector<Library> found;
  for (const fs::path& folder : folders)
    for (Library& library :
         is_library(folder) ? std::vector<Library>{read_library(folder)} : libraries_in(folder))
      if (library.named && library.name == name) found.push_back(std::move(library));
  return found;
}

std::vector<fs::path> library_folders(const fs::path& sketch, const std::vector<fs::path>& chosen,
                                      const std::vector<fs::path>& core) {
  std::vector<fs::path> folders = {sketch / "libraries"};
  std::vector<fs::path> inner;
  for (const auto& entry : fs::directory_iterator(sketch)) {
    const std::string name = entry.path().filename().string();
    std::error_code none;
    if (entry.is_directory(none) && name[0] != '.' && name != "src" && name != "libraries" &&
        (fs::exists(entry.path() / "library.properties", none) ||
         fs::exists(entry.path() / (name + ".h"), none)))
      inner.push_back(entry.path());
  }
  std::sort(inner.begin(), inner.end());
  folders.insert(folders.end(), inner.begin(), inner.end());
  for (const fs::path& folder : chosen) {
    std::error_code error;
    const fs::path absolute = fs::canonical(folder, error);
    if (error || !fs::is_directory(absolute))
      throw InputError({folder.string()}, "not a folder: expected a folder of libraries or one library");
    folders.push_back(absolute);
  }
  folders.push_back(data_folder() / "firmware");
  if (const char* home = std::getenv("HOME"); home && *home == '/') add_folders_of_ide(folders, home);
  if (is_folder(kDebianLibraries)) folders.emplace_back(kDebianLibraries);
  folders.insert(folders.end(), core.begin(), core.end());
  return folders;
}

LibraryFinder::LibraryFinder(std::vector<fs::path> folders, const fs::path& stand_ins)
    : folders_(std::move(folders)) {
  for (const fs::path& folder : folders_)
    libraries_.push_back(is_library(folder) ? std::vector<Library>{read_library(folder)}
                                            : libraries_in(folder));
  if (!stand_ins.empty()) stand_ins_ = libraries_in(stand_ins);
}

const Library* LibraryFinder::find(const std::string& header) const {
  const Library* const found = installed(header);
  for (const Library& library : stand_ins_) {
    if (!is_file(library.includes[0] / header)) continue;
    const bool same = found && (found->named ? found->name == library.name : rank(*found, header) < kUnlike);
    if (!found || same) return &library;
  }
  return found;
}

const Library* LibraryFinder::installed(const std::string& header) const {
  for (const std::vector<Library>& group : libraries_) {
    const Library* best = nullptr;
    for (const Library& library : group)
      if (is_file(library.includes[0] / header) && (!best || rank(library, header) < rank(*best, header)))
        best = &library;
    if (best) return best;
  }
  return nullptr;
}

std::vector<fs::path> LibraryFinder::includes() const {
  std::vector<fs::path> all;
  for (const std::vector<Library>& libraries : libraries_)
    for (const Library& library : libraries)
      all.insert(all.end(), library.includes.begin(), library.includes.end());
  return all;
}

std::vector<fs::path> LibraryFinder::listed() const {
  std::vector<fs::path> all = folders_;
  for (const std::vector<Library>& group : libraries_)
    for (const Library& library : group) {
      all.push_back(library.folder);
      all.push_back(library.includes[0]);
    }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace robosim::build
