#include "tests/unit/structure/include_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/base/file.h"

namespace robosim::structure {
namespace include_table_test {

using testing::ElementsAre;
using testing::IsEmpty;

const IncludeTable kTable = read_include_table("table", R"(
search: . hal/arduino  # so that <Arduino.h> is found
hal/arduino:
firmware: hal/arduino
firmware/src/nav:
sim/base:
sim/grid: sim/base
tests: *
<CLI/: sim/base
)");

TEST(Includes, FollowTheTable) {
  const std::string root = ROBOSIM_SOURCE_DIR;
  const std::string file = "tests/unit/structure/may_include.txt";
  const Files sources = read_sources(root);
  EXPECT_TRUE(sources.count("sim/base/error.h"));
  for (const std::string& sentence :
       broken_rules(read_include_table(file, read_file(root + "/" + file)), sources)) {
    ADD_FAILURE() << sentence << " (" << file << ")";
  }
}

TEST(IncludeTable, AllowsAFoldersOwnFilesAndItsRow) {
  EXPECT_THAT(broken_rules(kTable, {{"hal/arduino/Arduino.h", ""},
                                    {"firmware/src/motor.cpp", "#include \"motor.h\"\n#include <Arduino.h>"},
                                    {"firmware/src/motor.h", "#include \"nav/graph.h\""},
                                    {"firmware/src/nav/graph.h", "#include <stdint.h>"},
                                    {"sim/base/cli.cpp", "#include <CLI/CLI.hpp>"},
                                    {"sim/grid/map.h", "#include \"sim/base/error.h\""},
                                    {"sim/base/error.h", "#include <string>"},
                                    {"tests/x.cpp", "#include \"sim/grid/map.h\""}}),
              IsEmpty());
}

TEST(IncludeTable, NamesFileLineAndWhatIsAllowed) {
  EXPECT_THAT(
      broken_rules(kTable, {{"sim/base/error.h", "\n  #  include \"sim/grid/map.h\""},
                            {"sim/grid/map.h", "#include <Arduino.h>"},
                            {"hal/arduino/Arduino.h", ""}}),
      ElementsAre("sim/base/error.h:2: includes sim/grid/map.h; sim/base may include, besides its own "
                  "files: nothing",
                  "sim/grid/map.h:1: includes hal/arduino/Arduino.h; sim/grid may include, besides its own "
                  "files: sim/base"));
}

TEST(IncludeTable, LetsTheLongestFolderCount) {
  EXPECT_THAT(
      broken_rules(kTable, {{"firmware/src/nav/graph.h", "#include <Arduino.h>\n#include \"../motor.h\""},
                            {"firmware/src/motor.h", ""},
                            {"hal/arduino/Arduino.h", ""}}),
      ElementsAre("firmware/src/nav/graph.h:1: includes hal/arduino/Arduino.h; firmware/src/nav may include, "
                  "besides its own files: nothing",
                  "firmware/src/nav/graph.h:2: includes firmware/src/motor.h; firmware/src/nav may include, "
                  "besides its own files: nothing"));
}

TEST(IncludeTable, KeepsAnothersHeaderToTheFoldersThatMayUseIt) {
  EXPECT_THAT(broken_rules(kTable, {{"sim/grid/map.cpp", "#include <CLI/CLI.hpp>"}}),
              ElementsAre("sim/grid/map.cpp:1: includes CLI/CLI.hpp; only these may: sim/base"));
}

TEST(IncludeTable, MissesFilesAndFolders) {
  EXPECT_THAT(
      broken_rules(kTable, {{"sim/grid/map.cpp", "#include \"sim/base/gone.h\""}, {"sim/new/a.h", ""}}),
      ElementsAre("sim/grid/map.cpp:1: includes sim/base/gone.h, and there is no such file",
                  "sim/new/a.h: its folder has no row in the table"));
}

TEST(IncludeTable, ComplainsOfALineThatIsNoRow) {
  EXPECT_THROW(read_include_table("table", "sim/grid sim/base\n"), InputError);
}

}  // namespace include_table_test
}  // namespace robosim::structure
