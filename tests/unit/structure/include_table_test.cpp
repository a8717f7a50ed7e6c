#include "tests/unit/structure/include_table.h"

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/base/file.h"

namespace robosim::structure::include_table_test {

using testing::ElementsAre;
using testing::IsEmpty;

const IncludeTable kTable = read_include_table("table", R"(
search: . hal/arduino  # so that <Arduino.h> is found
hal/arduino:
firmware: hal/arduino
firmware/src/nav:
sim/base:
sim/map: sim/base
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

TEST(Includes, HaveNoCycle) {
  const std::string root = ROBOSIM_SOURCE_DIR;
  const IncludeTable table =
      read_include_table("table", read_file(root + "/tests/unit/structure/may_include.txt"));
  EXPECT_THAT(include_cycles(table, read_sources(root)), IsEmpty());
}

TEST(Includes, AreNotCircumventedByForwardDeclarations) {
  const std::string root = ROBOSIM_SOURCE_DIR;
  const IncludeTable table =
      read_include_table("table", read_file(root + "/tests/unit/structure/may_include.txt"));
  EXPECT_THAT(foreign_namespaces(table, read_sources(root)), IsEmpty());
}

TEST(IncludeTable, FindsCycles) {
  EXPECT_THAT(include_cycles(kTable, {{"sim/map/a.h", "#include \"sim/map/b.h\""},
                                      {"sim/map/b.h", "#include \"c.h\""},
                                      {"sim/map/c.h", "#include \"sim/map/b.h\"\n#include \"d.h\""},
                                      {"sim/map/d.h", "#include <string>"}}),
              ElementsAre("sim/map/b.h > sim/map/c.h > sim/map/b.h"));
}

TEST(IncludeTable, FindsDeclarationsInANamespaceOfAFolderThatMayNotBeIncluded) {
  EXPECT_THAT(
      foreign_namespaces(kTable, {{"sim/map/a.h", "namespace robosim::map {"},
                                  {"sim/map/b.h", "namespace robosim::map {\nnamespace robosim::base {"},
                                  {"sim/base/x.h", "namespace robosim::base {"},
                                  {"sim/base/y.h", "namespace robosim::base {"},
                                  {"sim/base/z.h", "namespace robosim::map {\nclass Map;\n}"}}),
      ElementsAre("sim/base/z.h: opens the namespace map of sim/map, which sim/base may not include"));
}

TEST(IncludeTable, AllowsAFoldersOwnFilesAndItsRow) {
  EXPECT_THAT(broken_rules(kTable, {{"hal/arduino/Arduino.h", ""},
                                    {"firmware/src/motor.cpp", "#include \"motor.h\"\n#include <Arduino.h>"},
                                    {"firmware/src/motor.h", "#include \"nav/graph.h\""},
                                    {"firmware/src/nav/graph.h", "#include <stdint.h>"},
                                    {"sim/base/cli.cpp", "#include <CLI/CLI.hpp>"},
                                    {"sim/map/map.h", "#include \"sim/base/error.h\""},
                                    {"sim/base/error.h", "#include <string>"},
                                    {"tests/x.cpp", "#include \"sim/map/map.h\""}}),
              IsEmpty());
}

TEST(IncludeTable, NamesFileLineAndWhatIsAllowed) {
  EXPECT_THAT(
      broken_rules(kTable, {{"sim/base/error.h", "\n  #  include \"sim/map/map.h\""},
                            {"sim/map/map.h", "#include <Arduino.h>"},
                            {"hal/arduino/Arduino.h", ""}}),
      ElementsAre("sim/base/error.h:2: includes sim/map/map.h; sim/base may include, besides its own "
                  "files: nothing",
                  "sim/map/map.h:1: includes hal/arduino/Arduino.h; sim/map may include, besides its own "
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
  EXPECT_THAT(broken_rules(kTable, {{"sim/map/map.cpp", "#include <CLI/CLI.hpp>"}}),
              ElementsAre("sim/map/map.cpp:1: includes CLI/CLI.hpp; only these may: sim/base"));
}

TEST(IncludeTable, MissesFilesAndFolders) {
  EXPECT_THAT(
      broken_rules(kTable, {{"sim/map/map.cpp", "#include \"sim/base/gone.h\""}, {"sim/new/a.h", ""}}),
      ElementsAre("sim/map/map.cpp:1: includes sim/base/gone.h, which does not exist",
                  "sim/new/a.h: its folder has no row in the table"));
}

TEST(IncludeTable, ComplainsOfALineThatIsNoRow) {
  EXPECT_THROW(read_include_table("table", "sim/map sim/base\n"), InputError);
}

}  // namespace robosim::structure::include_table_test
