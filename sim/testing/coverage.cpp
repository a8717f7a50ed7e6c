#include "sim/testing/coverage.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "sim/base/file.h"
#include "sim/build/coverage.h"

namespace robosim::testing {
namespace fs = std::filesystem;

std::string coverage_folder(const std::string& target) {
  const char* const folder = std::getenv("ROBOSIM_COVERAGE");
  return folder && target == "host" ? folder : "";
}

std::string new_counter_file(const std::string& folder) {
  static int number = 0;
  fs::create_directories(folder);
  return (fs::absolute(folder) / fmt::format(".counters-{}-{}", ::getpid(), ++number)).string();
}

void keep_coverage(const std::string& folder, const std::string& counters, const build::Request& request,
                   const build::Image& image, const std::string& description) {
  std::error_code none;
  if (!fs::exists(counters, none)) return;  // the process crashed before it wrote the file
  const build::Coverage ran = build::read_coverage(request, image, read_file(counters));
  fs::remove(counters, none);
  build::add_to_folder(folder, request, image, ran, description);
}

}  // namespace robosim::testing
