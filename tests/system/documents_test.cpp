// Tests that every command of README.md and docs runs as written in a clone, and prints the page's output.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/system/command.h"
#include "tests/system/console_blocks.h"

namespace robosim::test {
namespace documents_test {

namespace fs = std::filesystem;

TEST(ConsoleBlocks, HaveCommandsOutputsAndStatuses) {
  const ConsolePage page = read_console_blocks(
      "<!-- setup: touch a -->\n```console status 1\n$ ls\na\n\n$ false\n```\n$ text\n```\n$ no\n```\n"
      "```console not run: needs a board\n$ robosim flash\n```\n");
  ASSERT_EQ(page.commands.size(), 3u);
  EXPECT_TRUE(page.commands[0].is_setup);
  EXPECT_EQ(page.commands[1].command, "ls");
  EXPECT_EQ(page.commands[1].output, "a\n\n");
  EXPECT_EQ(page.commands[1].status, 0);
  EXPECT_EQ(page.commands[2].line, 6);
  EXPECT_EQ(page.commands[2].status, 1);
  EXPECT_EQ(page.outside, std::vector<int>{10});
  const ConsoleCommand both = read_console_blocks("```console gcc 12 status 1\n$ no\n```\n").commands.at(0);
  EXPECT_EQ(both.gcc, 12);
  EXPECT_EQ(both.status, 1);
  EXPECT_THROW(read_console_blocks("```console quickly\n"), std::invalid_argument);
  EXPECT_THROW(read_console_blocks("```console status\n"), std::invalid_argument);
}

TEST(ConsoleBlocks, ShowTheOutputOrPartsOfIt) {
  EXPECT_TRUE(shows("a\n\nb\n", "\na  \n\nb\n\n"));
  EXPECT_TRUE(shows("", "anything"));
  EXPECT_TRUE(shows("…\nlap … s\n…\n", "x\ny\nlap 8.5 s\nz\n"));
  EXPECT_TRUE(shows("a\n…\nb\n", "a\nb\n"));
  EXPECT_FALSE(shows("a\n", "a\nb\n"));
  EXPECT_FALSE(shows("…\nlap … s\n", "lap 8.5 m\n"));
  EXPECT_FALSE(shows("a\n…\nb\n", "a\n"));
}

std::vector<std::string> pages() {
  std::vector<std::string> found{"README.md"};
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ROBOSIM_CHECKOUT) / "docs"))
    if (entry.path().extension() == ".md")
      found.push_back(entry.path().lexically_relative(ROBOSIM_CHECKOUT).string());
  std::sort(found.begin(), found.end());
  return found;
}

/// Creates a newcomer's environment: a clone to work in, and `robosim` on the PATH.
void make_clone(const Folder& clone, const Folder& programs) {
  for (const auto& entry : fs::directory_iterator(ROBOSIM_CHECKOUT))
    if (const std::string name = entry.path().filename();
        name != "build" && name != "robosim" && name[0] != '.')
      fs::create_symlink(entry.path(), clone / name);
  fs::create_symlink(ROBOSIM_COMMAND, programs / "robosim");
}

struct Outcome {
  int status = -1;
  std::string output;
};

/// Runs the commands in one shell. If a command ends the shell, the later commands have no outcomes.
std::vector<Outcome> run_all(const std::vector<ConsoleCommand>& commands, const fs::path& folder,
                             const fs::path& programs) {
  constexpr char kMark = '\x1e';
  std::string script =
      "export CHECKOUT='" ROBOSIM_CHECKOUT "' PATH='" + programs.string() + "':\"$PATH\" TERM=dumb\n";
  script += "unset ROBOSIM_WRAPPER\n";
  for (const ConsoleCommand& command : commands) script += command.command + "\nprintf '\\036%d\\n' $?\n";
  const Folder files;
  const fs::path file = files.write("commands.sh", script);
  const Ended ended = robosim_command({"-c", "exec bash \"$0\" 2>&1", file.string()}, folder, nullptr,
                                      "/dev/null", "/bin/bash");
  std::vector<Outcome> outcomes;
  std::size_t begin = 0;
  for (std::size_t mark; (mark = ended.out.find(kMark, begin)) != std::string::npos;) {
    const std::size_t end = ended.out.find('\n', mark);
    outcomes.push_back({std::stoi(ended.out.substr(mark + 1)), ended.out.substr(begin, mark - begin)});
    begin = end + 1;
  }
  return outcomes;
}

/// Returns the major version of the gcc that compiles sketches for the host.
int gcc_version(const fs::path& folder) {
  return std::stoi(robosim_command({"-dumpversion"}, folder, nullptr, "/dev/null", "/usr/bin/gcc").out);
}

class DocumentsTest : public ::testing::TestWithParam<std::string> {};

TEST_P(DocumentsTest, EveryCommandRunsAsItIsWritten) {
  const std::string page = GetParam();
  const ConsolePage blocks = read_console_blocks(read_file(fs::path(ROBOSIM_CHECKOUT) / page));
  for (const int line : blocks.outside)
    ADD_FAILURE() << page << ":" << line << ": this command never runs; its block must begin with ```console";
  if (blocks.commands.empty()) return;
  const Folder clone, programs;
  make_clone(clone, programs);
  const std::vector<Outcome> outcomes = run_all(blocks.commands, clone.path(), programs.path());
  ASSERT_EQ(outcomes.size(), blocks.commands.size()) << page;
  constexpr int kToolMissing = 5;
  const int gcc = gcc_version(clone.path());
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const ConsoleCommand& shown = blocks.commands[i];
    if (outcomes[i].status == kToolMissing && shown.status != kToolMissing && !std::getenv("ROBOSIM_REQUIRE"))
      GTEST_SKIP() << outcomes[i].output;
    EXPECT_EQ(outcomes[i].status, shown.status)
        << page << ":" << shown.line << ": $ " << shown.command << "\n"
        << outcomes[i].output;
    EXPECT_TRUE((shown.gcc != 0 && shown.gcc != gcc) || shows(shown.output, outcomes[i].output))
        << page << ":" << shown.line << ": $ " << shown.command << "\nprints\n"
        << outcomes[i].output;
  }
}

/// Returns the page's name in letters, digits and underscores, as gtest requires.
std::string name_of(const ::testing::TestParamInfo<std::string>& page) {
  std::string name = page.param;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Pages, DocumentsTest, ::testing::ValuesIn(pages()), name_of);

}  // namespace documents_test
}  // namespace robosim::test
