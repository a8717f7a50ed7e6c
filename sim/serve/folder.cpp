#include "sim/serve/folder.h"

#include <algorithm>
#include <sstream>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/build/sketch.h"
#include "sim/launch/names.h"

namespace robosim::serve {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 3;
constexpr std::size_t kMost = 500;
constexpr std::size_t kLongestToml = 256 * 1024;

bool is_within(const fs::path& path, const fs::path& folder) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

// Whether a table of it is an [[agent]]; what is too long for TOML has none.
bool names_robots(const fs::path& file) {
  try {
    std::istringstream lines(read_file(file, kLongestToml));
    for (std::string line; std::getline(lines, line);) {
      const std::size_t begin = line.find_first_not_of(" \t");
      if (begin != line.npos && line.compare(begin, 9, "[[agent]]") == 0) return true;
    }
  } catch (const InputError&) {
  }
  return false;
}

void look(const fs::path& folder, const fs::path& root, int depth, Choices& choices) {
  std::error_code error;
  const std::string below = folder == root ? "." : "./" + fs::relative(folder, root, error).string();
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(".") || !is_within(fs::weakly_canonical(entry.path(), error), root)) continue;
    if (entry.is_directory(error)) {
      if (depth < kDeepest) look(entry.path(), root, depth + 1, choices);
      continue;
    }
    if (!entry.is_regular_file(error)) continue;
    const std::string extension = entry.path().extension().string();
    const std::string path = below + "/" + name;
    if (extension == ".ino" && (choices.sketches.empty() || choices.sketches.back() != below))
      choices.sketches.push_back(below);
    if (is_image(name)) choices.sketches.push_back(path);
    if (extension == ".toml" && name != "checks.toml")
      (names_robots(entry.path()) ? choices.sketches : choices.robots).push_back(path);
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

Choices choices_in(const fs::path& folder) {
  Choices choices;
  const fs::path root = fs::canonical(folder);
  look(root, root, 1, choices);
  finish(choices.sketches, build::stock_sketches());
  finish(choices.robots, launch::names_in(launch::stock_robot_folder(), ".toml"));
  finish(choices.maps, launch::names_in(launch::stock_map_folder(), ".map"));
  return choices;
}

}  // namespace robosim::serve
