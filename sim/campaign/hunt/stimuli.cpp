#include "sim/campaign/hunt/stimuli.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "sim/base/escaped.h"

namespace robosim::campaign {
namespace {

using random_worlds::RandomSource;

constexpr int kMostStimuli = 4;
constexpr int kLeastTalk = 4, kMoreTalk = 12, kAgain = 10;  // messages: minimum, random extra, copies
constexpr std::size_t kLongMessage = 80;
constexpr int kSoon_ms = 2'000;
constexpr int k16Bits_ms = 1 << 16, kAround_ms = 6'000;
constexpr std::size_t kMostBeginnings = 12, kShortestBeginning = 4;

void in_order(std::vector<Stimulus>& stimuli) {
  std::stable_sort(stimuli.begin(), stimuli.end(),
                   [](const Stimulus& a, const Stimulus& b) { return a.at_ms < b.at_ms; });
}

/// Draws words. In half of the cases, the first word is from the sketch, since commands begin with
/// such words.
std::string some_words(const HuntSpace& space, const RandomSource& rng) {
  std::string text = pick(rng, space.words);
  if (space.own_words > 0 && chance(rng, 50))
    text =
        space
            .words[space.words.size() - 1 - static_cast<std::size_t>(rng(static_cast<int>(space.own_words)))];
  if (chance(rng, 8))
    while (text.size() < kLongMessage) text += " " + pick(rng, space.words);
  else if (chance(rng, 50))
    text += (chance(rng, 80) ? " " : "") + pick(rng, space.words);
  return text;
}

std::string message(const std::string& type, const HuntSpace& space, const RandomSource& rng) {
  if (type == "radio" || type == "ir-receiver") return fmt::format("{}", rng(chance(rng, 50) ? 10 : 256));
  return fmt::format("\"{}\\n\"", space.words.empty() ? "1" : some_words(space, rng));
}

Stimulus saying(const HuntSpace& space, const RandomSource& rng) {
  std::vector<char> ways(space.listeners.size() * 2, 'l');
  if (!space.words.empty()) ways.insert(ways.end(), 3, 's');
  if (pick(rng, ways) == 's') return {0, fmt::format("send \"{}\\n\"", some_words(space, rng)), "send"};
  const auto& [name, type] = pick(rng, space.listeners);
  const std::string kind = "send " + name;
  return {0, fmt::format("{} {}", kind, message(type, space, rng)), kind};
}

Stimulus pressing(const HuntSpace& space, const RandomSource& rng) {
  const std::string kind = "press " + pick(rng, space.buttons);
  return {0, fmt::format("{} {}ms", kind, pick<int>(rng, {30, 100, 100, 300, 1500})), kind};
}

Stimulus holding(const HuntSpace& space, const RandomSource& rng) {
  const std::string& motor = pick(rng, space.parts.motors);
  if (chance(rng, 30)) return {0, fmt::format("fault {} stuck for {}ms", motor, 200 + rng(600)), kHeld};
  return {0, fmt::format("fault {} reversed for {}ms", motor, 200 + rng(600)), kTwisted};
}

Stimulus switching_off(const RandomSource& rng) {
  return {0, fmt::format("power off for {}ms", 20 + rng(500)), kPowerOff};
}

Stimulus draw_stimulus(const TestCase& test_case, const HuntSpace& space, const RandomSource& rng) {
  std::vector<char> kinds(space.buttons.size() * 2, 'b');
  if (hears(space)) kinds.insert(kinds.end(), 3 + space.listeners.size(), 's');
  if (space.feels) kinds.insert(kinds.end(), 3, 'o');
  kinds.insert(kinds.end(), {'u', 'p'});
  if (!space.parts.motors.empty()) kinds.insert(kinds.end(), 2, 'h');
  const int at_ms =
      (chance(rng, 50) ? 200 : 10) + rng(chance(rng, 50) ? 3'000 : span_ms(test_case, space) * 3 / 4);
  Stimulus stimulus;
  switch (pick(rng, kinds)) {
    case 'b':
      stimulus = pressing(space, rng);
      break;
    case 's':
      stimulus = saying(space, rng);
      break;
    case 'h':
      stimulus = holding(space, rng);
      break;
    case 'o':
      if (const std::vector<map::CellAt> cells = cells_with_line(test_case, space); !cells.empty()) {
        const map::CellAt cell = pick(rng, cells);
        stimulus = {0,
                    fmt::format("obstacle {},{} for {}s", cell.x, cell.y, pick<int>(rng, {2, 4, 8, 15, 40})),
                    kObstacle};
        break;
      }
      [[fallthrough]];
    case 'u':
      stimulus = {0, fmt::format("lift for {}ms", 200 + rng(1'500)), "lift"};
      break;
    default:
      stimulus = switching_off(rng);
  }
  stimulus.at_ms = at_ms;
  return stimulus;
}

Stimulus stimulus_after(const TestCase& test_case, const Moment& moment, const HuntSpace& space,
                        const RandomSource& rng) {
  Stimulus stimulus = draw_stimulus(test_case, space, rng);
  stimulus.at_ms = std::max(0, moment.at_ms) + 10 + rng(kSoon_ms);
  stimulus.after = moment.after;
  return stimulus;
}

}  // namespace

std::vector<std::vector<Stimulus>> openings(const HuntSpace& space) {
  std::vector<std::vector<Stimulus>> all{{}};
  for (const std::string& button : space.buttons) {
    const std::string press = "press " + button;
    const Stimulus first{1000, press + " 100ms", press};
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

void draw_stimuli(TestCase& test_case, const HuntSpace& space, const RandomSource& rng) {
  test_case.stimuli = opening_of(test_case, space);
  for (int left = 1 + rng(kMostStimuli); left > 0; --left)
    test_case.stimuli.push_back(draw_stimulus(test_case, space, rng));
  in_order(test_case.stimuli);
}

void draw_talk(TestCase& test_case, const HuntSpace& space, const RandomSource& rng) {
  test_case.stimuli = opening_of(test_case, space);
  const int from_ms = test_case.stimuli.empty() ? 500 : test_case.stimuli.back().at_ms + 500;
  std::string after;
  if (!space.said.empty() && chance(rng, 60))
    after = chance(rng, 50) ? space.said.back() : pick(rng, space.said);
  int at_ms = after.empty() ? from_ms : 200;
  Stimulus next;
  int again = 0;
  for (int left = kLeastTalk + rng(kMoreTalk); left > 0; --left) {
    if (again == 0) {
      next = chance(rng, 5) && !space.buttons.empty() ? pressing(space, rng)
             : chance(rng, 6)                         ? switching_off(rng)
                                                      : saying(space, rng);
      if (chance(rng, 6)) again = kAgain;
    } else {
      --again, ++left;
    }
    next.at_ms = at_ms;
    next.after = after;
    test_case.stimuli.push_back(next);
    at_ms += 100 + rng(chance(rng, 70) ? 1'200 : 6'000);
  }
}

void block(TestCase& test_case, const HuntSpace& space, const RandomSource& rng) {
  const std::vector<map::CellAt> cells = cells_with_line(test_case, space);
  if (cells.empty()) return;
  const map::CellAt cell = pick(rng, cells);
  test_case.stimuli.push_back({200, fmt::format("obstacle {},{} for 60s", cell.x, cell.y), kObstacle});
  in_order(test_case.stimuli);
}

void draw_late_stimuli(TestCase& test_case, const HuntSpace& space, const RandomSource& rng) {
  if (space.buttons.empty() && !hears(space)) return;
  if (space.for_ms < k16Bits_ms - kAround_ms) return;  // the requested runs are shorter
  const bool presses = !space.buttons.empty() && (!hears(space) || chance(rng, 50));
  Stimulus stimulus = presses ? pressing(space, rng) : saying(space, rng);
  stimulus.at_ms = k16Bits_ms - 500 - rng(kAround_ms);
  test_case.stimuli.push_back(stimulus);
  stimulus.at_ms = k16Bits_ms;
  for (int again = 0; again < 2; ++again) {
    stimulus.at_ms += 500 + rng(kAround_ms);
    test_case.stimuli.push_back(stimulus);
  }
  test_case.least_ms = stimulus.at_ms + kSoon_ms;
}

void add_stimulus_after(TestCase& test_case, const Moment& moment, const HuntSpace& space,
                        const RandomSource& rng) {
  test_case.stimuli.push_back(stimulus_after(test_case, moment, space, rng));
  in_order(test_case.stimuli);
}

void branch(TestCase& test_case, const HuntSpace& space, const RandomSource& rng) {
  test_case.stimuli.push_back(stimulus_after(test_case, test_case.branch_point, space, rng));
}

void add_stimulus(TestCase& test_case, const HuntSpace& space, const RandomSource& rng) {
  test_case.stimuli.push_back(draw_stimulus(test_case, space, rng));
  in_order(test_case.stimuli);
}

std::string script_line(const Stimulus& stimulus) {
  if (stimulus.after.empty()) return fmt::format("at {}ms {}\n", stimulus.at_ms, stimulus.what);
  return fmt::format("after serial \"{}\" wait {}ms {}\n", escaped(stimulus.after), stimulus.at_ms,
                     stimulus.what);
}

}  // namespace robosim::campaign
