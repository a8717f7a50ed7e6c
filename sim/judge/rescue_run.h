// RoboCupJunior Rescue Line, or Line Entry ([rescue] league): along the whole first path, tile by tile.
// Points are those of the organisers' scoring software for 2025 and 2026 (rcj-rescue-cms,
// scoreCalculatorRules), and for Entry those of its rules (rescue-line-entry-rules, May 2026, 4.7). n is the
// number of lacks of progress:
//
//                                Line           Entry
//   start tile left              5              -
//   each tile up to a checkpoint, or up to the end, once that is reached
//                                5 - 2 n, not below 0; n since the previous checkpoint
//   tile with one or more gaps   10             10
//   tile with one or more speed bumps
//                                10             10
//   tile of a ramp               10             10
//   intersection                 10             -
//   obstacle                     20             10
//   seesaw                       20             -
//   end tile, at rest for 5 s (from memory)
//                                60 - 5 n >= 0  -
//
// If the path ends at the evacuation zone there is no end tile, and no rest. The elements of a tile count
// when the middle of the robot's axle is on the next tile. A gap is an unpainted stretch of the path; an
// obstacle is a wall on the path; an intersection is a place where the path crosses itself or another path.
//
// A [[hill]] on the path is a seesaw if it has a pivot. It is a speed bump if it is up to 10 mm high, and
// higher than the 3 mm that tiles may differ by. If a higher one rises or falls by 10 mm on a tile, that is a
// ramp.
//
// A lack of progress occurs when the robot is neither on its last tile nor on its neighbours on the path.
// It also occurs when the robot would be lost or stuck (verdicts.md), or when a script picks it up. Around an
// obstacle it may be anywhere within 1.5 tiles. The captain then puts it on the last checkpoint, or the
// start. After the third lack in a row it goes to the next checkpoint; the tiles in between do not count.
//
// Time is up after 8 min, Entry 6 min, from the beginning of the run. Not modelled: evacuation zone and
// victims.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/grid/map.h"
#include "sim/judge/rules_input.h"

namespace robosim::judge {

class RescueRun {
 public:
  /// Throws InputError if the map has no [rescue], or its path has less than two tiles.
  RescueRun(const grid::Map& map, Vec2 start);

  void look(const RulesInput& now, Events& events);
  bool reached() const { return reached_; }
  bool over(SimTime t) const { return t >= time_limit_; }
  /// Counts a lost or stuck robot as a lack of progress.
  void give_up(Events& events);
  /// Returns the captain's new place for the robot now, once.
  std::optional<Pose> take_hand();
  std::string summary() const;
  void score(wire::Metrics& metrics) const;

 private:
  /// A visit of a tile by the path.
  struct Step {
    int column = 0, row = 0;
    double from = 0.0, to = 0.0;  ///< m along the path
    int intersections = 0, obstacles = 0, seesaws = 0;
    bool gap = false, bump = false, ramp = false;
    bool checkpoint = false;
    bool done = false;  ///< its elements have counted
  };
  void make_steps();
  int column_of(Vec2 at) const;
  int row_of(Vec2 at) const;
  void mark(const grid::Map& map);
  void mark_hills(const grid::Map& map);
  Step* step_at(double along);
  void arrive(std::size_t step, Events& events);
  void count(const char* part, int points, int times, Events& events);
  bool is_near_obstacle(Vec2 at) const;
  bool is_in(const Step& step, Vec2 at) const;

  grid::Path path_;
  double tile_;
  Vec2 origin_;
  Vec2 start_;
  bool to_zone_;
  bool is_entry_;
  SimTime time_limit_;
  std::vector<Step> steps_;
  std::vector<Vec2> obstacles_;
  std::size_t at_ = 0;              ///< the last step it was on
  std::size_t counted_to_ = 0;      ///< earlier tiles have counted, or never will
  std::size_t checkpoint_ = 0;      ///< the last one: 0 = the start
  int lacks_here_ = 0, lacks_ = 0;  ///< since the last checkpoint, and in all
  std::vector<wire::ScorePart> parts_;
  std::optional<Pose> hand_;
  SimTime began_ = kNever, ended_ = kNever, at_rest_since_ = kNever;
  bool in_hand_ = false, reached_ = false;
};

}  // namespace robosim::judge
