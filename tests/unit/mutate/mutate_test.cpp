// Tests finding the mutations of a sketch in clang's syntax tree, and editing the sketch.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <map>
#include <set>

#include "sim/base/file.h"
#include "sim/base/program_sandbox.h"
#include "sim/campaign/mutate/operators.h"
#include "tests/support/require_target.h"
#include "tests/support/temporary_folder.h"

namespace robosim::mutate {
namespace mutate_test {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

const Mutation& first_of(const std::vector<Mutation>& all, const std::string& kind) {
  for (const Mutation& one : all)
    if (one.kind == kind) return one;
  throw std::runtime_error("none is " + kind);
}

TEST(Edits, AreMadeFromTheLastToTheFirst) {
  EXPECT_EQ(changed("int a = a + b;", {{"", 4, 5, "other"}, {"", 8, 9, "other"}}), "int other = other + b;");
}

// In clang's syntax tree, a location names its file only if the previous location has another file. The
// declarations in other files come from included code.
TEST(SyntaxTree, NamesTheFileOfEachPlaceAndLeavesOutDeclarationsOfOthers) {
  const auto tree = read_tree(
      R"({"kind": "TranslationUnitDecl", "loc": {}, "inner": [
        {"name": "theirs", "loc": {"offset": 3, "file": "/lib.h", "tokLen": 6, "includedFrom": {"file": "/own.cpp"}}},
        {"name": "theirs_too", "loc": {"offset": 30, "tokLen": 6}},
        {"name": "own", "loc": {"offset": 7, "file": "/own.cpp", "tokLen": 3},
         "inner": [{"range": {"begin": {"offset": 9, "tokLen": 1}, "end": {"offset": 10, "tokLen": 1}}}]}]})",
      [](const std::string& file) { return file == "/own.cpp" ? 0 : -1; });
  ASSERT_EQ(tree["inner"].size(), 1u);
  EXPECT_EQ(tree["inner"][0]["name"], "own");
  EXPECT_EQ(tree["inner"][0]["inner"][0]["range"]["end"]["in"], 0);
}

/// A sketch in a temporary folder, which clang parses.
class Sketch : public testing::Test {
 protected:
  void SetUp() override {
    ROBOSIM_NEEDS_TARGET("host");
    ROBOSIM_NEEDS_CLANG();
    std::filesystem::create_directory(folder_ / "S");
  }

  void file(const std::string& name, const std::string& text) { write_file(folder_ / "S" / name, text); }
  Tree tree() { return parse(build::parse_context_of({folder_ / "S", *find_board("uno")})); }

  /// Returns the mutations of the file `name`, in the form "relational < -> <=".
  std::multiset<std::string> changes(const std::string& name) {
    std::multiset<std::string> all;
    for (const Mutation& one : mutations(tree()))
      if (one.edits[0].file == name) all.insert(one.kind + ' ' + one.was + " -> " + one.now);
    return all;
  }

  const test::TemporaryFolder temporary_;
  const std::filesystem::path folder_ = temporary_.path();
};

TEST_F(Sketch, IsAllThatClangSees) {
  if (!ProgramSandbox::missing().empty()) GTEST_SKIP() << ProgramSandbox::missing();
  file("S.ino", "void setup() {}\nvoid loop() {}\n");
  write_file(folder_ / "secret", "hunter2\n");
  std::filesystem::create_directory(folder_ / "bin");
  write_file(folder_ / "bin/clang++",
             fmt::format("#!/bin/sh\ncat {0}/secret >{0}/seen\n"
                         "echo '{{\"kind\": \"TranslationUnitDecl\", \"inner\": []}}'\n",
                         folder_.string()));
  std::filesystem::permissions(folder_ / "bin/clang++", std::filesystem::perms::owner_all);
  const std::string path = ::getenv("PATH");
  ::setenv("PATH", fmt::format("{}:{}", (folder_ / "bin").string(), path).c_str(), 1);
  tree();
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "seen"));
}

TEST_F(Sketch, HasAMutationForEachOperatorAtItsPlace) {
  file("S.ino",
       "volatile int edges = 0;\n"
       "void setup() { pinMode(3, OUTPUT); Serial.println(F(\"on\")); }\n"
       "void loop() {\n"
       "  if (low(edges) && millis() > 100UL) edges += 2;  // < this is no operator\n"
       "}\n"
       "bool low(int v) { return v < 10; }\n");
  EXPECT_THAT(changes("S.ino"),
              IsSupersetOf({"storage volatile -> ", "type int -> int8_t", "constant 0 -> 1",
                            "statement pinMode(3, OUTPUT) -> ", "storage F(\"on\") -> \"on\"",
                            "logic && -> ||", "relational > -> >=", "relational > -> <",
                            "constant 100UL -> 101UL", "constant 100UL -> 200UL",
                            "arithmetic += -> -=", "statement edges += 2 -> ", "returned v < 10 -> !(v < 10)",
                            "relational < -> <=", "constant 10 -> 9", "constant 3 -> 4"}));
  EXPECT_THAT(changes("S.ino"), Not(Contains("arguments 3, OUTPUT -> OUTPUT, 3")))
      << "the arguments have different types";
}

TEST_F(Sketch, IsChangedAtTheLineThatIsSaidInEachOfItsFiles) {
  file("S.ino", "#include \"wheel.h\"\nWheel left;\nvoid setup() { go(left); }\n");
  file("b.ino", "\r\nvoid go(Wheel& wheel) {\r\n  wheel.turn(7, 8);\r\n}\r\nvoid loop() {}\r\n");
  file("wheel.h",
       "#pragma once\nstruct Wheel {\n  void turn(int a, int b) { sum = a - b; }\n  long sum = 0;\n};\n");
  file("wheel.cpp", "#include <Arduino.h>\n#include \"wheel.h\"\n");
  const std::vector<Mutation> all = mutations(tree());
  const Mutation swapped = first_of(all, "arguments");
  EXPECT_EQ(swapped.edits[0].file, "b.ino");
  EXPECT_EQ(swapped.line, 3);
  EXPECT_EQ(changed("\r\nvoid go(Wheel& wheel) {\r\n  wheel.turn(7, 8);\r\n}\r\n", swapped.edits),
            "\r\nvoid go(Wheel& wheel) {\r\n  wheel.turn(8, 7);\r\n}\r\n");
  EXPECT_EQ(changes("wheel.h").count("arithmetic - -> +"), 1u) << "once, though two sources include it";
  EXPECT_EQ(first_of(all, "arithmetic").line, 3);
}

TEST_F(Sketch, IsLeftAloneInMacrosAndInHeadersOfOthers) {
  file("S.ino", "#define TWICE(x) ((x) * 2)\nvoid setup() { analogWrite(5, TWICE(40)); }\nvoid loop() {}\n");
  for (const std::string& one : changes("S.ino")) EXPECT_THAT(one, Not(testing::HasSubstr("* ")));
  for (const Mutation& one : mutations(tree())) EXPECT_EQ(one.edits[0].file, "S.ino");
}

TEST_F(Sketch, HasThoseOfItsLibrariesThatAreAskedFor) {
  file("S.ino", "#include <Scale.h>\nvoid setup() { doubled(4); halved(4); }\nvoid loop() {}\n");
  std::filesystem::create_directories(folder_ / "S/libraries/Scale");
  file("libraries/Scale/Scale.h",
       "#pragma once\ninline int doubled(int v) { return v + v; }\nint halved(int v);\n");
  file("libraries/Scale/Scale.cpp", "#include \"Scale.h\"\nint halved(int v) { return v / 2; }\n");
  EXPECT_EQ(first_of(mutations(tree()), "constant").edits[0].file, "S.ino");
  const std::filesystem::path library = std::filesystem::canonical(folder_ / "S/libraries/Scale");
  std::multiset<std::string> places;
  for (const Mutation& one : mutations(parse(build::parse_context_of({folder_ / "S", *find_board("uno")}),
                                             {library / "Scale.h", library / "Scale.cpp"})))
    if (one.kind == "arithmetic") places.insert(where(one) + ' ' + one.now);
  EXPECT_THAT(places, ElementsAre((library / "Scale.cpp").string() + ":2 *",
                                  (library / "Scale.h").string() + ":2 -"));
}

TEST_F(Sketch, HasHarmlessChanges) {
  file("S.ino",
       "void setup() {\n  pinMode(3, OUTPUT);\n  pinMode(4, OUTPUT);\n}\n"
       "void loop() {\n  int sum = 1;\n  sum += sum;\n  analogWrite(3, min(sum, 9));\n}\n");
  const std::vector<Mutation> all = controls(tree());
  EXPECT_EQ(first_of(all, "order").now, "pinMode(4, OUTPUT);\n  pinMode(3, OUTPUT)");
  EXPECT_EQ(first_of(all, "delay").now, "{ delay(1);");
  for (const Mutation& one : all) EXPECT_NE(one.kind, "name") << "the macro also uses sum";
}

TEST_F(Sketch, HasALocalVariableThatMayHaveAnotherName) {
  const std::string text = "void setup() {}\nint sum = 5;\nvoid loop() {\n  int sum = 1;\n  sum += sum;\n}\n";
  file("S.ino", text);
  EXPECT_EQ(
      changed(text, first_of(controls(tree()), "name").edits),
      "void setup() {}\nint sum = 5;\nvoid loop() {\n  int other_sum = 1;\n  other_sum += other_sum;\n}\n");
}

}  // namespace mutate_test
}  // namespace robosim::mutate
