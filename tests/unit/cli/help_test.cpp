// Tests help texts, manual pages and shell completion, which are generated from one source. Also tests that
// they name facts such as the exit statuses.
#include "sim/cli/help.h"

#include <gmock/gmock.h>

#include <cctype>
#include <sstream>

#include "sim/base/error.h"
#include "sim/cli/arguments.h"
#include "sim/cli/completion.h"
#include "sim/cli/man_page.h"

namespace robosim::cli::help_test {

using ::testing::HasSubstr;

std::string printed(const std::vector<std::string>& words) {
  return std::get<PrintText>(parse_arguments(words)).text;
}

/// Returns all commands without actions, and all actions, such as `map check`.
std::vector<CommandHelp> leaves() {
  std::vector<CommandHelp> all;
  for (const CommandGroup& group : command_groups())
    for (const CommandHelp& command : group.commands) {
      if (command.actions.empty()) all.push_back(command);
      all.insert(all.end(), command.actions.begin(), command.actions.end());
    }
  return all;
}

std::vector<std::string> words_of(const std::string& name) {
  std::istringstream text(name);
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  return words;
}

TEST(Help, GroupsTheCommandsByTask) {
  std::vector<std::string> titles;
  for (const CommandGroup& group : command_groups()) titles.push_back(group.title);
  EXPECT_THAT(titles,
              testing::ElementsAre("Drive", "Look", "Test", "Robots and maps", "Stations", "This program"));
  for (const std::string& text : {printed({}), printed({"--help"})})
    for (const CommandGroup& group : command_groups()) {
      EXPECT_THAT(text, HasSubstr("\n" + group.title + "\n"));
      for (const CommandHelp& command : group.commands) {
        EXPECT_THAT(text, HasSubstr("\n  " + command.name + " "));
        EXPECT_THAT(text, HasSubstr(command.summary.substr(0, 20)));
      }
    }
}

TEST(Help, GivesEachCommandOneLine) {
  for (const CommandGroup& group : command_groups())
    for (const CommandHelp& command : group.commands)
      EXPECT_THAT(printed({}), HasSubstr(" " + command.summary + "\n")) << command.name;
}

TEST(Help, OfABareCommandBeginsWithExamples) {
  EXPECT_THAT(printed({}), HasSubstr("\n  robosim run PidFollower --map oval "));
  EXPECT_THAT(printed({}), HasSubstr("robosim help COMMAND"));
}

TEST(Help, IsTheSameByEveryWayToAskForIt) {
  EXPECT_EQ(printed({"-h"}), printed({"--help"}));
  EXPECT_EQ(printed({"help"}), printed({"--help"}));
  EXPECT_EQ(printed({"-V"}), printed({"--version"}));
  for (const CommandHelp& command : leaves()) {
    std::vector<std::string> words = words_of(command.name), asked = {"help"};
    asked.insert(asked.end(), words.begin(), words.end());
    words.push_back("--help");
    EXPECT_EQ(printed(asked), printed(words));
    words.back() = "-h";
    EXPECT_EQ(printed(asked), printed(words));
  }
  EXPECT_EQ(printed({"help", "map"}), printed({"map", "-h"}));
  EXPECT_EQ(printed({"run", "--map", "oval", "--help"}), printed({"run", "--help"}));
}

TEST(Help, OfACommandWithActionsListsThem) {
  EXPECT_THAT(printed({"map", "--help"}), HasSubstr("\n  map check MAP "));
  EXPECT_THAT(printed({"robot", "--help"}), HasSubstr("\n  robot list "));
}

TEST(Help, FitsInEightyColumns) {
  std::vector<std::string> texts{printed({}), printed({"--help"}), printed({"map", "--help"})};
  for (const CommandHelp& command : leaves()) texts.push_back(help_text(command));
  for (const std::string& text : texts) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
  }
}

/// Returns whether a help text seems to be incomplete without the line above it. A complete text begins with
/// a verb in the imperative. A text seems incomplete if it is empty or ends with a full stop. The same
/// holds if it begins with a capital letter or a word below.
bool leans_on_others(const std::string& text) {
  for (const char* word : {"of ", "the ", "a ", "as ", "is ", "that ", "with ", "for ", "where ", "which ",
                           "what ", "how ", "file", "folder", "default", "if ", "name,"})
    if (text.starts_with(word)) return true;
  return text.empty() || std::isupper(static_cast<unsigned char>(text[0])) ||
         (text.ends_with('.') && !text.ends_with("..."));
}

TEST(Help, BeginsEveryLineWithAVerb) {
  for (const CommandHelp& command : leaves()) {
    EXPECT_FALSE(leans_on_others(command.summary)) << command.name << ": " << command.summary;
    for (const auto* list : {&command.arguments, &command.options})
      for (const OptionHelp& option : *list)
        EXPECT_FALSE(leans_on_others(option.what))
            << command.name << " " << option.name << ": " << option.what;
  }
}

TEST(Help, NamesExitStatuses) {
  for (const char* status : {"  0  ", "  1  ", "  2  ", "  3  ", "  4  ", "  5  ", "  130  "})
    EXPECT_THAT(printed({"--help"}), HasSubstr(status));
}

TEST(ManPage, HasACommandsOptionsAndExitStatuses) {
  for (const CommandGroup& group : command_groups())
    for (const CommandHelp& command : group.commands) {
      const std::string page = man_page(command);
      EXPECT_THAT(page, HasSubstr("\nrobosim\\-" + command.name + " \\- "));
      EXPECT_THAT(page, HasSubstr(".SH EXIT STATUS\n"));
      for (const OptionHelp& option : command.options)
        EXPECT_THAT(page, HasSubstr("\\fB\\-\\-" + option.name.substr(2, 1)));
    }
  EXPECT_THAT(man_page(command_groups()), HasSubstr(".BR robosim\\-sweep (1)"));
}

TEST(ManPage, EscapesWhatTroffWouldTakeForARequest) {
  CommandHelp command{"x", "do x", "", {}, {{"--at", "T", ".5s \\n", {}}}, {}};
  EXPECT_THAT(man_page(command), HasSubstr("\n\\&.5s \\en\n"));
}

class Completion : public testing::TestWithParam<const char*> {};

TEST_P(Completion, KnowsEveryCommandAndOption) {
  const std::string code = completion(GetParam(), command_groups());
  const bool is_fish = std::string(GetParam()) == "fish";
  for (const CommandHelp& command : leaves()) {
    EXPECT_THAT(code, HasSubstr(words_of(command.name).back()));
    for (const OptionHelp& option : command.options)
      EXPECT_THAT(code, HasSubstr(is_fish ? " -l " + option.name.substr(2) : option.name));
  }
  for (const char* value : {"PidFollower", "oval", "uno5", "stm32", "drag-race", "typical@1", "dijkstra"})
    EXPECT_THAT(code, HasSubstr(value));
}

INSTANTIATE_TEST_SUITE_P(Shells, Completion, testing::Values("bash", "zsh", "fish"));

TEST(Completion, RefusesAnotherShell) {
  EXPECT_THROW(parse_arguments({"completion", "csh"}), InputError);
  EXPECT_THROW(parse_arguments({"completion"}), InputError);
}

}  // namespace robosim::cli::help_test
