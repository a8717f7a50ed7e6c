#include "sim/build/project/board_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "sim/base/did_you_mean.h"

namespace robosim::project {
namespace {

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
  return parts;
}

struct Fqbn {
  std::string board;  ///< including vendor and architecture
  std::map<std::string, std::string> options;
};

Fqbn parse(const std::string& text) {
  const std::vector<std::string> parts = split(text, ':');
  Fqbn fqbn;
  if (parts.size() < 3 || parts.size() > 4) return fqbn;
  fqbn.board = fmt::format("{}:{}:{}", parts[0], parts[1], parts[2]);
  if (parts.size() == 4)
    for (const std::string& option : split(parts[3], ','))
      if (const std::size_t at = option.find('='); at != std::string::npos)
        fqbn.options[option.substr(0, at)] = option.substr(at + 1);
  return fqbn;
}

/// Returns whether a name denotes the board's chip. "8MHzatmega328", "atmega328old" and "atmega328" denote an
/// ATmega328P; an atmega1280 is not an ATmega2560.
bool names_chip(const std::string& cpu, const BoardSpec& board) {
  std::string chip = board.chip->compiler_name;
  if (chip.back() == 'p') chip.pop_back();
  if (cpu.find(chip) == std::string::npos) return false;
  const std::size_t unit = cpu.find("MHz");
  return unit == std::string::npos || cpu.substr(0, unit) == std::to_string(board.clock_hz / 1'000'000);
}

/// Returns the number of options that match the board; -1 if an option excludes the board.
int fit(const Fqbn& wanted, const BoardSpec& board) {
  const Fqbn own = parse(board.fqbn);
  if (wanted.board.empty() || wanted.board != own.board) return -1;
  int same = 0;
  for (const auto& [key, value] : wanted.options) {
    const auto known = own.options.find(key);
    if (known != own.options.end() && known->second == value)
      ++same;
    else if (key == "cpu" ? !names_chip(value, board) : known != own.options.end())
      return -1;
  }
  return same;
}

std::vector<std::string> ids_of(const BoardSpec& board) { return split(board.platformio, ' '); }

}  // namespace

const BoardSpec* board_of_fqbn(const std::string& text) {
  const Fqbn fqbn = parse(text);
  const BoardSpec* best = nullptr;
  int most = -1;
  for (int i = 0; const BoardSpec* board = board_at(i); ++i)
    if (const int same = fit(fqbn, *board); same > most) {
      best = board;
      most = same;
    }
  return best;
}

const BoardSpec* board_with_chip(const std::string& chip, const std::string& text) {
  const auto options = parse(text).options;
  const auto named = options.find("clock");
  const std::string clock = named == options.end() ? "" : named->second.substr(0, named->second.find("MHz"));
  for (int i = 0; const BoardSpec* board = board_at(i); ++i) {
    const std::string own = board->chip->compiler_name;
    const bool same_clock = clock.empty() || clock == std::to_string(board->clock_hz / 1'000'000);
    if (!chip.empty() && (chip == own || chip + "p" == own) && same_clock) return board;
  }
  return nullptr;
}

const BoardSpec* board_of_platformio(const std::string& id) {
  for (int i = 0; const BoardSpec* board = board_at(i); ++i) {
    const std::vector<std::string> ids = ids_of(*board);
    if (std::find(ids.begin(), ids.end(), id) != ids.end()) return board;
  }
  return nullptr;
}

std::string all_fqbns() {
  std::vector<std::string> all;
  for (int i = 0; const BoardSpec* board = board_at(i); ++i)
    if (all.empty() || all.back() != board->fqbn) all.emplace_back(board->fqbn);
  return all_of(all);
}

std::string all_platformio_ids() {
  std::vector<std::string> all;
  for (int i = 0; const BoardSpec* board = board_at(i); ++i)
    for (const std::string& id : ids_of(*board))
      if (all.empty() || all.back() != id) all.push_back(id);
  return all_of(all);
}

}  // namespace robosim::project
