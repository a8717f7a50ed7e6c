// The worlds of a hunt: how they are drawn, and which are smaller.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim/cli/check/promises.h"
#include "sim/grid/map.h"
#include "sim/worlds/fault_plan.h"
#include "sim/worlds/line_network.h"
#include "sim/worlds/robot_variant.h"
#include "sim/worlds/track.h"

namespace robosim::cli {

/// Something that somebody does to the robot.
struct Deed {
  int at_ms = 0;     ///< from power-on, or from when the sketch has sent `after`
  std::string what;  ///< as scripts have it: "press start 100ms"
  std::string kind;  ///< for people: "press start", "send"
  std::string after = {};
  bool operator==(const Deed&) const = default;
};

inline constexpr const char* kPowerOff = "power off";
inline constexpr const char* kUsedEeprom = "an EEPROM that another sketch has filled";
inline constexpr const char* kObstacle = "an obstacle";
inline constexpr const char* kHeld = "a wheel that is held";
inline constexpr const char* kTwisted = "a twist";  ///< it is turned aside, against its motors

/// Later than what a sketch does once, some time after power-on; a multiple of 2^16, as is what a clock of 16
/// bits begins from here.
inline constexpr std::int64_t kPast_ms = 4 << 16;

/// What a world is made a second time for, and held against: see twin.h.
enum class Twin : std::uint8_t { none, host, clock };

/// When something new was seen in a run: at a time, or behind what the sketch has sent. Nothing where nobody
/// knows.
struct Moment {
  int at_ms = -1;
  std::string after = {};
  bool is_known() const { return at_ms >= 0 || !after.empty(); }
};

struct HuntWorld {
  Twin twin = Twin::none;
  std::size_t build = 0;  ///< of HuntSpace::builds
  std::size_t map = 0;    ///< of HuntSpace::maps, if none is drawn
  std::optional<worlds::Track> track;
  std::optional<worlds::LineNetwork> network;
  worlds::RobotVariant robot;  ///< without levels it is the robot as its file has it
  std::uint64_t seed = 1;
  worlds::FaultPlan faults;
  std::vector<Deed> deeds;
  int later_ms = 0;  ///< than in the plain world is what makes it go: it stands for so long before
  std::int64_t clock_ms = 0;
  std::uint64_t family = 0;  ///< of worlds that are the same up to `parting`, then each has its last deed;
                             ///< 0 = of none. On a chip they are made as one run that parts (wire::Ways)
  Moment parting = {};
  bool to_goal = true;   ///< ends there; else it runs on until its time is up
  bool is_long = false;  ///< takes all the time that there is for a run
  int least_ms = 0;      ///< runs at least so long
  double for_s = 60.0;

  bool drawn() const { return track || network; }
};

/// What there is to choose from.
struct HuntSpace {
  /// What is run: for which target, and whether the sketch checks itself.
  struct Build {
    std::string target;
    bool checked = false;
  };
  struct Map {
    std::string name;
    std::string goal;                       ///< empty = by the map
    bool tracks = false, networks = false;  ///< which maps are drawn as this one is
    int cycles = 0;                         ///< of its network, roughly
    double cell_mm = 100.0, corner_mm = 0.0;
    std::vector<grid::CellAt> line = {};  ///< its cells with line, but for the start
    bool tours = true;                    ///< the sketch comes to its goal on others like it, too
  };
  std::vector<Build> builds;
  std::optional<std::size_t> host_twin;  ///< the build that chips are held against, the last one
  std::vector<Map> maps;
  bool draws_maps = true;
  std::string robot;  ///< the base of its variants: a name or a path
  std::vector<worlds::Figure> figures;
  worlds::Breakable parts;
  worlds::FaultLimits limits;
  std::vector<std::string> buttons;  ///< and keys
  std::vector<std::pair<std::string, std::string>>
      listeners;                   ///< parts that messages come by, and their types
  std::vector<std::string> words;  ///< what may be sent; empty = nothing is
  std::size_t own_words = 0;       ///< the last of them, so many, are the sketch's own
  std::vector<Deed> opening;       ///< what makes it go
  std::vector<std::string> said;   ///< what the sketch has sent in the plain world: how its lines begin, the
                                   ///< last one last
  bool keeps = false;              ///< it uses the EEPROM
  bool feels = false;              ///< a bumper changes what it does, so that something may stand in its way
  std::vector<Promise> promises;
  int for_ms = 60'000;    ///< of a run, at most
  int usual_ms = 60'000;  ///< of most runs
};

/// How long it runs, roughly.
inline int span_ms(const HuntWorld& world, const HuntSpace& space) {
  return std::max(world.least_ms, world.is_long ? space.for_ms : space.usual_ms);
}
/// What makes it go there.
std::vector<Deed> opening_of(const HuntWorld& world, const HuntSpace& space);

/// Those that are drawn.
inline std::size_t drawn_builds(const HuntSpace& space) {
  return space.builds.size() - (space.host_twin ? 1 : 0);
}

/// A world in which something new was seen.
struct Noted {
  HuntWorld world;
  Moment moment = {};
};

/// For each number of a run a world, by it and the hunt's seed. Half of the worlds are like one of those in
/// which something new was seen; a fifth of these branch from it: the same up to the moment, and then
/// something is done to the robot. So are the last ones of a whole round on a chip, all from one moment.
std::vector<HuntWorld> draw_round(const HuntSpace& space, const std::vector<Noted>& noted, std::uint64_t seed,
                                  const std::vector<std::uint64_t>& runs);
inline constexpr std::size_t kRound = 12, kFamily = 3;  ///< worlds

/// So many, in which nothing is done to it, each on another network that is like the map.
std::vector<HuntWorld> networks_like(const HuntSpace& space, std::size_t map, std::uint64_t seed,
                                     std::size_t count);

/// Simpler by a step; those that are simpler by far come first. Ends after finitely many steps.
std::vector<HuntWorld> smaller(const HuntWorld& world, const HuntSpace& space);

/// What of it is not plain: "another map", "chassis track", "fault noisy", "press start". Its opening is.
std::set<std::string> needs_of(const HuntWorld& world, const HuntSpace& space);

/// The cells of its map that have line, but for the start.
std::vector<grid::CellAt> cells_with_line(const HuntWorld& world, const HuntSpace& space);
std::vector<grid::CellAt> cells_with_line(const grid::Map& map);

/// As files have it. The map's is empty where none is drawn; the robot's where it is as in its file.
std::string map_text(const HuntWorld& world, const HuntSpace& space);
std::string robot_text(const HuntWorld& world, const HuntSpace& space);
std::string script_text(const HuntWorld& world, const HuntSpace& space);
/// Of the lines of a drawn map.
double line_length_m(const HuntWorld& world, const HuntSpace& space);

}  // namespace robosim::cli
