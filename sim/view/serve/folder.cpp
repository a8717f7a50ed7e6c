#include "sim/view/serve/folder.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "sim/base/error.h"
#include "sim/build/sketch.h"
#include "sim/launch/names.h"

namespace robosim::serve {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 3;
constexpr std::size_t kMost = 500;
constexpr std::size_t kLongestToml = 256 * 1024;

// Returns whether a file contains an [[agent]]. A file that is too long for TOML does not.
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

// `below`: "." or "./some/folder".
void look(const HeldFolder& root, const std::string& below, int depth, Choices& choices) {
  const Descriptor folder = root.open(below, O_RDONLY | O_DIRECTORY);
  if (!folder.is_open()) return;
  std::error_code error;
  const fs::path names = "/proc/self/fd/" + std::to_string(folder.get());
  for (const fs::directory_entry& entry : fs::directory_iterator(names, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(".")) continue;
    const std::string path = below + "/" + name;
    const Descriptor found = root.open(path, O_PATH);
    struct stat info {};
    if (!found.is_open() || ::fstat(found.get(), &info) != 0) continue;
    if (S_ISDIR(info.st_mode) && depth < kDeepest) look(root, path, depth + 1, choices);
    if (!S_ISREG(info.st_mode)) continue;
    const std::string extension = fs::path(name).extension().string();
    if (extension == ".ino" && (choices.sketches.empty() || choices.sketches.back() != below))
      choices.sketches.push_back(below);
    if (is_image(name)) choices.sketches.push_back(path);
    if (extension == ".toml" && name != "checks.toml")
      (names_robots(root, path) ? choices.sketches : choices.robots).push_back(path);
    if (extension == ".map") choices.maps.push_back(path);
  }
}

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
  look(folder, ".", 1, choices);
  finish(choices.sketches, build::stock_sketches());
  finish(choices.robots, launch::names_in(launch::stock_robot_folder(), ".toml"));
  finish(choices.maps, launch::names_in(launch::stock_map_folder(), ".map"));
  return choices;
}

}  // namespace robosim::serve
