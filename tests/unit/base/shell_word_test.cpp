#include "sim/base/shell_word.h"

#include <gtest/gtest.h>

namespace robosim::shell_word_test {

TEST(ShellWords, AreThoseThatACommandWasMadeOf) {
  const std::vector<std::string> words{"robosim",     "run", "./Zoë's <b>", "--send",
                                       "a \"b\" \\n", "",    "''",          "é=%"};
  std::string command;
  for (const std::string& word : words) command += (command.empty() ? "" : " ") + shell_word(word);
  EXPECT_EQ(shell_words(command), words);
  EXPECT_EQ(shell_words("  a   b "), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(shell_words("a 'b"), std::nullopt);
}

}  // namespace robosim::shell_word_test
