#include "sim/cli/run/source_text.h"

#include <gmock/gmock.h>

#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"

namespace robosim::cli::source_text_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr const char* kSketch = R"(#include <Servo.h>
const int FAST = 200, SLOW = FAST / 4;
#define LED 13
Encoders encoders(3, 2);
Walker walker(encoders, LED);
int speedFor(int off);
volatile long ticks = 0;
ISR(PCINT0_vect) { ticks++; }
void onEdge() { ticks = ticks + 1; }
void reset() { ticks = 0; }
void setup() {
  attachInterrupt(0, onEdge, RISING);
}
int speedFor(int off) {
  int sum;
  int found = 1;
  {
    sum += off;
  }
  return sum + found;
}
void loop() {
  walker.drive(SLOW);
  while (ticks < 5) {
  }
}
)";

class SourceTextTest : public ::testing::Test {
 protected:
  SourceTextTest() { write_file(folder_.path() / "My.ino", kSketch); }

  /// Calls explain() for a chain of causes. The chain consists of one cause, which names `lines` of My.ino.
  /// Returns the texts and line numbers of the causes that explain() adds to the chain.
  std::vector<std::pair<std::string, std::vector<int>>> added_to(std::vector<int> lines) {
    SourceText source(folder_.path(), {}, true);
    result::Cause cause{0.0, "in loop()", {}};
    for (const int line : lines) cause.lines.push_back({"", "My.ino", line});
    std::vector<result::Cause> chain = {cause};
    source.explain(chain);
    left_.clear();
    for (const result::SourceLine& line : chain[0].lines) left_.push_back(line.line);
    std::vector<std::pair<std::string, std::vector<int>>> added;
    for (std::size_t i = 1; i < chain.size(); ++i) {
      added.emplace_back(chain[i].text, std::vector<int>());
      for (const result::SourceLine& line : chain[i].lines) added.back().second.push_back(line.line);
    }
    return added;
  }

  test::TemporaryFolder folder_;
  std::vector<int> left_;  ///< lines of the chain's first cause after explain()
};

using Link = std::pair<std::string, std::vector<int>>;

TEST_F(SourceTextTest, NamesConstantsAndObjectsAndWhatTheseName) {
  EXPECT_THAT(added_to({23}), ElementsAre(Link("named in these lines", {5, 2, 4, 3})));
}

TEST_F(SourceTextTest, NamesConstantsOfClassesAndOfTheFilesBeside) {
  write_file(folder_.path() / "Robot.h", "struct Robot {\n  static constexpr int wheel = 32, LED = 9;\n};\n");
  write_file(folder_.path() / "Pins.h", "const int SPEAKER = 11;\nconst int BOTH = 1;\n");
  write_file(folder_.path() / "More.h", "const int BOTH = 2;\n");
  write_file(
      folder_.path() / "My.ino",
      "#define LED 13\nint turns(int mm) {\n  tone(SPEAKER, BOTH);\n  return LED * mm / Robot::wheel;\n}\n");
  SourceText source(folder_.path(), {}, true);
  std::vector<result::Cause> chain = {{0.0, "in turns()", {{"turns", "My.ino", 3}, {"turns", "My.ino", 4}}}};
  source.explain(chain);
  ASSERT_EQ(chain.size(), 2u);
  std::vector<std::string> named;
  for (const result::SourceLine& line : chain[1].lines)
    named.push_back(line.file + ":" + std::to_string(line.line));
  EXPECT_THAT(named, ElementsAre("Pins.h:1", "My.ino:1", "Robot.h:2"))
      << "names that two other files declare are omitted";
}

TEST_F(SourceTextTest, ReadsNoFileOutsideOfTheSketchesReach) {
  const std::filesystem::path library = folder_.path() / "Lib", sketch = library / "examples/My";
  const std::filesystem::path other = folder_.path() / "Arduino/Other";
  for (const std::filesystem::path& folder : {sketch, other}) std::filesystem::create_directories(folder);
  write_file(library / "Lib.h", "int inLibrary;\n");
  write_file(folder_.path() / "Secret.txt", "hunter2\n");
  write_file(folder_.path() / "Arduino/Secret.txt", "hunter2\n");
  const result::SourceLine in_library{"", "Lib.h", 1}, secret{"", "Secret.txt", 1};
  EXPECT_EQ(SourceText(sketch, {}, true).line(in_library), "int inLibrary;") << "the library of an example";
  EXPECT_EQ(SourceText(sketch, {}, false).line(in_library), "") << "a stranger's example";
  for (const bool trusted : {true, false}) EXPECT_EQ(SourceText(other, {}, trusted).line(secret), "");
}

TEST_F(SourceTextTest, TakesNoFunctionForAnObject) { EXPECT_THAT(added_to({14}), IsEmpty()); }

TEST_F(SourceTextTest, NamesTheHandlersThatWriteAVariableAndWhereTheyAreAttached) {
  EXPECT_THAT(added_to({24}), ElementsAre(Link("an interrupt handler writes ticks", {8, 9, 12})));
}

TEST_F(SourceTextTest, NamesAVariableOfTheFunctionThatBeginsWithoutAValue) {
  EXPECT_THAT(added_to({20}), ElementsAre(Link("declared without a value", {15})));
}

TEST_F(SourceTextTest, LeavesOutLinesThatSayNothingButTheNearest) {
  added_to({14, 22, 19, 18});
  EXPECT_THAT(left_, ElementsAre(14, 18));
}

TEST_F(SourceTextTest, ALinkOutOfTheProjectHasNoLines) {
  const std::filesystem::path project = folder_.path() / "project", sketch = project / "sketch";
  std::filesystem::create_directories(sketch);
  write_file(project / "pid.h", "int kp;\n");
  write_file(folder_.path() / "secret.txt", "hunter2\n");
  std::filesystem::create_symlink("../pid.h", sketch / "shared.h");
  std::filesystem::create_symlink("../../secret.txt", sketch / "link.h");
  SourceText source(sketch, {}, true);
  EXPECT_EQ(source.line({"", "link.h", 1}), "");
  EXPECT_EQ(source.line({"", "shared.h", 1}), "int kp;") << "compilers also read this file";
}

TEST_F(SourceTextTest, TakesNoLineForLongHoweverItIsMade) {
  const std::string table(200'000, '1');
  std::string types = "T";
  for (int i = 0; i < 60; ++i) types += " a<b>";
  for (const std::string& line : {"int " + table + "(1);", types + " x!", types + " {",
                                  "int x(" + table + ") {", "const int A[] = {" + table + "}, B = 2;"}) {
    write_file(folder_.path() / "My.ino", line + "\n" + kSketch);
    EXPECT_THAT(added_to({24}), ElementsAre(Link("named in these lines", {6, 3, 5, 4})));
  }
}

}  // namespace robosim::cli::source_text_test
