#include "tests/unit/structure/documents.h"

#include <gmock/gmock.h>

namespace robosim::structure::documents_test {

using testing::ElementsAre;

const std::string kRoot = ROBOSIM_SOURCE_DIR;

TEST(Documents, NameOnlyFilesAndHeadingsThatExist) {
  const Files documents = read_documents(kRoot);
  EXPECT_TRUE(documents.count("README.md") && documents.count("docs/explanation/design.md"));
  for (const std::string& sentence : dead_references(documents, kRoot)) ADD_FAILURE() << sentence;
}

TEST(Documents, AreReadInEveryFolderBelowDocs) {
  const Files documents = read_documents(kRoot);
  EXPECT_TRUE(documents.count("CHANGELOG.md") && documents.count("docs/howto/install.md"));
}

TEST(Documents, NameOnlyFunctionsThatExist) {
  Files guides = read_documents(kRoot);
  std::erase_if(guides, [](const auto& file) {
    return file.first != "CONTRIBUTING.md" && file.first != "docs/explanation/design.md";
  });
  for (const std::string& sentence : dead_functions(guides, read_sources(kRoot))) ADD_FAILURE() << sentence;
}

TEST(Documents, NameOnlyTestsThatExist) {
  Files pages = read_documents(kRoot);
  std::erase_if(pages, [](const auto& file) { return !file.first.starts_with("docs/evidence/"); });
  EXPECT_TRUE(pages.count("docs/evidence/sentences.md"));
  for (const std::string& sentence : dead_tests(pages, read_sources(kRoot))) ADD_FAILURE() << sentence;
}

TEST(Documents, AreThereWhenSourcesNameThem) {
  Files sources = read_sources(kRoot);
  std::erase_if(sources, [](const auto& file) { return file.first.starts_with("tests/unit/structure/"); });
  for (const std::string& sentence : dead_mentions(sources, kRoot)) ADD_FAILURE() << sentence;
}

TEST(References, ToAMissingFileOrHeadingAreDead) {
  EXPECT_THAT(dead_references({{"docs/a.md",
                                "# One `two`, three\n[b](b.md) [r](../README.md) [x](#one-two-three)\n"
                                "[y](#two) [web](https://x.org/y.md)\n"}},
                              kRoot),
              ElementsAre("docs/a.md:2: links to docs/b.md, which does not exist",
                          "docs/a.md:3: links to docs/a.md, which has no heading 'two'"));
}

TEST(References, InBackticksAreDeadIfThePathDoesNotExist) {
  EXPECT_THAT(dead_references({{"README.md",
                                "`sim/base/error.h` `sim/gone.h:12` `make sim/away`, but not `x/y.h`\n"
                                "```\nrobosim run docs/mine/Sketch\n```\n"}},
                              kRoot),
              ElementsAre("README.md:1: names sim/gone.h, which does not exist",
                          "README.md:1: names sim/away, which does not exist"));
  EXPECT_THAT(
      dead_references({{"README.md", "`docs/*.md`, `tests/`, `tests/NAME.cpp`, `tests/unit/ROOM`"}}, kRoot),
      ElementsAre("README.md:1: names tests/unit/ROOM, which does not exist"));
}

TEST(References, ToAFunctionThatNoSourceHasAreDead) {
  EXPECT_THAT(dead_functions({{"a.md", "`Floor::coverage()`, `gone()`, `read_NAME()`, not `sin(x)`"}},
                             {{"sim/x.h", "double coverage(Vec2 p) const;"}}),
              ElementsAre("a.md: names `gone()`, which no source contains"));
}

TEST(References, ToATestThatNoSourceHasAreDead) {
  EXPECT_THAT(dead_tests({{"a.md", "`Suite.IsThere`, `Suite.Gone`, not `Serial.print`"}},
                         {{"tests/x.cpp", "TEST_F(Suite,\n       IsThere) {}"}}),
              ElementsAre("a.md: names the test `Suite.Gone`, and no source has it"));
}

TEST(References, OfSourcesAreDeadIfThePageIsGone) {
  EXPECT_THAT(
      dead_mentions({{"sim/x.h", "// docs/explanation/design.md, docs/gone.md, docs/howto/gone.md"}}, kRoot),
      ElementsAre("sim/x.h: names docs/gone.md, which does not exist",
                  "sim/x.h: names docs/howto/gone.md, which does not exist"));
}

}  // namespace robosim::structure::documents_test
