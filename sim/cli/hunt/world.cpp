#include "sim/cli/hunt/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "sim/base/noise.h"
#include "sim/cli/hunt/deeds.h"
#include "sim/worlds/die.h"

namespace robosim::cli {
namespace {

using worlds::Die;
using worlds::Fault;

constexpr int kMostSquares = 4, kMostPieces = 10, kUsualPieces = 5, kFewPieces = 3, kMostFaults = 2;
constexpr int kMostSeeds = 1000;
constexpr int kHeldFor_ms = 300, kAfterHeld_ms = 4'000;  // a button at power-on
constexpr int kLongBefore_ms = 40'000, kBehindDeed_ms = 4'000;
constexpr std::uint64_t kPairEvery = 6;
constexpr std::int64_t kMillisWrap_ms = std::int64_t{1} << 32;
constexpr std::int64_t kMicrosWrap_ms = kMillisWrap_ms / 1000;
constexpr std::int64_t kInt_ms = std::int64_t{1} << 15;
constexpr int kBlockedAfter_ms = 10'000, kBlockedFor_ms = 20'000;  // by when it has met the obstacle

/// Wide enough for the bends of the map that it should resemble.
int apart(const HuntSpace::Map& map) {
  return std::max(4, static_cast<int>(std::ceil(2.0 * map.corner_mm / map.cell_mm)));
}

worlds::LineNetwork network_like(const HuntSpace::Map& map, int pieces, const Die& die) {
  return worlds::grow({pieces, 3, 4, map.cycles, 0}, die);
}

void draw_map(HuntWorld& world, const HuntSpace& space, const Die& die, int most_pieces = kMostPieces) {
  world.track.reset();
  world.network.reset();
  world.map = static_cast<std::size_t>(die(static_cast<int>(space.maps.size())));
  const HuntSpace::Map& like = space.maps[world.map];
  if (!space.draws_maps || chance(die, 40)) return;
  if (like.tracks) world.track = worlds::lay_out({1 + die(kMostSquares), apart(like), 0}, die);
  if (like.networks) world.network = network_like(like, 1 + die(most_pieces), die);
}

/// Many sketches read their buttons at power-on; the button is released long before the robot starts.
void hold_a_button_at_power_on(HuntWorld& world, const HuntSpace& space, const Die& die) {
  const std::string kind = "press " + pick(die, space.buttons);
  const int first_ms = space.opening.empty() ? kAfterHeld_ms : space.opening.front().at_ms;
  world.later_ms = std::max(world.later_ms, kAfterHeld_ms - first_ms);
  world.deeds = opening_of(world, space);
  world.deeds.insert(world.deeds.begin(), {0, kind + fmt::format(" {}ms", kHeldFor_ms), kind});
}

/// Draws a clock just before the milliseconds, or microseconds, overflow.
void draw_clock(HuntWorld& world, const HuntSpace& space, const Die& die) {
  const std::int64_t wrap =
      pick<std::int64_t>(die, {kMillisWrap_ms, kMillisWrap_ms, kMillisWrap_ms / 2, kMicrosWrap_ms,
                               kPast_ms + kInt_ms, kPast_ms + 2 * kInt_ms});
  int runs_ms = die(std::min<int>(span_ms(world, space) / 2, static_cast<int>(kInt_ms)));
  // In half of the cases a little after a stimulus.
  if (!world.deeds.empty() && chance(die, 50))
    if (const Deed& deed = pick(die, world.deeds); deed.after.empty())
      runs_ms = std::min(deed.at_ms + die(kBehindDeed_ms), static_cast<int>(kInt_ms));
  world.clock_ms = wrap - 1 - runs_ms;
}

/// Its clock wraps to 0 while an obstacle blocks it.
void draw_wrap_while_blocked(HuntWorld& world, const HuntSpace& space, const Die& die) {
  block(world, space, die);
  world.is_long = true;
  world.clock_ms = kMillisWrap_ms - std::min(space.for_ms / 2, kBlockedAfter_ms + die(kBlockedFor_ms));
}

/// Draws a pair of worlds without faults.
HuntWorld pair(const HuntSpace& space, const Die& die) {
  HuntWorld world;
  world.twin = space.host_twin && chance(die, space.feels ? 50 : 70) ? Twin::host : Twin::clock;
  world.deeds = space.opening;
  draw_map(world, space, die, kFewPieces);
  world.seed = 1 + static_cast<std::uint64_t>(die(kMostSeeds));
  world.is_long = chance(die, 20);
  if (world.twin == Twin::clock && space.feels && chance(die, 60)) {
    draw_wrap_while_blocked(world, space, die);
  } else {
    if (hears(space) && chance(die, 80)) draw_talk(world, space, die);
    if (world.twin == Twin::host && chance(die, hears(space) ? 15 : 60)) draw_late_deeds(world, space, die);
    // A power cut splits a text elsewhere if something takes a millisecond longer.
    if (world.twin == Twin::host)
      std::erase_if(world.deeds, [](const Deed& deed) { return deed.kind == kPowerOff; });
    if (world.twin == Twin::clock) draw_clock(world, space, die);
  }
  world.to_goal = false;
  return world;
}

HuntWorld fresh(const HuntSpace& space, const Die& die) {
  HuntWorld world;
  world.is_long = chance(die, 20);
  if (!space.opening.empty() && chance(die, 15)) world.later_ms = 1'000 + die(kLongBefore_ms);
  world.deeds = opening_of(world, space);
  draw_map(world, space, die);
  if (chance(die, 50)) world.robot = worlds::assemble(space.figures, die);
  world.seed = 1 + static_cast<std::uint64_t>(die(kMostSeeds));
  if (chance(die, 35)) world.faults = worlds::draw_up(space.limits, kMostFaults, space.parts, die);
  if (hears(space) && chance(die, 30)) {
    draw_map(world, space, die, kFewPieces);
    draw_talk(world, space, die);
  } else if (chance(die, 45)) {
    draw_deeds(world, space, die);
  } else if (!space.buttons.empty() && chance(die, 15)) {
    hold_a_button_at_power_on(world, space, die);
  }
  if (space.keeps && chance(die, 25))
    world.deeds.insert(world.deeds.begin(), {0, "fault eeprom used", kUsedEeprom});
  if (chance(die, 12)) draw_clock(world, space, die);
  world.to_goal = chance(die, 60);
  return world;
}

/// Drops obstacles that were on a line of another map.
void drop_obstacles(HuntWorld& world, const HuntSpace& space) {
  const std::vector<grid::CellAt> line = cells_with_line(world, space);
  std::erase_if(world.deeds, [&](const Deed& deed) {
    return deed.kind == kObstacle && std::none_of(line.begin(), line.end(), [&](grid::CellAt cell) {
             return deed.what.starts_with(fmt::format("obstacle {},{} ", cell.x, cell.y));
           });
  });
}

HuntWorld like(const Noted& noted, const HuntSpace& space, const Die& die) {
  HuntWorld world = noted.world;
  world.twin = Twin::none;
  if (noted.moment.is_known() && chance(die, 20)) {
    add_deed_behind(world, noted.moment, space, die);
    return world;
  }
  switch (die(6)) {
    case 0:
      draw_map(world, space, die);
      drop_obstacles(world, space);
      break;
    case 1:
      world.robot = worlds::assemble(space.figures, die);
      break;
    case 2:
      world.faults = worlds::draw_up(space.limits, kMostFaults, space.parts, die);
      break;
    case 3:
      draw_clock(world, space, die);
      break;
    default:
      add_deed(world, space, die);
  }
  world.seed = 1 + static_cast<std::uint64_t>(die(kMostSeeds));
  return world;
}

/// Most worlds run on the host, which is many times as fast as a chip. The robot's behaviour is only judged
/// without checks.
std::size_t draw_build(const HuntSpace& space, std::uint64_t run, const Die& die) {
  if (!space.host_twin) return static_cast<std::size_t>(run % 2 == 0 ? 0 : run / 2 % drawn_builds(space));
  if (chance(die, 55)) return *space.host_twin;
  std::vector<std::size_t> builds{0, 0};
  for (std::size_t i = 0; i < drawn_builds(space); ++i)
    builds.insert(builds.end(), space.builds[i].target == "host" ? 3 : 1, i);
  return pick(die, builds);
}

/// Draws the worlds one by one, by a number that determines them.
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

HuntWorld draw_world(const HuntSpace& space, const std::vector<Noted>& noted, std::uint64_t seed,
                     std::uint64_t run) {
  Dice dice(seed, "world", run);
  const Die die = std::ref(dice);
  if (run % kPairEvery == kPairEvery - 1 && space.builds.front().target != "host") return pair(space, die);
  HuntWorld world =
      !noted.empty() && chance(die, 50) ? like(pick(die, noted), space, die) : fresh(space, die);
  world.build = draw_build(space, run, die);
  if (space.builds[world.build].target == "host") world.clock_ms = 0;
  return world;
}

/// Turns the last worlds of a round into a family, if there is a chip, and a moment to branch from.
void draw_family(std::vector<HuntWorld>& worlds, const HuntSpace& space, const std::vector<Noted>& noted,
                 std::uint64_t seed, const std::vector<std::uint64_t>& runs) {
  std::vector<std::size_t> chips;
  for (std::size_t i = 0; i < drawn_builds(space); ++i)
    if (space.builds[i].target != "host") chips.insert(chips.end(), space.builds[i].checked ? 1 : 2, i);
  std::vector<const Noted*> known;
  for (const Noted& one : noted)
    if (one.moment.is_known()) known.push_back(&one);
  if (chips.empty() || known.empty()) return;
  Dice dice(seed, "family", runs.front());
  const Die die = std::ref(dice);
  const Noted& from = *pick(die, known);
  const std::size_t build = pick(die, chips);
  for (std::size_t i = kRound - kFamily; i < kRound; ++i) {
    Dice own(seed, "branch", runs[i]);
    HuntWorld& world = worlds[i] = from.world;
    world.twin = Twin::none;
    world.build = build;
    world.family = runs.front() + 1;
    world.parting = from.moment;
    branch(world, space, std::ref(own));
  }
}

}  // namespace

std::vector<Deed> opening_of(const HuntWorld& world, const HuntSpace& space) {
  std::vector<Deed> opening = space.opening;
  for (Deed& deed : opening) deed.at_ms += world.later_ms;
  return opening;
}

std::vector<HuntWorld> draw_round(const HuntSpace& space, const std::vector<Noted>& noted, std::uint64_t seed,
                                  const std::vector<std::uint64_t>& runs) {
  std::vector<HuntWorld> worlds;
  for (const std::uint64_t run : runs) worlds.push_back(draw_world(space, noted, seed, run));
  if (runs.size() == kRound) draw_family(worlds, space, noted, seed, runs);
  return worlds;
}

std::vector<HuntWorld> networks_like(const HuntSpace& space, std::size_t map, std::uint64_t seed,
                                     std::size_t count) {
  std::vector<HuntWorld> worlds(count);
  for (std::size_t i = 0; i < count; ++i) {
    Dice dice(seed, "network", i);
    worlds[i].build = space.host_twin.value_or(0);
    worlds[i].map = map;
    worlds[i].network = network_like(space.maps[map], kUsualPieces, std::ref(dice));
    worlds[i].deeds = space.opening;
  }
  return worlds;
}

std::vector<HuntWorld> smaller(const HuntWorld& world, const HuntSpace& space) {
  std::vector<HuntWorld> found;
  const auto with = [&](const auto& change) {
    found.push_back(world);
    change(found.back());
  };
  if (world.drawn() || world.map != 0)
    with([&](HuntWorld& w) {
      w.track.reset(), w.network.reset(), w.map = 0;
      drop_obstacles(w, space);
    });
  if (!world.robot.levels.empty()) with([](HuntWorld& w) { w.robot.levels.clear(); });
  if (!world.faults.faults.empty()) with([](HuntWorld& w) { w.faults.faults.clear(); });
  if (world.deeds.size() > 1) with([](HuntWorld& w) { w.deeds.clear(); });
  const std::vector<Deed> opening = opening_of(world, space);
  if (world.deeds != opening && world.deeds.size() > opening.size())
    with([&](HuntWorld& w) { w.deeds = opening; });
  if (world.later_ms != 0)
    with([&](HuntWorld& w) {
      for (Deed& deed : w.deeds)
        if (std::find(opening.begin(), opening.end(), deed) != opening.end()) deed.at_ms -= w.later_ms;
      w.later_ms = 0;
    });
  if (const std::size_t half = world.deeds.size() / 2; half > 1) {
    const auto middle = static_cast<std::ptrdiff_t>(half);
    with([&](HuntWorld& w) { w.deeds.erase(w.deeds.begin(), w.deeds.begin() + middle); });
    with([&](HuntWorld& w) { w.deeds.erase(w.deeds.begin() + middle, w.deeds.end()); });
  }
  if (world.clock_ms != 0 && world.twin != Twin::clock) with([](HuntWorld& w) { w.clock_ms = 0; });
  if (world.seed != 1) with([](HuntWorld& w) { w.seed = 1; });
  for (std::size_t i = 0; i < world.deeds.size(); ++i)
    with([&](HuntWorld& w) { w.deeds.erase(w.deeds.begin() + static_cast<std::ptrdiff_t>(i)); });
  if (world.faults.faults.size() > 1 || !world.faults.faults.empty())
    for (const worlds::FaultPlan& plan : world.faults.smaller()) with([&](HuntWorld& w) { w.faults = plan; });
  if (world.track)
    for (const worlds::Track& track : world.track->smaller())
      with([&](HuntWorld& w) { w.track = track, drop_obstacles(w, space); });
  if (world.network)
    for (const worlds::LineNetwork& network : world.network->smaller())
      with([&](HuntWorld& w) { w.network = network, drop_obstacles(w, space); });
  if (!world.robot.levels.empty())
    for (const worlds::RobotVariant& robot : world.robot.smaller())
      with([&](HuntWorld& w) { w.robot = robot; });
  for (std::size_t i = 0; i < world.deeds.size(); ++i)
    if (const int rounded = world.deeds[i].at_ms / 1000 * 1000; rounded > 0 && rounded < world.deeds[i].at_ms)
      with([&](HuntWorld& w) { w.deeds[i].at_ms = rounded; });
  return found;
}

std::set<std::string> needs_of(const HuntWorld& world, const HuntSpace& space) {
  std::set<std::string> needs;
  if (world.drawn()) needs.insert("a drawn map");
  if (!world.drawn() && world.map != 0) needs.insert("the map " + space.maps[world.map].name);
  for (std::size_t i = 0; i < world.robot.levels.size(); ++i)
    if (world.robot.levels[i] != 0) {
      const worlds::Figure& figure = space.figures[i];
      needs.insert(fmt::format("another {} of {}", figure.key.substr(0, figure.key.find(' ')), figure.table));
    }
  if (world.seed != 1) needs.insert("another seed");
  for (const Fault& fault : world.faults.faults) {
    constexpr const char* kNames[] = {"offset", "noisy", "cover", "weak", "drift"};
    needs.insert(fmt::format("fault {}", kNames[static_cast<std::size_t>(fault.kind)]));
  }
  const std::vector<Deed> opening = opening_of(world, space);
  for (const Deed& deed : world.deeds)
    if (std::find(opening.begin(), opening.end(), deed) == opening.end()) needs.insert(deed.kind);
  if (world.later_ms != 0) needs.insert("a longer wait before the start");
  if (world.clock_ms != 0) needs.insert("another clock");
  return needs;
}

std::string map_text(const HuntWorld& world, const HuntSpace& space) {
  if (!world.drawn()) return "";
  const HuntSpace::Map& like = space.maps[world.map];
  const std::string front = fmt::format(
      "+++\ncell = \"{:g} mm\"\ncorner = \"{:g} mm\"\ngoal = \"{}\"\n[legend]\n3 = \"gap\"\n+++\n",
      like.cell_mm, like.corner_mm, world.track ? "laps:1" : "tour");
  return front + (world.track ? world.track->grid() : world.network->map());
}

std::string robot_text(const HuntWorld& world, const HuntSpace& space) {
  if (std::all_of(world.robot.levels.begin(), world.robot.levels.end(), [](int level) { return level == 0; }))
    return "";
  return world.robot.file(space.robot, space.figures);
}

std::vector<grid::CellAt> cells_with_line(const grid::Map& map) {
  const grid::CellAt start = grid::default_start(map).cell;
  std::vector<grid::CellAt> cells;
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    if (const grid::CellAt cell = map.cell_at(i); grid::is_line(map.cells[i]) && !(cell == start))
      cells.push_back(cell);
  return cells;
}

std::vector<grid::CellAt> cells_with_line(const HuntWorld& world, const HuntSpace& space) {
  if (!world.drawn()) return space.maps[world.map].line;
  return cells_with_line(grid::parse_map(map_text(world, space), "world.map"));
}

std::string script_text(const HuntWorld& world, const HuntSpace& space) {
  std::string text = world.faults.script(space.limits);
  for (const Deed& deed : world.deeds) text += script_line(deed);
  return text;
}

double line_length_m(const HuntWorld& world, const HuntSpace& space) {
  const worlds::LineNetwork network =
      world.track ? world.track->outline() : world.network.value_or(worlds::LineNetwork{});
  int cells = 0;
  for (const worlds::Piece& piece : network.pieces)
    cells += piece.down ? network.row_of(piece.end().y) - network.row_of(piece.at.y)
                        : network.column_of(piece.end().x) - network.column_of(piece.at.x);
  return cells * space.maps[world.map].cell_mm / 1000.0;
}

}  // namespace robosim::cli
