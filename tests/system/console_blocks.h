// Commands that a Markdown page shows, with the output that it promises.
//
//   ```console                  the commands run, one after another, in one shell for each page
//   $ robosim new demo          a command
//   1 sketch                    its output, standard error included; no line: only its status counts
//   …                           any number of lines; within a line any text
//   ```
//   ```console status 1         the last command of the block ends with status 1
//   ```console gcc 12           the output is that of sketches compiled by gcc 12; may precede `status 1`
//   ```console not run: REASON  shown only
//   <!-- setup: COMMAND -->     runs here, and is not shown to readers
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robosim::test {

struct ConsoleCommand {
  int line = 0;         ///< in the page, from 1
  std::string command;  ///< without "$ "
  std::string output;   ///< as the page shows it; empty = any
  int status = 0;       ///< the status that it must end with
  int gcc = 0;          ///< the version of gcc whose output this is; 0 = of any
  bool is_setup = false;
};

struct ConsolePage {
  std::vector<ConsoleCommand> commands;  ///< in the order of the page
  std::vector<int> outside;              ///< lines with "$ " in a block that is not console, from 1
};

/// Reads the console blocks of a page.
ConsolePage read_console_blocks(std::string_view markdown);

/// Returns whether `actual` is what `expected` shows. Blanks at the end of a line, and empty lines at the
/// beginning and end, do not count.
bool shows(std::string_view expected, std::string_view actual);

}  // namespace robosim::test
