// Tests that tests share no files. Tests run in parallel, so a test could read what another test wrote.
#include <gtest/gtest.h>

#include "tests/unit/structure/include_table.h"

namespace robosim::structure::temporary_files_test {

TEST(TemporaryFiles, AreInFoldersOfTheTestsThemselves) {
  for (const auto& [file, text] : read_sources(ROBOSIM_SOURCE_DIR)) {
    if (!file.starts_with("tests/") || file == "tests/support/temporary_folder.h") continue;
    for (const char* shared : {"TempDir"
                               "()",
                               "temp_directory"
                               "_path",
                               "mkd"
                               "temp"})
      EXPECT_EQ(text.find(shared), text.npos)
          << file << ": uses a folder that all tests share; use TemporaryFolder (tests/support) instead";
  }
}

}  // namespace robosim::structure::temporary_files_test
