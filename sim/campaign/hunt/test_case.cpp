#include "sim/campaign/hunt/test_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "sim/base/noise.h"
#include "sim/campaign/hunt/stimuli.h"
#include "sim/campaign/random_worlds/random_source.h"

namespace robosim::campaign {
namespace {

using random_worlds::Fault;
using random_worlds::RandomSource;

constexpr int kMostSquares = 4, kMostPieces = 10, kUsualPieces = 5, kFewPieces = 3, kMostFaults = 2;
constexpr int kMostSeeds = 1000;
constexpr int kHeldFor_ms = 300, kAfterHeld_ms = 4'000;  // for a button held at power-on
constexpr int kLongBefore_ms = 40'000, kAfterStimulus_ms = 4'000;
constexpr std::uint64_t kPairEvery = 6;
constexpr std::int64_t kMillisWrap_ms = std::int64_t{1} << 32;
constexpr std::int64_t kMicrosWrap_ms = kMillisWrap_ms / 1000;
constexpr std::int64_t kInt_ms = std::int64_t{1} << 15;
// The clock of a blocked robot wraps up to kBlockedFor_ms after kBlockedAfter_ms, but at the latest in the
// middle of the run.
constexpr int kBlockedAfter_ms = 10'000, kBlockedFor_ms = 20'000;

/// A random track is the outline of joined squares. Returns the smallest width of such a square, in cells: 4,
/// or twice the bends' radius if that is more.
int apart(const HuntSpace::Map& map) {
  return std::max(4, static_cast<int>(std::ceil(2.0 * map.corner_mm / map.cell_mm)));
}

random_worlds::LineNetwork network_like(const HuntSpace::Map& map, int pieces, const RandomSource& rng) {
  return random_worlds::grow({pieces, 3, 4, map.cycles, 0}, rng);
}

void draw_map(TestCase& test_case, const HuntSpace& space, const RandomSource& rng,
              int most_pieces = kMostPieces) {
  test_case.track.reset();
  test_case.network.reset();
  test_case.map = static_cast<std::size_t>(rng(static_cast<int>(space.maps.size())));
  const HuntSpace::Map& like = space.maps[test_case.map];
  if (!space.draws_maps || chance(rng, 40)) return;
  if (like.tracks) test_case.track = random_worlds::lay_out({1 + rng(kMostSquares), apart(like), 0}, rng);
  if (like.networks) test_case.network = network_like(like, 1 + rng(most_pieces), rng);
}

/// Holds a button at power-on, when many sketches read their buttons. Releases it long before the robot
/// starts.
void hold_a_button_at_power_on(TestCase& test_case, const HuntSpace& space, const RandomSource& rng) {
  const std::string kind = "press " + pick(rng, space.buttons);
  const int first_ms = space.opening.empty() ? kAfterHeld_ms : space.opening.front().at_ms;
  test_case.later_ms = std::max(test_case.later_ms, kAfterHeld_ms - first_ms);
  test_case.stimuli = opening_of(test_case, space);
  test_case.stimuli.insert(test_case.stimuli.begin(), {0, kind + fmt::format(" {}ms", kHeldFor_ms), kind});
}

/// Draws the clock's initial value, so that millis(), micros(), or a variable that holds millis() overflows
/// during the run.
void draw_clock(TestCase& test_case, const HuntSpace& space, const RandomSource& rng) {
  const std::int64_t wrap =
      pick<std::int64_t>(rng, {kMillisWrap_ms, kMillisWrap_ms, kMillisWrap_ms / 2, kMicrosWrap_ms,
                               kPast_ms + kInt_ms, kPast_ms + 2 * kInt_ms});
  int runs_ms = rng(std::min<int>(span_ms(test_case, space) / 2, static_cast<int>(kInt_ms)));
  // In half of the cases, the overflow shortly follows a stimulus.
  if (!test_case.stimuli.empty() && chance(rng, 50))
    if (const Stimulus& stimulus = pick(rng, test_case.stimuli); stimulus.after.empty())
      runs_ms = std::min(stimulus.at_ms + rng(kAfterStimulus_ms), static_cast<int>(kInt_ms));
  test_case.clock_ms = wrap - 1 - runs_ms;
}

/// Draws an obstacle that blocks the robot while its clock wraps to 0.
void draw_wrap_while_blocked(TestCase& test_case, const HuntSpace& space, const RandomSource& rng) {
  block(test_case, space, rng);
  test_case.is_long = true;
  test_case.clock_ms = kMillisWrap_ms - std::min(space.for_ms / 2, kBlockedAfter_ms + rng(kBlockedFor_ms));
}

/// Draws a test case that has no faults and is compared with a counterpart.
TestCase pair(const HuntSpace& space, const RandomSource& rng) {
  TestCase test_case;
  test_case.differential =
      space.host_counterpart && chance(rng, space.feels ? 50 : 70) ? Differential::host : Differential::clock;
  test_case.stimuli = space.opening;
  draw_map(test_case, space, rng, kFewPieces);
  test_case.seed = 1 + static_cast<std::uint64_t>(rng(kMostSeeds));
  test_case.is_long = chance(rng, 20);
  if (test_case.differential == Differential::clock && space.feels && chance(rng, 60)) {
    draw_wrap_while_blocked(test_case, space, rng);
  } else {
    if (hears(space) && chance(rng, 80)) draw_talk(test_case, space, rng);
    if (test_case.differential == Differential::host && chance(rng, hears(space) ? 15 : 60))
      draw_late_stimuli(test_case, space, rng);
    // Removes power cuts, because the output up to a cut has a different length on the host than on a chip.
    if (test_case.differential == Differential::host)
      std::erase_if(test_case.stimuli, [](const Stimulus& stimulus) { return stimulus.kind == kPowerOff; });
    if (test_case.differential == Differential::clock) draw_clock(test_case, space, rng);
  }
  test_case.to_goal = false;
  return test_case;
}

TestCase fresh(const HuntSpace& space, const RandomSource& rng) {
  TestCase test_case;
  test_case.is_long = chance(rng, 20);
  if (!space.opening.empty() && chance(rng, 15)) test_case.later_ms = 1'000 + rng(kLongBefore_ms);
  test_case.stimuli = opening_of(test_case, space);
  draw_map(test_case, space, rng);
  if (chance(rng, 50)) test_case.robot = random_worlds::assemble(space.figures, rng);
  test_case.seed = 1 + static_cast<std::uint64_t>(rng(kMostSeeds));
  if (chance(rng, 35)) test_case.faults = random_worlds::draw_up(space.limits, kMostFaults, space.parts, rng);
  if (hears(space) && chance(rng, 30)) {
    draw_map(test_case, space, rng, kFewPieces);
    draw_talk(test_case, space, rng);
  } else if (chance(rng, 45)) {
    draw_stimuli(test_case, space, rng);
  } else if (!space.buttons.empty() && chance(rng, 15)) {
    hold_a_button_at_power_on(test_case, space, rng);
  }
  if (space.uses_eeprom && chance(rng, 25))
    test_case.stimuli.insert(test_case.stimuli.begin(), {0, "fault eeprom used", kUsedEeprom});
  if (chance(rng, 12)) draw_clock(test_case, space, rng);
  test_case.to_goal = chance(rng, 60);
  return test_case;
}

/// Drops obstacles that are not on a line of the test case's map.
void drop_obstacles(TestCase& test_case, const HuntSpace& space) {
  const std::vector<map::CellAt> line = cells_with_line(test_case, space);
  std::erase_if(test_case.stimuli, [&](const Stimulus& stimulus) {
    return stimulus.kind == kObstacle && std::none_of(line.begin(), line.end(), [&](map::CellAt cell) {
             return stimulus.what.starts_with(fmt::format("obstacle {},{} ", cell.x, cell.y));
           });
  });
}

TestCase like(const Noted& noted, const HuntSpace& space, const RandomSource& rng) {
  TestCase test_case = noted.test_case;
  test_case.differential = Differential::none;
  if (noted.moment.is_known() && chance(rng, 20)) {
    add_stimulus_after(test_case, noted.moment, space, rng);
    return test_case;
  }
  switch (rng(6)) {
    case 0:
      draw_map(test_case, space, rng);
      drop_obstacles(test_case, space);
      break;
    case 1:
      test_case.robot = random_worlds::assemble(space.figures, rng);
      break;
    case 2:
      test_case.faults = random_worlds::draw_up(space.limits, kMostFaults, space.parts, rng);
      break;
    case 3:
      draw_clock(test_case, space, rng);
      break;
    default:
      add_stimulus(test_case, space, rng);
  }
  test_case.seed = 1 + static_cast<std::uint64_t>(rng(kMostSeeds));
  return test_case;
}

/// Draws a build. Most test cases run on the host, which is many times as fast as an emulated chip. Builds
/// without checks (sanitizers) are more frequent, because only their runs are evidence of the robot's
/// behaviour.
std::size_t draw_build(const HuntSpace& space, std::uint64_t run, const RandomSource& rng) {
  if (!space.host_counterpart)
    return static_cast<std::size_t>(run % 2 == 0 ? 0 : run / 2 % drawn_builds(space));
  if (chance(rng, 55)) return *space.host_counterpart;
  std::vector<std::size_t> builds{0, 0};
  for (std::size_t i = 0; i < drawn_builds(space); ++i)
    builds.insert(builds.end(), space.builds[i].target == "host" ? 3 : 1, i);
  return pick(rng, builds);
}

/// Draws the random numbers of one test case. They depend only on the seed and the test case's number.
class Dice {
 public:
  Dice(std::uint64_t seed, const char* what, std::uint64_t number)
      : stream_(seed, 0, "hunt", what), n_(number << 16) {}
  int operator()(int below) {
    return static_cast<int>(stream_.bits(n_++) % static_cast<std::uint64_t>(std::max(1, below)));
  }

 private:
  NoiseStream stream_;
  std::uint64_t n_;
};

TestCase draw_world(const HuntSpace& space, const std::vector<Noted>& noted, std::uint64_t seed,
                    std::uint64_t run) {
  Dice dice(seed, "world", run);
  const RandomSource rng = std::ref(dice);
  if (run % kPairEvery == kPairEvery - 1 && space.builds.front().target != "host") return pair(space, rng);
  TestCase test_case =
      !noted.empty() && chance(rng, 50) ? like(pick(rng, noted), space, rng) : fresh(space, rng);
  test_case.build = draw_build(space, run, rng);
  if (space.builds[test_case.build].target == "host") test_case.clock_ms = 0;
  return test_case;
}

/// Replaces the last test cases of a round by copies of one noted test case. The copies are equal up to the
/// noted moment, and then differ in one stimulus. Changes nothing without a chip or a noted moment.
void draw_family(std::vector<TestCase>& test_cases, const HuntSpace& space, const std::vector<Noted>& noted,
                 std::uint64_t seed, const std::vector<std::uint64_t>& runs) {
  std::vector<std::size_t> chips;
  for (std::size_t i = 0; i < drawn_builds(space); ++i)
    if (space.builds[i].target != "host") chips.insert(chips.end(), space.builds[i].checked ? 1 : 2, i);
  std::vector<const Noted*> known;
  for (const Noted& one : noted)
    if (one.moment.is_known()) known.push_back(&one);
  if (chips.empty() || known.empty()) return;
  Dice dice(seed, "family", runs.front());
  const RandomSource rng = std::ref(dice);
  const Noted& from = *pick(rng, known);
  const std::size_t build = pick(rng, chips);
  for (std::size_t i = kRound - kFamily; i < kRound; ++i) {
    Dice own(seed, "branch", runs[i]);
    TestCase& test_case = test_cases[i] = from.test_case;
    test_case.differential = Differential::none;
    test_case.build = build;
    test_case.family = runs.front() + 1;
    test_case.branch_point = from.moment;
    branch(test_case, space, std::ref(own));
  }
}

}  // namespace

std::vector<Stimulus> opening_of(const TestCase& test_case, const HuntSpace& space) {
  std::vector<Stimulus> opening = space.opening;
  for (Stimulus& stimulus : opening) stimulus.at_ms += test_case.later_ms;
  return opening;
}

std::vector<TestCase> draw_round(const HuntSpace& space, const std::vector<Noted>& noted, std::uint64_t seed,
                                 const std::vector<std::uint64_t>& runs) {
  std::vector<TestCase> test_cases;
  for (const std::uint64_t run : runs) test_cases.push_back(draw_world(space, noted, seed, run));
  if (runs.size() == kRound) draw_family(test_cases, space, noted, seed, runs);
  return test_cases;
}

std::vector<TestCase> networks_like(const HuntSpace& space, std::size_t map, std::uint64_t seed,
                                    std::size_t count) {
  std::vector<TestCase> test_cases(count);
  for (std::size_t i = 0; i < count; ++i) {
    Dice dice(seed, "network", i);
    test_cases[i].build = space.host_counterpart.value_or(0);
    test_cases[i].map = map;
    test_cases[i].network = network_like(space.maps[map], kUsualPieces, std::ref(dice));
    test_cases[i].stimuli = space.opening;
  }
  return test_cases;
}

std::vector<TestCase> smaller(const TestCase& test_case, const HuntSpace& space) {
  std::vector<TestCase> found;
  const auto with = [&](const auto& change) {
    found.push_back(test_case);
    change(found.back());
  };
  if (test_case.drawn() || test_case.map != 0)
    with([&](TestCase& w) {
      w.track.reset(), w.network.reset(), w.map = 0;
      drop_obstacles(w, space);
    });
  if (!test_case.robot.levels.empty()) with([](TestCase& w) { w.robot.levels.clear(); });
  if (!test_case.faults.faults.empty()) with([](TestCase& w) { w.faults.faults.clear(); });
  if (test_case.stimuli.size() > 1) with([](TestCase& w) { w.stimuli.clear(); });
  const std::vector<Stimulus> opening = opening_of(test_case, space);
  if (test_case.stimuli != opening && test_case.stimuli.size() > opening.size())
    with([&](TestCase& w) { w.stimuli = opening; });
  if (test_case.later_ms != 0)
    with([&](TestCase& w) {
      for (Stimulus& stimulus : w.stimuli)
        if (std::find(opening.begin(), opening.end(), stimulus) != opening.end())
          stimulus.at_ms -= w.later_ms;
      w.later_ms = 0;
    });
  if (const std::size_t half = test_case.stimuli.size() / 2; half > 1) {
    const auto middle = static_cast<std::ptrdiff_t>(half);
    with([&](TestCase& w) { w.stimuli.erase(w.stimuli.begin(), w.stimuli.begin() + middle); });
    with([&](TestCase& w) { w.stimuli.erase(w.stimuli.begin() + middle, w.stimuli.end()); });
  }
  if (test_case.clock_ms != 0 && test_case.differential != Differential::clock)
    with([](TestCase& w) { w.clock_ms = 0; });
  if (test_case.seed != 1) with([](TestCase& w) { w.seed = 1; });
  for (std::size_t i = 0; i < test_case.stimuli.size(); ++i)
    with([&](TestCase& w) { w.stimuli.erase(w.stimuli.begin() + static_cast<std::ptrdiff_t>(i)); });
  if (test_case.faults.faults.size() > 1 || !test_case.faults.faults.empty())
    for (const random_worlds::FaultPlan& plan : test_case.faults.smaller())
      with([&](TestCase& w) { w.faults = plan; });
  if (test_case.track)
    for (const random_worlds::Track& track : test_case.track->smaller())
      with([&](TestCase& w) { w.track = track, drop_obstacles(w, space); });
  if (test_case.network)
    for (const random_worlds::LineNetwork& network : test_case.network->smaller())
      with([&](TestCase& w) { w.network = network, drop_obstacles(w, space); });
  if (!test_case.robot.levels.empty())
    for (const random_worlds::RobotVariant& robot : test_case.robot.smaller())
      with([&](TestCase& w) { w.robot = robot; });
  for (std::size_t i = 0; i < test_case.stimuli.size(); ++i)
    if (const int rounded = test_case.stimuli[i].at_ms / 1000 * 1000;
        rounded > 0 && rounded < test_case.stimuli[i].at_ms)
      with([&](TestCase& w) { w.stimuli[i].at_ms = rounded; });
  return found;
}

std::set<std::string> needs_of(const TestCase& test_case, const HuntSpace& space) {
  std::set<std::string> needs;
  if (test_case.drawn()) needs.insert("a drawn map");
  if (!test_case.drawn() && test_case.map != 0) needs.insert("the map " + space.maps[test_case.map].name);
  for (std::size_t i = 0; i < test_case.robot.levels.size(); ++i)
    if (test_case.robot.levels[i] != 0) {
      const random_worlds::Figure& figure = space.figures[i];
      needs.insert(fmt::format("another {} of {}", figure.key.substr(0, figure.key.find(' ')), figure.table));
    }
  if (test_case.seed != 1) needs.insert("another seed");
  for (const Fault& fault : test_case.faults.faults) {
    constexpr const char* kNames[] = {"offset", "noisy", "cover", "weak", "drift"};
    needs.insert(fmt::format("fault {}", kNames[static_cast<std::size_t>(fault.kind)]));
  }
  const std::vector<Stimulus> opening = opening_of(test_case, space);
  for (const Stimulus& stimulus : test_case.stimuli)
    if (std::find(opening.begin(), opening.end(), stimulus) == opening.end()) needs.insert(stimulus.kind);
  if (test_case.later_ms != 0) needs.insert("a longer wait before the start");
  if (test_case.clock_ms != 0) needs.insert("another clock");
  return needs;
}

std::string map_text(const TestCase& test_case, const HuntSpace& space) {
  if (!test_case.drawn()) return "";
  const HuntSpace::Map& like = space.maps[test_case.map];
  const std::string front = fmt::format(
      "+++\ncell = \"{:g} mm\"\ncorner = \"{:g} mm\"\ngoal = \"{}\"\n[legend]\n3 = \"gap\"\n+++\n",
      like.cell_mm, like.corner_mm, test_case.track ? "laps:1" : "tour");
  return front + (test_case.track ? test_case.track->grid() : test_case.network->map());
}

std::string robot_text(const TestCase& test_case, const HuntSpace& space) {
  if (std::all_of(test_case.robot.levels.begin(), test_case.robot.levels.end(),
                  [](int level) { return level == 0; }))
    return "";
  return test_case.robot.file(space.robot, space.figures);
}

std::vector<map::CellAt> cells_with_line(const map::Map& map) {
  const map::CellAt start = map::default_start(map).cell;
  std::vector<map::CellAt> cells;
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    if (const map::CellAt cell = map.cell_at(i); map::is_line(map.cells[i]) && !(cell == start))
      cells.push_back(cell);
  return cells;
}

std::vector<map::CellAt> cells_with_line(const TestCase& test_case, const HuntSpace& space) {
  if (!test_case.drawn()) return space.maps[test_case.map].line;
  return cells_with_line(map::parse_map(map_text(test_case, space), "world.map"));
}

std::string script_text(const TestCase& test_case, const HuntSpace& space) {
  std::string text = test_case.faults.script(space.limits);
  for (const Stimulus& stimulus : test_case.stimuli) text += script_line(stimulus);
  return text;
}

double line_length_m(const TestCase& test_case, const HuntSpace& space) {
  const random_worlds::LineNetwork network =
      test_case.track ? test_case.track->outline() : test_case.network.value_or(random_worlds::LineNetwork{});
  int cells = 0;
  for (const random_worlds::Piece& piece : network.pieces)
    cells += piece.down ? network.row_of(piece.end().y) - network.row_of(piece.at.y)
                        : network.column_of(piece.end().x) - network.column_of(piece.at.x);
  return cells * space.maps[test_case.map].cell_mm / 1000.0;
}

}  // namespace robosim::campaign
