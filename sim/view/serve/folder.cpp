#include "sim/view/serve/folder.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <utility>

#include "sim/base/error.h"
#include "sim/build/sketch.h"
#include "sim/launch/names.h"

namespace robosim::serve {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 3;
constexpr std::size_t kMost = 500;
constexpr std::size_t kLongestToml = 256 * 1024;

// Returns whether a file has an [[agent]] table, and thus lists robots. Returns false for a file that is
// longer than kLongestToml.
bool names_robots(const HeldFolder& root, const std::string& file) {
  try {
    std::istringstream lines(root.read(file, kLongestToml));
    for (std::string line; std::getline(lines, line);) {
      const std::size_t begin = line.find_first_not_of(" \t");
      if (begin != line.npos && line.compare(begin, 9, "[[agent]]") == 0) return true;
    }
  } catch (const InputError&) {
  }
  return false;
}

/// Looks for files in a folder and its subfolders.
class Search {
 public:
  Search(const HeldFolder& root, Choices& choices) : root_(root), choices_(choices) {}

  /// Searches `below`, which is "." or a path such as "./some/folder". Visits a folder once, although links
  /// may lead to it again.
  void look(const std::string& below, int depth) {
    const Descriptor folder = root_.open(below, O_RDONLY | O_DIRECTORY);
    struct stat info {};
    if (!folder.is_open() || ::fstat(folder.get(), &info) != 0) return;
    if (!seen_.insert({info.st_dev, info.st_ino}).second) return;
    std::error_code error;
    const fs::path names = "/proc/self/fd/" + std::to_string(folder.get());
    for (const fs::directory_entry& entry : fs::directory_iterator(names, error)) {
      if (++entries_ > kMostEntries) return;
      const std::string name = entry.path().filename().string();
      if (!name.starts_with(".")) take(below, name, depth);
    }
  }

 private:
  static constexpr int kMostEntries = 20'000;

  void take(const std::string& below, const std::string& name, int depth) {
    const std::string path = below + "/" + name;
    const Descriptor found = root_.open(path, O_PATH);
    struct stat info {};
    if (!found.is_open() || ::fstat(found.get(), &info) != 0) return;
    if (S_ISDIR(info.st_mode) && depth < kDeepest) look(path, depth + 1);
    if (!S_ISREG(info.st_mode)) return;
    const std::string extension = fs::path(name).extension().string();
    if (extension == ".ino" && (choices_.sketches.empty() || choices_.sketches.back() != below))
      choices_.sketches.push_back(below);
    if (is_image(name)) choices_.sketches.push_back(path);
    if (extension == ".toml" && name != "checks.toml")
      (names_robots(root_, path) ? choices_.sketches : choices_.robots).push_back(path);
    if (extension == ".map") choices_.maps.push_back(path);
  }

  const HeldFolder& root_;
  Choices& choices_;
  std::set<std::pair<dev_t, ino_t>> seen_;
  int entries_ = 0;
};

void finish(std::vector<std::string>& own, const std::vector<std::string>& ours) {
  std::sort(own.begin(), own.end());
  own.erase(std::unique(own.begin(), own.end()), own.end());
  if (own.size() > kMost) own.resize(kMost);
  own.insert(own.end(), ours.begin(), ours.end());
}

}  // namespace

bool is_image(const std::string& name) { return name.ends_with(".hex") || name.ends_with(".elf"); }

Choices choices_in(const HeldFolder& folder) {
  Choices choices;
  Search(folder, choices).look(".", 1);
  finish(choices.sketches, build::stock_sketches());
  finish(choices.robots, launch::names_in(launch::stock_robot_folder(), ".toml"));
  finish(choices.maps, launch::names_in(launch::stock_map_folder(), ".map"));
  return choices;
}

}  // namespace robosim::serve
