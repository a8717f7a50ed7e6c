#include "sim/cli/run/coverage.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <system_error>

#include "sim/base/file.h"
#include "sim/build/coverage.h"

namespace robosim::cli {
namespace fs = std::filesystem;

std::string coverage_folder(const std::string& option, const std::string& target) {
  if (!option.empty()) return option;
  const char* const everywhere = std::getenv("ROBOSIM_COVERAGE");
  return everywhere && target == "host" ? everywhere : "";
}

CounterFile::CounterFile(const fs::path& folder)
    : folder_(fs::absolute(folder)), path_(folder_ / fmt::format(".counters-{}", ::getpid())) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error || ::access(folder_.c_str(), W_OK) != 0)
    throw InputError({folder.string(), 0, 0}, "--coverage: files cannot be written into this folder");
}

CounterFile::~CounterFile() {
  std::error_code none;
  fs::remove(path_, none);
}

std::string CounterFile::keep(const build::Request& request, const build::Image& image,
                              const std::string& description) const {
  if (!fs::exists(path_)) return "coverage: nothing was counted, because the run crashed its process\n";
  const build::Coverage ran = read_coverage(request, image, read_file(path_));
  return "coverage: " + summary(add_to_folder(folder_, request, image, ran, description));
}

std::string CounterFile::make_page() const {
  if (build::make_page(folder_)) return fmt::format("page: {}\n", (folder_ / "html/index.html").string());
  return fmt::format("{} (genhtml makes a page of it: sudo apt install lcov)\n",
                     (folder_ / "coverage.info").string());
}

}  // namespace robosim::cli
