#include "tests/unit/structure/hidden_functions.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <set>

namespace robosim::structure::hidden_functions_test {

using testing::ElementsAre;
using testing::IsEmpty;

const std::set<std::string> kLibraries = {"sim/build", "sim/build/project", "sim/launch"};
const std::string kHeader = "/// Adds.\nvoid add(Sum& sum, int more);\n";
const std::string kOwn = "namespace {\n\nvoid add(Words& words, Word more) {\n}\n\n}  // namespace\n";
const std::string kCalls = "#include \"sim/build/sum.h\"\nvoid f() {\n  add(sum, 2);\n}\n";

TEST(Functions, OfOneSourceHideNoneThatAnotherMeans) {
  Files libraries = read_sources(ROBOSIM_SOURCE_DIR);
  std::erase_if(libraries, [](const auto& file) {
    return !file.first.starts_with("sim/") && !file.first.starts_with("hal/board/");
  });
  EXPECT_TRUE(libraries.count("sim/base/error.h"));
  std::set<std::string> folders;
  const std::filesystem::path root = ROBOSIM_SOURCE_DIR;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "sim")) {
    if (entry.path().filename() == "CMakeLists.txt")
      folders.insert(entry.path().parent_path().lexically_relative(root).string());
  }
  EXPECT_TRUE(folders.count("sim/map/course"));
  for (const std::string& sentence : hidden_functions(libraries, folders)) ADD_FAILURE() << sentence;
}

TEST(HiddenFunctions, AreAHeadersThatAnotherSourceOfTheLibraryCalls) {
  EXPECT_THAT(
      hidden_functions(
          {{"sim/build/sum.h", kHeader}, {"sim/build/a.cpp", kOwn}, {"sim/build/deep/b.cpp", kCalls}},
          kLibraries),
      ElementsAre("sim/build/a.cpp: its own add() may be called by sim/build/deep/b.cpp, which means that of "
                  "sim/build/sum.h, where both are compiled as one file"));
}

TEST(HiddenFunctions, AreFoundBehindOtherIncludesAndInAnyExpression) {
  for (const char* line : {"  return add(s, 1);", "  if (1 > add(s, 1)) {", "  x = *add(s, 1) && add(t, 1);",
                           "  f(add(s, 1));", "    add(s, 1);"}) {
    EXPECT_EQ(hidden_functions({{"sim/build/sum.h", kHeader},
                                {"sim/build/all.h", "#include \"sim/build/sum.h\""},
                                {"sim/build/a.cpp", kOwn},
                                {"sim/build/b.cpp", std::string("#include \"sim/build/all.h\"\n") + line}},
                               kLibraries)
                  .size(),
              1u)
        << line;
  }
}

TEST(HiddenFunctions, AreNotThoseOfOtherLibrariesNorThoseThatNobodyElseCalls) {
  const Files files = {{"sim/build/sum.h", kHeader}, {"sim/build/a.cpp", kOwn}};
  const auto with = [&](const char* file, const std::string& content) {
    Files all = files;
    all[file] = content;
    return hidden_functions(all, kLibraries);
  };
  EXPECT_THAT(with("sim/launch/b.cpp", kCalls), IsEmpty());
  EXPECT_THAT(with("sim/build/project/b.cpp", kCalls), IsEmpty());
  EXPECT_THAT(with("sim/build/b.cpp", "void f() {\n  add(sum, 2);\n}\n"), IsEmpty())
      << "b.cpp includes nothing";
  EXPECT_THAT(with("sim/build/b.cpp", kOwn + kCalls), IsEmpty()) << "b.cpp calls its own function";
  for (const char* line :
       {"void add(Sum& sum, int more) {", "  void add(int more);", "  Sum& add(int more) {", "  list.add(2);",
        "  list->add(2);", "  other::add(2);", "  // see add(sum, 2)"})
    EXPECT_THAT(with("sim/build/b.cpp", std::string("#include \"sim/build/sum.h\"\n") + line), IsEmpty())
        << line;
}

}  // namespace robosim::structure::hidden_functions_test
