// Reads the commands of a Markdown page, and the output that the page promises.
//
//   ```console                  runs commands one after another, in one shell for each page
//   $ robosim new demo          a command
//   1 sketch                    the output, with standard error; if none is shown, only the status counts
//   …                           any number of lines; within a line, any text
//   ```
//   ```console status 1         the last command of the block ends with status 1
//   ```console gcc 12           this output requires gcc 12; `gcc 12` may precede `status 1`
//   ```console not run: REASON  is not run, only displayed
//   <!-- setup: COMMAND -->     runs, but readers do not see it
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robosim::test {

struct ConsoleCommand {
  int line = 0;         ///< in the page, from 1
  std::string command;  ///< without "$ "
  std::string output;   ///< as on the page; empty = any
  int status = 0;       ///< the expected status
  int gcc = 0;          ///< the version of gcc that gives this output; 0 = any
  bool is_setup = false;
};

struct ConsolePage {
  std::vector<ConsoleCommand> commands;  ///< in the order of the page
  std::vector<int> outside;              ///< lines with "$ " in a block of another kind, from 1
};

/// Reads the console blocks of a page.
ConsolePage read_console_blocks(std::string_view markdown);

/// Returns whether `actual` matches `expected`. Ignores blanks at the end of a line, and empty lines at the
/// beginning and end.
bool shows(std::string_view expected, std::string_view actual);

}  // namespace robosim::test
