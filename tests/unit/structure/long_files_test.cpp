// A file has one subject: 400 lines are enough for it. Tests and data may be as long as they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "sim/base/file.h"

namespace {

namespace fs = std::filesystem;

constexpr auto kMostLines = 400;

TEST(Structure, NoFileIsLongerThan400Lines) {
  const fs::path root = ROBOSIM_SOURCE_DIR;
  const std::set<std::string> code = {".h", ".cpp", ".c", ".ino", ".cmake", ".sh", ".ld"};
  int looked_at = 0;
  for (const char* folder : {"firmware", "hal", "sim", "toolchain"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path& file = entry.path();
      if (!entry.is_regular_file() || !code.contains(file.extension().string())) continue;
      ++looked_at;
      const std::string text = robosim::read_file(file);
      EXPECT_LE(std::count(text.begin(), text.end(), '\n'), kMostLines)
          << file << ": split it into its subjects, each with a name that says which";
    }
  }
  EXPECT_GT(looked_at, 300);
}

}  // namespace
