#include "sim/cli/hunt/deeds.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "sim/base/escaped.h"

namespace robosim::cli {
namespace {

using worlds::Die;

constexpr int kMostDeeds = 4;
constexpr int kLeastTalk = 4, kMoreTalk = 12, kAgain = 10;  // messages
constexpr std::size_t kLongMessage = 80;
constexpr int kSoon_ms = 2'000;
constexpr int k16Bits_ms = 1 << 16, kAround_ms = 6'000;
constexpr std::size_t kMostBeginnings = 12, kShortestBeginning = 4;

void in_order(std::vector<Deed>& deeds) {
  std::stable_sort(deeds.begin(), deeds.end(),
                   [](const Deed& a, const Deed& b) { return a.at_ms < b.at_ms; });
}

/// Draws words. The first is one of the sketch's own in half of the cases, since commands begin with one.
std::string some_words(const HuntSpace& space, const Die& die) {
  std::string text = pick(die, space.words);
  if (space.own_words > 0 && chance(die, 50))
    text =
        space
            .words[space.words.size() - 1 - static_cast<std::size_t>(die(static_cast<int>(space.own_words)))];
  if (chance(die, 8))
    while (text.size() < kLongMessage) text += " " + pick(die, space.words);
  else if (chance(die, 50))
    text += (chance(die, 80) ? " " : "") + pick(die, space.words);
  return text;
}

std::string message(const std::string& type, const HuntSpace& space, const Die& die) {
  if (type == "radio" || type == "ir-receiver") return fmt::format("{}", die(chance(die, 50) ? 10 : 256));
  return fmt::format("\"{}\\n\"", space.words.empty() ? "1" : some_words(space, die));
}

Deed saying(const HuntSpace& space, const Die& die) {
  std::vector<char> ways(space.listeners.size() * 2, 'l');
  if (!space.words.empty()) ways.insert(ways.end(), 3, 's');
  if (pick(die, ways) == 's') return {0, fmt::format("send \"{}\\n\"", some_words(space, die)), "send"};
  const auto& [name, type] = pick(die, space.listeners);
  const std::string kind = "send " + name;
  return {0, fmt::format("{} {}", kind, message(type, space, die)), kind};
}

Deed pressing(const HuntSpace& space, const Die& die) {
  const std::string kind = "press " + pick(die, space.buttons);
  return {0, fmt::format("{} {}ms", kind, pick<int>(die, {30, 100, 100, 300, 1500})), kind};
}

Deed holding(const HuntSpace& space, const Die& die) {
  const std::string& motor = pick(die, space.parts.motors);
  if (chance(die, 30)) return {0, fmt::format("fault {} stuck for {}ms", motor, 200 + die(600)), kHeld};
  return {0, fmt::format("fault {} reversed for {}ms", motor, 200 + die(600)), kTwisted};
}

Deed switching_off(const Die& die) {
  return {0, fmt::format("power off for {}ms", 20 + die(500)), kPowerOff};
}

Deed draw_deed(const HuntWorld& world, const HuntSpace& space, const Die& die) {
  std::vector<char> kinds(space.buttons.size() * 2, 'b');
  if (hears(space)) kinds.insert(kinds.end(), 3 + space.listeners.size(), 's');
  if (space.feels) kinds.insert(kinds.end(), 3, 'o');
  kinds.insert(kinds.end(), {'u', 'p'});
  if (!space.parts.motors.empty()) kinds.insert(kinds.end(), 2, 'h');
  const int at_ms =
      (chance(die, 50) ? 200 : 10) + die(chance(die, 50) ? 3'000 : span_ms(world, space) * 3 / 4);
  Deed deed;
  switch (pick(die, kinds)) {
    case 'b':
      deed = pressing(space, die);
      break;
    case 's':
      deed = saying(space, die);
      break;
    case 'h':
      deed = holding(space, die);
      break;
    case 'o':
      if (const std::vector<grid::CellAt> cells = cells_with_line(world, space); !cells.empty()) {
        const grid::CellAt cell = pick(die, cells);
        deed = {0, fmt::format("obstacle {},{} for {}s", cell.x, cell.y, pick<int>(die, {2, 4, 8, 15, 40})),
                kObstacle};
        break;
      }
      [[fallthrough]];
    case 'u':
      deed = {0, fmt::format("lift for {}ms", 200 + die(1'500)), "lift"};
      break;
    default:
      deed = switching_off(die);
  }
  deed.at_ms = at_ms;
  return deed;
}

Deed deed_behind(const HuntWorld& world, const Moment& moment, const HuntSpace& space, const Die& die) {
  Deed deed = draw_deed(world, space, die);
  deed.at_ms = std::max(0, moment.at_ms) + 10 + die(kSoon_ms);
  deed.after = moment.after;
  return deed;
}

}  // namespace

std::vector<std::vector<Deed>> openings(const HuntSpace& space) {
  std::vector<std::vector<Deed>> all{{}};
  for (const std::string& button : space.buttons) {
    const std::string press = "press " + button;
    const Deed first{1000, press + " 100ms", press};
    all.push_back({first});
    all.push_back({first, {6000, press + " 100ms", press}});
  }
  return all;
}

std::vector<std::string> beginnings_of(const std::string& serial) {
  std::vector<std::string> all;
  std::istringstream stream(serial);
  for (std::string line; std::getline(stream, line) && all.size() < kMostBeginnings;) {
    line = line.substr(0, line.find_first_of("0123456789\r"));
    if (line.size() >= kShortestBeginning && std::find(all.begin(), all.end(), line) == all.end())
      all.push_back(line);
  }
  if (const std::size_t end = serial.rfind('\n'); end != std::string::npos && !all.empty()) {
    const std::size_t begin = end == 0 ? std::string::npos : serial.rfind('\n', end - 1);
    std::string last = serial.substr(begin == std::string::npos ? 0 : begin + 1, end);
    last = last.substr(0, last.find_first_of("0123456789\r\n"));
    if (last.size() >= kShortestBeginning) {
      std::erase(all, last);
      all.push_back(last);
    }
  }
  return all;
}

bool hears(const HuntSpace& space) { return !space.words.empty() || !space.listeners.empty(); }

void draw_deeds(HuntWorld& world, const HuntSpace& space, const Die& die) {
  world.deeds = opening_of(world, space);
  for (int left = 1 + die(kMostDeeds); left > 0; --left) world.deeds.push_back(draw_deed(world, space, die));
  in_order(world.deeds);
}

void draw_talk(HuntWorld& world, const HuntSpace& space, const Die& die) {
  world.deeds = opening_of(world, space);
  const int from_ms = world.deeds.empty() ? 500 : world.deeds.back().at_ms + 500;
  std::string after;
  if (!space.said.empty() && chance(die, 60))
    after = chance(die, 50) ? space.said.back() : pick(die, space.said);
  int at_ms = after.empty() ? from_ms : 200;
  Deed next;
  int again = 0;
  for (int left = kLeastTalk + die(kMoreTalk); left > 0; --left) {
    if (again == 0) {
      next = chance(die, 5) && !space.buttons.empty() ? pressing(space, die)
             : chance(die, 6)                         ? switching_off(die)
                                                      : saying(space, die);
      if (chance(die, 6)) again = kAgain;
    } else {
      --again, ++left;
    }
    next.at_ms = at_ms;
    next.after = after;
    world.deeds.push_back(next);
    at_ms += 100 + die(chance(die, 70) ? 1'200 : 6'000);
  }
}

void block(HuntWorld& world, const HuntSpace& space, const Die& die) {
  const std::vector<grid::CellAt> cells = cells_with_line(world, space);
  if (cells.empty()) return;
  const grid::CellAt cell = pick(die, cells);
  world.deeds.push_back({200, fmt::format("obstacle {},{} for 60s", cell.x, cell.y), kObstacle});
  in_order(world.deeds);
}

void draw_late_deeds(HuntWorld& world, const HuntSpace& space, const Die& die) {
  if (space.buttons.empty() && !hears(space)) return;
  if (space.for_ms < k16Bits_ms - kAround_ms) return;  // shorter runs are requested
  const bool presses = !space.buttons.empty() && (!hears(space) || chance(die, 50));
  Deed deed = presses ? pressing(space, die) : saying(space, die);
  deed.at_ms = k16Bits_ms - 500 - die(kAround_ms);
  world.deeds.push_back(deed);
  deed.at_ms = k16Bits_ms;
  for (int again = 0; again < 2; ++again) {
    deed.at_ms += 500 + die(kAround_ms);
    world.deeds.push_back(deed);
  }
  world.least_ms = deed.at_ms + kSoon_ms;
}

void add_deed_behind(HuntWorld& world, const Moment& moment, const HuntSpace& space, const Die& die) {
  world.deeds.push_back(deed_behind(world, moment, space, die));
  in_order(world.deeds);
}

void branch(HuntWorld& world, const HuntSpace& space, const Die& die) {
  world.deeds.push_back(deed_behind(world, world.parting, space, die));
}

void add_deed(HuntWorld& world, const HuntSpace& space, const Die& die) {
  world.deeds.push_back(draw_deed(world, space, die));
  in_order(world.deeds);
}

std::string script_line(const Deed& deed) {
  if (deed.after.empty()) return fmt::format("at {}ms {}\n", deed.at_ms, deed.what);
  return fmt::format("after serial \"{}\" wait {}ms {}\n", escaped(deed.after), deed.at_ms, deed.what);
}

}  // namespace robosim::cli
