#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "sim/base/file.h"
#include "sim/build/sketch.h"

namespace robosim::build {
namespace fs = std::filesystem;

std::vector<std::string> stock_sketches() {
  std::vector<std::string> names;
  std::error_code none;
  for (fs::directory_iterator entry(data_folder() / "firmware/examples", none), end; entry != end; ++entry) {
    const std::string name = entry->path().filename().string();
    if (fs::exists(entry->path() / (name + ".ino"))) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path find_sketch(const std::string& name) {
  std::error_code none;
  if (name.find_first_of("/.") != std::string::npos) {
    if (!fs::exists(name, none)) throw InputError({name}, "there is no such sketch");
    return name;
  }
  const fs::path folder = data_folder() / "firmware/examples" / name;
  if (!name.empty() && fs::exists(folder / (name + ".ino"), none)) return folder;
  const std::vector<std::string> ours = stock_sketches();
  throw InputError(
      fmt::format("there is no sketch {}; Robosim's own are {}{}", name, one_of(ours),
                  fs::exists(name, none) ? fmt::format("; for the one here write ./{}", name) : ""));
}

}  // namespace robosim::build
