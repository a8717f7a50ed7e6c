// Scores RoboCupJunior Rescue Line, or Line Entry ([rescue] league). The robot follows the whole first path,
// tile by tile. The points for Line are those of the organisers' scoring software for 2025 and 2026
// (rcj-rescue-cms, scoreCalculatorRules). The points for Entry are those of the rules
// (rescue-line-entry-rules, May 2026, 4.7). n is the number of lacks of progress:
//
//                                Line           Entry
//   start tile left              5              -
//   each tile up to a checkpoint or the end, counted when the robot reaches that checkpoint or end
//                                5 - 2 n, not below 0; n since the previous checkpoint
//   tile with one or more gaps   10             10
//   tile with one or more speed bumps
//                                10             10
//   tile of a ramp               10             10
//   intersection                 10             -
//   obstacle                     20             10
//   seesaw                       20             -
//   end tile, at rest for 5 s (duration unverified)
//                                60 - 5 n >= 0  -
//
// If the path ends at the evacuation zone, there is no end tile, and the robot need not come to rest. The
// elements of a tile count when the middle of the robot's axle is on the next tile. A gap is an unpainted
// stretch of the path; an obstacle is a wall on the path; an intersection is a place where the path crosses
// itself or another path.
//
// A [[hill]] on the path is a seesaw if it has a pivot. A hill is a speed bump if it is more than 3 mm and up
// to 10 mm high. Lower hills are ignored, because the heights of neighbouring tiles may differ by 3 mm. A
// tile is a ramp if a higher hill rises or falls by more than 10 mm on the tile.
//
// A lack of progress occurs when the robot is neither on its last tile nor on the tile's neighbours on the
// path. Near an obstacle, the robot may be anywhere within 1.5 tiles of the obstacle. A lack of progress also
// occurs if the robot is lost or stuck (judge.h), or a script picks the robot up. After a lack of progress,
// the team's captain puts the robot on the last checkpoint, or on the start. After the third lack in a row,
// the captain puts the robot on the next checkpoint; the tiles in between do not count.
//
// The time limit is 8 min (Entry: 6 min) from the beginning of the run. Not modelled: evacuation zone and
// victims.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/judge/rules_input.h"
#include "sim/map/map.h"

namespace robosim::judge {

class RescueRun {
 public:
  /// Throws InputError if the map has no [rescue], or its path covers fewer than two tiles.
  RescueRun(const map::Map& map, Vec2 start);

  void look(const RulesInput& now, Events& events);
  bool reached() const { return reached_; }
  bool over(SimTime t) const { return t >= time_limit_; }
  /// Counts a lost or stuck robot as a lack of progress.
  void give_up(Events& events);
  /// Returns the pose at which the captain will put the robot, and clears the pending move; nullopt = none.
  std::optional<Pose> take_hand();
  std::string summary() const;
  void score(result::Metrics& metrics) const;

 private:
  /// A stretch of the path on one tile. The path may cross a tile several times.
  struct Step {
    int column = 0, row = 0;
    double from = 0.0, to = 0.0;  ///< m along the path
    int intersections = 0, obstacles = 0, seesaws = 0;
    bool gap = false, bump = false, ramp = false;
    bool checkpoint = false;
    bool done = false;  ///< the tile's elements have been counted
  };
  void make_steps();
  int column_of(Vec2 at) const;
  int row_of(Vec2 at) const;
  void mark(const map::Map& map);
  void mark_hills(const map::Map& map);
  Step* step_at(double along);
  void arrive(std::size_t step, Events& events);
  void count(const char* part, int points, int times, Events& events);
  bool is_near_obstacle(Vec2 at) const;
  bool is_in(const Step& step, Vec2 at) const;

  map::Path path_;
  double tile_;
  Vec2 origin_;
  Vec2 start_;
  bool to_zone_;
  bool is_entry_;
  SimTime time_limit_;
  std::vector<Step> steps_;
  std::vector<Vec2> obstacles_;
  std::size_t at_ = 0;              ///< the robot's last step
  std::size_t counted_to_ = 0;      ///< the tiles before this step have been counted, or never will be
  std::size_t checkpoint_ = 0;      ///< the last checkpoint; 0 = the start
  int lacks_here_ = 0, lacks_ = 0;  ///< lacks of progress since the last checkpoint, and in total
  std::vector<result::ScorePart> parts_;
  std::optional<Pose> hand_;
  SimTime began_ = kNever, ended_ = kNever, at_rest_since_ = kNever;
  bool in_hand_ = false, reached_ = false;
};

}  // namespace robosim::judge
