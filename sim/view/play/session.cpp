#include "sim/view/play/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "sim/base/error.h"
#include "sim/view/terminal/graph_table.h"
#include "sim/view/terminal/text.h"

namespace robosim::play {
namespace {

using Kind = terminal::Press::Kind;
using map::Cell;
using map::CellAt;
using map::Direction;

const char* what_is_at(const map::Map& map, CellAt cell) {
  switch (map.at(cell)) {
    case Cell::wall:
      return "a wall";
    case Cell::obstacle:
      return "an obstacle";
    default:
      return "plain floor";
  }
}

std::string pose_text(const map::Start& pose) {
  return fmt::format("{},{},{}", pose.cell.x, pose.cell.y, map::letter(pose.facing));
}

std::optional<double> number(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool is_any_of(const std::string& word, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(), [&](const char* w) { return word == w; });
}

/// Returns the next line cell, in row order, that is the end of a line.
std::optional<CellAt> next_dead_end(const map::Map& map, CellAt after) {
  const std::size_t count = map.cells.size();
  const std::size_t begin = map.index_of(after) + 1;
  for (std::size_t i = 0; i < count; ++i) {
    const CellAt cell = map.cell_at((begin + i) % count);
    if (map.at(cell) == Cell::line && map::is_dead_end(map, cell)) return cell;
  }
  return std::nullopt;
}

constexpr const char* kPlaceKeys =
    "w a s d or arrows move it; t turns it; n goes to the next end of a line; Enter accepts; q quits";

}  // namespace

Session::Session(SessionHost& host, terminal::Console& console, Options options)
    : host_(host), console_(console), options_(std::move(options)), pace_(options_.moves_per_second) {}

bool Session::run() {
  try {
    Next next = Next::map;
    for (;;) {
      if (next == Next::map) choose_map();
      if (next != Next::algorithm) place();
      choose_engine();
      if (!driven_) choose_speed();
      choose_algorithm();
      pose_ = start_;
      picture_->clear_trail();
      next = driven_ ? on_robot() : on_cells();
    }
  } catch (const SessionQuit& quit) {
    return !quit.interrupted;
  }
}

void Session::choose_map() {
  std::string answer = options_.map;
  const std::vector<MapEntry> maps = answer.empty() ? host_.maps() : std::vector<MapEntry>{};
  std::vector<std::string> lines;
  std::size_t widest = 0, selected = 0;
  for (const MapEntry& entry : maps) widest = std::max(widest, entry.name.size());
  for (const MapEntry& entry : maps)
    lines.push_back(fmt::format("{:>3}  {:<{}}  {}", lines.size() + 1, entry.name, widest, entry.note));
  const Body body = [&](terminal::Page& page) {
    page.line("R O B O S I M", terminal::Ink::strong);
    page.text("A robot follows lines from station to station, and draws itself a graph of them.");
    page.blank();
    page.line("Maps:");
    page.list(lines, selected, page.rows_left() - 1);
    page.blank();
  };
  for (;;) {
    const bool given = !answer.empty();
    if (!given) {
      answer =
          ask(body, "Map (a number, a name or a file; Enter takes the marked one; q quits):", [&](int step) {
            if (!maps.empty())
              selected = (selected + maps.size() + static_cast<std::size_t>(step)) % maps.size();
          });
      if (answer.empty() && !maps.empty()) answer = maps[selected].name;
      const auto n = number(answer);
      if (n && *n >= 1 && *n <= static_cast<double>(maps.size()) && *n == static_cast<int>(*n))
        answer = maps[static_cast<std::size_t>(*n) - 1].name;
    }
    try {
      map::Map map = host_.open_map(answer);
      start_ =
          given && !options_.start.empty() ? map::parse_start(map, options_.start) : map::default_start(map);
      picture_.reset();
      map_ = std::move(map);
      picture_.emplace(*map_);
      const auto count = std::count_if(map_->cells.begin(), map_->cells.end(), map::is_line);
      line_cells_ = std::to_string(count);
      options_.map.clear();
      return;
    } catch (const InputError& error) {
      if (given && !options_.map.empty()) throw;
      refuse(fmt::format("Not possible: {}", error.what()));
      answer.clear();
    }
  }
}

std::string Session::map_title() const {
  return fmt::format("Map {}: {} columns x {} rows, {} line cells of {:.10g} mm", map_->name, map_->width,
                     map_->height, line_cells_, map_->cell_m * 1e3);
}

void Session::draw_map(terminal::Page& page, int rows, const std::vector<terminal::CellLabel>& labels) {
  draw_map_around(page, rows, pose_.cell, labels);
}

void Session::draw_map_around(terminal::Page& page, int rows, CellAt around,
                              const std::vector<terminal::CellLabel>& labels) {
  page.took(picture_->draw(page.frame(), page.row(), std::min(rows, page.rows_left()), around, pose_, labels,
                           page.look()));
}

bool Session::try_accept() {
  if (map_->at(pose_.cell) == Cell::line || map_->at(pose_.cell) == Cell::gap) return true;
  refuse(fmt::format("The robot cannot stand at {},{}: {} is there. Put it on the line.", pose_.cell.x,
                     pose_.cell.y, what_is_at(*map_, pose_.cell)));
  return false;
}

void Session::place() {
  pose_ = start_;
  picture_->clear_trail();
  const auto go = [&](Direction d) {
    pose_.facing = d;  // the last pressed key sets the direction, also at the edge
    if (map_->contains(ahead(pose_.cell, d))) pose_.cell = ahead(pose_.cell, d);
  };
  for (;;) {
    const terminal::Press press = read(
        [&](terminal::Page& page) {
          page.line(map_title(), terminal::Ink::strong);
          page.line(fmt::format("Place the robot: it is at {}", pose_text(pose_)));
          draw_map(page, page.rows_left());
        },
        {{kPlaceKeys, terminal::Ink::faint}});
    error_.clear();
    switch (press.kind) {
      case Kind::up:
        go(Direction::north);
        break;
      case Kind::down:
        go(Direction::south);
        break;
      case Kind::left:
        go(Direction::west);
        break;
      case Kind::right:
        go(Direction::east);
        break;
      case Kind::enter:
        if (!try_accept()) break;
        start_ = pose_;
        return;
      case Kind::character: {
        constexpr std::string_view kLetters = "dsaw";  // by Direction
        const char c = static_cast<char>(press.character | 0x20);
        if (const auto d = kLetters.find(c); d != std::string_view::npos) {
          go(static_cast<Direction>(d));
        } else if (c == 't') {
          pose_.facing = turned_right(pose_.facing);
        } else if (c == 'n') {
          if (const auto end = next_dead_end(*map_, pose_.cell))
            pose_ = {*end, map::default_facing(*map_, *end)};
        } else if (c == 'q') {
          throw SessionQuit{};
        } else {
          refuse(fmt::format("“{}” does nothing here.", press.character));
        }
        break;
      }
      default:
        break;
    }
  }
}

void Session::choose_engine() {
  const Body body = [&](terminal::Page& page) {
    page.line(map_title(), terminal::Ink::strong);
    page.line(fmt::format("The robot starts at {}.", pose_text(start_)));
    page.blank();
    page.text("1 cells: from cell to cell, as the original program did: exact and fast");
    page.text("2 driven robot: a simulated Arduino robot with motors and sensors, and a sample sketch");
    page.blank();
  };
  for (;;) {
    const std::string answer = ask(body, "Cells or driven robot [1]:");
    driven_ = is_any_of(answer, {"2", "d", "driven", "robot", "driven robot"});
    if (driven_ || is_any_of(answer, {"", "1", "c", "cells"})) return;
    refuse(fmt::format("“{}” is not a choice: answer 1 for cells or 2 for the driven robot.", answer));
  }
}

void Session::choose_speed() {
  const Body body = [&](terminal::Page& page) {
    page.line(map_title(), terminal::Ink::strong);
    page.line(fmt::format("The robot starts at {}, on cells.", pose_text(start_)));
    page.blank();
    page.text("Its speed is the time that each move takes. The display has a speed of its own.");
    page.blank();
  };
  for (;;) {
    const std::string answer = ask(body, fmt::format("Speed, seconds a move [{:.10g}]:", speed_s_));
    if (answer.empty()) return;
    const auto speed = number(answer);
    if (speed && *speed > 0.0 && *speed <= 1e6) {
      speed_s_ = *speed;
      return;
    }
    refuse(
        fmt::format("“{}” is not a speed: expected seconds above 0 and up to 1000000, as in 0.5.", answer));
  }
}

void Session::choose_algorithm() {
  const Body body = [&](terminal::Page& page) {
    page.line(map_title(), terminal::Ink::strong);
    page.blank();
    page.text("1 left: keeps to the left at every junction");
    page.text("2 right: keeps to the right at every junction");
    page.text("3 ai: scans the line into a graph, then drives to the stations you name");
    page.blank();
  };
  for (;;) {
    const std::string answer = ask(body, "Algorithm [3]:");
    if (is_any_of(answer, {"1", "l", "left"})) {
      algorithm_ = Algorithm::left;
    } else if (is_any_of(answer, {"2", "r", "right"})) {
      algorithm_ = Algorithm::right;
    } else if (is_any_of(answer, {"", "3", "a", "ai"})) {
      algorithm_ = Algorithm::ai;
    } else {
      refuse(fmt::format("“{}” is not an algorithm: expected 1 for left, 2 for right or 3 for ai.", answer));
      continue;
    }
    return;
  }
}

Session::Next Session::choose_next(const std::string& result, terminal::Ink ink) {
  const Body body = [&](terminal::Page& page) {
    page.text(result, ink);
    draw_map(page, page.rows_left() - 5);
    page.blank();
    page.text("1 again from another place");
    page.text("2 again with another algorithm");
    page.text("3 another map");
  };
  for (;;) {
    const std::string answer = ask(body, "And now (1, 2, 3; q quits) [1]:");
    if (is_any_of(answer, {"", "1"})) return Next::place;
    if (answer == "2") return Next::algorithm;
    if (answer == "3") return Next::map;
    refuse(fmt::format("“{}” is not possible: answer 1, 2, 3 or q.", answer));
  }
}

Session::Next Session::on_robot() {
  try {
    const AskPerson ask_person = [this](const std::vector<std::string>& told, const std::string& question) {
      return ask(
          [&](terminal::Page& page) {
            page.line(fmt::format("Map {}: the driven robot", map_->name), terminal::Ink::strong);
            page.blank();
            page.list(told, told.empty() ? 0 : told.size() - 1, page.rows_left() - 1, false);
            page.blank();
          },
          question);
    };
    const std::string result = host_.drive_robot(*map_, start_, algorithm_, console_, ask_person);
    return choose_next(result, terminal::Ink::plain);
  } catch (const InputError& error) {
    return choose_next(fmt::format("The robot did not drive: {}", error.what()), terminal::Ink::bad);
  } catch (const ToolMissing& error) {
    return choose_next(fmt::format("The robot did not drive: {}", error.what()), terminal::Ink::bad);
  }
}

}  // namespace robosim::play
