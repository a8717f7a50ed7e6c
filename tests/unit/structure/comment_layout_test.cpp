#include "tests/unit/structure/comment_layout.h"

#include <gmock/gmock.h>

#include "sim/base/file.h"

namespace robosim::structure::comment_layout_test {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string kRoot = ROBOSIM_SOURCE_DIR;
constexpr std::size_t kLimit = 40;  // the column limit of the examples

/// Returns the ColumnLimit of .clang-format.
std::size_t column_limit() {
  const std::string key = "ColumnLimit: ", style = read_file(kRoot + "/.clang-format");
  const std::size_t at = style.find(key);
  return at == style.npos ? 0 : std::stoul(style.substr(at + key.size()));
}

/// Returns the numbers of the lines of `comment` that broken_rows() reports.
std::vector<std::string> broken_lines(const std::string& comment) {
  std::vector<std::string> lines;
  for (const std::string& message : broken_rows({{"a.h", comment}}, kLimit))
    lines.push_back(message.substr(4, message.find(':', 4) - 4));
  return lines;
}

TEST(Comments, KeepToTheColumnLimitOfTheFormatter) {
  Files sources = read_sources(kRoot);
  std::erase_if(sources, [](const auto& file) {
    return !file.first.ends_with(".h") && !file.first.ends_with(".cpp");  // not formatted
  });
  EXPECT_TRUE(sources.count("sim/base/error.h"));
  ASSERT_GT(column_limit(), 0u);
  for (const std::string& message : long_comments(sources, column_limit())) ADD_FAILURE() << message;
}

TEST(Comments, ContinueRowsOfTablesInTheirColumn) {
  for (const std::string& message : broken_rows(read_sources(kRoot), column_limit()))
    ADD_FAILURE() << message;
}

TEST(LongComments, AreCountedInCharactersAndNotInCode) {
  EXPECT_THAT(long_comments({{"a.h",
                              "// 0123456789\n"
                              "int i;  // 45\n"
                              "/// ── ►\n"
                              "int j = 0123456;\n"
                              "f(\"// 6789\");\n"}},
                            10),
              ElementsAre("a.h:1: a comment line has 13 columns; at most 10 are allowed",
                          "a.h:2: a comment line has 13 columns; at most 10 are allowed"));
}

TEST(BrokenRows, HaveTheirRestAtTheLabelsColumn) {
  EXPECT_THAT(
      broken_rows({{"a.h",
                    "//   gyro    z: the robot's turn rate +\n"
                    "//   noise;\n"
                    "//           131 LSB/(deg/s)\n"}},
                  kLimit),
      ElementsAre("a.h:2: the rest of a row starts at column 6: expected column 14, below the row's last "
                  "cell"));
  EXPECT_THAT(broken_lines("//   begin()   notes what runs from now\n"
                           "//   on\n"
                           "//             in this run\n"),
              ElementsAre("2"))
      << "before a line at the right column";
  EXPECT_THAT(broken_lines("  ///   bytes()   made before: look there\n"
                           "  ///   again\n"
                           "  /// Then the rest.\n"),
              ElementsAre("2"))
      << "at the end of a table";
  EXPECT_THAT(broken_lines("//   others   the oscillator's (a crystal\n"
                           "//   16384 cycles)\n"),
              ElementsAre("2"))
      << "in a bracket";
  EXPECT_THAT(broken_lines("//   duty = over / full;  brake = 1 -\n"
                           "//   |duty|\n"),
              ElementsAre("2"))
      << "after an operator";
}

TEST(BrokenRows, AreJoinedWithTheNextRow) {
  EXPECT_THAT(broken_lines("//   records    one pass from its head on\n"
                           "//   is skips      if all is as it was\n"),
              ElementsAre("2"));
  EXPECT_THAT(broken_lines("//   UDINT    end of reset, while UDIEN has\n"
                           "//   them UENUM    selects the endpoint\n"),
              ElementsAre("2"));
}

TEST(BrokenRows, ContinueBetweenTwoCells) {
  EXPECT_THAT(broken_lines("//   cost(Id)       of that line;\n"
                           "//               1 without room\n"),
              ElementsAre("2"));
}

TEST(BrokenRows, AreInCodeAndDrawingsToo) {
  EXPECT_THAT(broken_lines("///   Navigator navigator(bfs<Network,\n"
                           "///   Work>());\n"),
              ElementsAre("2"));
  EXPECT_THAT(broken_lines("//   attached ──► line coding (115200\n"
                           "//   8N1), DTR\n"),
              ElementsAre("2"));
}

TEST(BrokenRows, AreNotWhatTablesMayHave) {
  EXPECT_THAT(broken_lines("//   gyro    z: the robot's turn rate, and\n"
                           "//           noise\n"
                           "//   temperature  25 degrees\n"),
              IsEmpty())
      << "text at the last cell's column, and a label that is too wide";
  EXPECT_THAT(broken_lines("//   start tile   when it is left: points\n"
                           "//   each tile up to a checkpoint\n"
                           "//                5 points\n"),
              IsEmpty())
      << "a label on a line of its own";
  EXPECT_THAT(broken_lines("//   if (run.go_on(5)) {   // it stands still\n"
                           "//   run.end();\n"),
              IsEmpty())
      << "code without a remark";
  EXPECT_THAT(broken_lines("//   m a = F,   I alpha = (F - G) track / 2\n"
                           "//   F^2 + S^2 <= 4\n"),
              IsEmpty())
      << "two formulas";
  EXPECT_THAT(broken_lines("//   WGM4   of PWM: 0 fast: up and then to\n"
                           "//                  1 correct: up and down\n"),
              IsEmpty())
      << "a list in a cell";
  EXPECT_THAT(broken_lines("//    aaa        pins a to g\n"
                           "//   f   b       common anode\n"
                           "//    ggg\n"
                           "//   o           a wheel\n"
                           "//       o\n"),
              IsEmpty())
      << "a picture";
  EXPECT_THAT(broken_lines("//   kp   gain of the error,\n"
                           "//   ki\n"),
              IsEmpty())
      << "rows with space left";
  EXPECT_THAT(broken_lines("//   Steering. It turns with steering * e\n"
                           "//   (rad/s, clockwise), so that (after a\n"
                           "//   while) it is over the line.\n"
                           "// Prose with a bracket that is open (and\n"
                           "// closed here).\n"),
              IsEmpty())
      << "prose";
  EXPECT_THAT(broken_lines("f();  // a row   that fills its line, and\n"
                           "// another comment\n"),
              IsEmpty())
      << "comments of different lines";
}

}  // namespace robosim::structure::comment_layout_test
