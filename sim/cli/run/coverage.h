// `run --coverage DIR`: adds a run's counters to the report in DIR.
#pragma once

#include <filesystem>
#include <string>

#include "sim/build/sketch.h"

namespace robosim::cli {

/// Returns the folder of --coverage, otherwise $ROBOSIM_COVERAGE, otherwise empty. The environment variable,
/// meant for whole test suites, applies only to runs on the host.
std::string coverage_folder(const std::string& option, const std::string& target);

/// Names a file for a run's counters in the folder, and removes the file at the end of the scope. Throws
/// InputError if files cannot be written to the folder.
class CounterFile {
 public:
  explicit CounterFile(const std::filesystem::path& folder);
  ~CounterFile();
  CounterFile(const CounterFile&) = delete;
  CounterFile& operator=(const CounterFile&) = delete;

  /// Adds the run's counters to the report in the folder. Returns a summary of the lines that none of the
  /// folder's runs reached.
  std::string keep(const build::Request& request, const build::Image& image,
                   const std::string& description) const;
  /// Makes an HTML page of all runs in the folder if the necessary tool is installed. Returns the page's
  /// path.
  std::string make_page() const;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path folder_;
  std::filesystem::path path_;
};

}  // namespace robosim::cli
