// Tests that each detector has a test: some test file must contain the detector's name.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/file.h"
#include "sim/result/detector_names.h"

namespace robosim::structure::detectors_test {

namespace fs = std::filesystem;

TEST(Detectors, EachHaveATest) {
  std::vector<std::string> tests;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ROBOSIM_SOURCE_DIR) / "tests"))
    if (entry.path().extension() == ".cpp") tests.push_back(read_file(entry.path()));
  for (const result::DetectorName& one : result::kDetectorNames) {
    const std::string name = '"' + std::string(one.name) + '"';
    EXPECT_TRUE(std::any_of(tests.begin(), tests.end(),
                            [&](const std::string& text) { return text.find(name) != std::string::npos; }))
        << "no test expects a finding of " << name;
  }
}

}  // namespace robosim::structure::detectors_test
