// Finds the sketches that come with Robosim, and the sketch that a user means by a name (sketch.h).
#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "sim/base/did_you_mean.h"
#include "sim/base/file.h"
#include "sim/build/sketch.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

fs::path stock_folder() { return data_folder() / "firmware/examples"; }

}  // namespace

bool is_stock_sketch(const std::string& name) {
  std::error_code none;
  return !name.empty() && fs::exists(stock_folder() / name / (name + ".ino"), none);
}

std::vector<std::string> stock_sketches() {
  std::vector<std::string> names;
  std::error_code none;
  for (fs::directory_iterator entry(stock_folder(), none), end; entry != end; ++entry) {
    const std::string name = entry->path().filename().string();
    if (is_stock_sketch(name)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool is_sketch_path(const std::string& name, const fs::path& folder) {
  std::error_code none;
  return name.find_first_of("/.") != name.npos || (!name.empty() && fs::is_directory(folder / name, none));
}

fs::path find_sketch(const std::string& name) {
  std::error_code none;
  if (is_sketch_path(name)) {
    if (!fs::exists(name, none)) throw InputError({name}, "no such sketch");
    return name;
  }
  if (is_stock_sketch(name)) return stock_folder() / name;
  throw InputError(
      fmt::format("'{0}' is neither a folder here nor a sketch of Robosim; {1}{2}", name,
                  guess_and_list(name, stock_sketches()),
                  fs::exists(name, none) ? fmt::format("; to use the file here, give ./{}", name) : ""));
}

}  // namespace robosim::build
