// Tests that only data files name boards and chips. Code that named a board or chip would have to change for
// every new board.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "tests/unit/structure/include_table.h"

namespace robosim::structure::boards_test {

/// Returns whether the path of a file shows that the file is about one chip or board.
bool is_about_a_chip(const std::string& file) {
  for (const char* place : {"hal/board/", "hal/host/chip.h", "hal/stm32/", "sim/exec/stm32/"})
    if (file.starts_with(place)) return true;
  return false;
}

/// Returns the names of boards and chips. Only data may contain them.
std::vector<std::string> names() {
  std::vector<std::string> found{"kAtmega168", "kAtmega2560",  "kAtmega328p",  "kAtmega32u4",
                                 "kAttiny85",  "kStm32f103c8", "\"iom328p.h\""};
  const auto quote = [&](const char* name) {
    if (name) found.push_back('"' + std::string(name) + '"');
  };
  for (int i = 0; const BoardSpec* board = board_at(i); ++i) {
    quote(board->name);
    quote(board->macro);
    quote(board->fqbn);
    quote(board->variant);
    quote(board->chip->compiler_name);
    quote(board->chip->macro);
  }
  return found;
}

TEST(Boards, AreNamedByNoCodeButTheirData) {
  for (const auto& [file, text] : read_sources(ROBOSIM_SOURCE_DIR)) {
    if (is_about_a_chip(file) || !(file.starts_with("sim/") || file.starts_with("hal/"))) continue;
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      const std::string code = line.substr(0, line.find("//"));
      for (const std::string& name : names())
        EXPECT_EQ(code.find(name), code.npos) << file << ':' << number << " names " << name;
    }
  }
}

}  // namespace robosim::structure::boards_test
