// Tests the output of `robosim completion` in bash, and of `robosim man` in groff.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/system/command.h"

namespace robosim::test {
namespace cli_help_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Returns bash's completions of these words, the last of which is incomplete.
std::string offered(const std::vector<std::string>& words) {
  const Folder folder;
  folder.write("bash", robosim_command({"completion", "bash"}).out);
  folder.write("mine.map", "");
  std::string script = "source ./bash\nCOMP_WORDS=(robosim";
  for (const std::string& word : words) script += " '" + word + "'";
  script +=
      ")\nCOMP_CWORD=" + std::to_string(words.size()) + "\n_robosim\nprintf ' %s' \"${COMPREPLY[@]}\"\n";
  return robosim_command({"-c", script}, folder.path(), nullptr, "/dev/null", "/bin/bash").out + " ";
}

TEST(CompletionOfBash, OffersCommandsAndActions) {
  EXPECT_EQ(offered({"sw"}), " sweep ");
  EXPECT_THAT(offered({"map", "ch"}), HasSubstr(" check "));
  EXPECT_THAT(offered({""}), HasSubstr(" classic "));
}

TEST(CompletionOfBash, OffersOptionsOfTheCommandOnly) {
  EXPECT_EQ(offered({"run", "--vi"}), " --view ");
  EXPECT_EQ(offered({"map", "graph", "--do"}), " --dot ");
  EXPECT_THAT(offered({"map", "check", "--"}), Not(HasSubstr("--dot")));
}

TEST(CompletionOfBash, OffersTheValuesOfAnOption) {
  EXPECT_EQ(offered({"run", "--target", "a"}), " avr ");
  EXPECT_EQ(offered({"run", "--target", "=", "st"}), " stm32 ") << "bash splits --target=st";
  EXPECT_EQ(offered({"run", "--goal", "la"}), " laps: ");
  EXPECT_THAT(offered({"run", "--map", "ov"}), HasSubstr(" oval "));
  EXPECT_EQ(offered({"run", "--map", "mi"}), " mine.map ") << "a file";
  EXPECT_THAT(offered({"sweep", "--robot", "uno3", "uno5", "un"}), HasSubstr(" uno2 "))
      << "a list may have further words";
}

TEST(CompletionOfBash, OffersArguments) {
  EXPECT_THAT(offered({"run", "Pid"}), HasSubstr(" PidFollower "));
  EXPECT_THAT(offered({"map", "show", "ov"}), HasSubstr(" oval "));
  EXPECT_THAT(offered({"completion", "z"}), HasSubstr(" zsh "));
}

TEST(ManPages, AreWrittenForAllCommands) {
  const Folder folder;
  EXPECT_EQ(robosim_command({"man", "--out", "pages"}, folder.path()).status, 0);
  for (const char* page : {"robosim.1", "robosim-run.1", "robosim-map.1", "robosim-help.1"})
    EXPECT_TRUE(std::filesystem::exists(folder / "pages" / page)) << page;
  EXPECT_EQ(read_file(folder / "pages" / "robosim-run.1"), robosim_command({"man", "run"}).out);
}

TEST(ManPages, AreGoodTroff) {
  if (!std::filesystem::exists("/usr/bin/groff")) GTEST_SKIP() << "groff is missing: sudo apt install groff";
  const Folder folder;
  for (const char* command : {"", "run", "map", "classic"}) {
    const auto words = *command ? std::vector<std::string>{"man", command} : std::vector<std::string>{"man"};
    const auto page = folder.write("page.1", robosim_command(words).out);
    const Ended ended = robosim_command({"-man", "-ww", "-Tutf8", "-Kutf8", "-P-cbou", page.string()},
                                        folder.path(), nullptr, "/dev/null", "/usr/bin/groff");
    EXPECT_EQ(ended.status, 0);
    EXPECT_THAT(ended.err, IsEmpty());
    EXPECT_THAT(ended.out, HasSubstr("EXIT STATUS"));
  }
}

}  // namespace cli_help_test
}  // namespace robosim::test
