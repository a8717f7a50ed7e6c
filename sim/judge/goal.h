// Defines the goals of a run, and measures the progress towards the goal.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/judge/contest.h"
#include "sim/map/map.h"
#include "sim/map/network.h"
#include "sim/map/stripes.h"
#include "sim/world/body.h"

namespace robosim::judge {

struct Goal {
  enum class Kind {
    tour,         ///< all reachable stations visited, then the start's centre covered again
    laps,         ///< `laps` times round the loop in either direction, with every node passed in order
    station,      ///< `station` visited, and at rest there for 0.5 s
    robotrace,    ///< from the start line to the goal line of the map's [race], then at rest between the two
    ukmars,       ///< like robotrace, but the robot need not come to rest
    drag_race,    ///< along a straight, and to a stop after the goal line
    rescue_line,  ///< over the tiles of the map's [rescue]
    line_maze,    ///< to the disc, `tries` times
    still,        ///< no wheel turned for 1 s after the robot had moved
    none,         ///< the time is up without a failure
  };
  Kind kind = Kind::tour;
  int laps = 1;
  int tries = 1;        ///< number of tries of line_maze
  std::string station;  ///< number or name of the station
  bool operator==(const Goal&) const = default;
};

/// Parses "tour", "laps:3", "station:2", "robotrace", "ukmars", "drag-race", "rescue-line", "line-maze",
/// "line-maze:3", "still" or "none". Throws InputError with a list of the valid goals.
Goal parse_goal(std::string_view text);
std::string to_string(const Goal& goal);
/// Returns the goal in the map file. Without a goal in the file, returns `laps:1` on a single loop, and
/// `tour` on other maps.
Goal default_goal(const map::Map& map, const map::Network& network);

/// A station or junction to visit.
struct Waypoint {
  std::string name;
  Vec2 centre;  ///< in metres
  bool visited = false;
};

/// Watches a body and reports when the goal is reached. A station is visited once the body's outline has
/// covered the station's centre.
class Progress {
 public:
  /// Throws InputError if the goal is impossible on this map: laps without a loop, an unknown station.
  Progress(const Goal& goal, const map::Map& map, const map::Stripes& stripes, const map::Network& network,
           const map::Start& start);

  /// Updates the progress. Must be called once per tick with the time at the tick's end. Appends visited
  /// stations and completed laps to `events`. Stations and nodes are checked only after the body has moved by
  /// some distance. Competitions, and the goals `station` and `still`, are checked in each tick.
  void update(const world::Body& body, SimTime t, Events& events) {
    if (!passes_by(body)) look(body, t, events);
  }

  /// Updates the progress. Call this function if passes_by() is false.
  void look(const world::Body& body, SimTime t, Events& events);
  /// Returns whether an update would change nothing. The function is inline, because each tick calls it.
  [[gnu::always_inline]] bool passes_by(const world::Body& body) const {
    return !takes_time_ && is_near(body.pose()) && !at_rest(body) &&
           !(is_around_origin_ && may_depart(body.pose()));
  }
  /// Returns whether further updates would have the same result while the body stays in place.
  bool is_settled(const world::Body& body) const;
  bool reached() const { return reached_; }
  /// Returns one clause that states what is missing, or what was achieved.
  std::string summary() const;

  const std::vector<Waypoint>& stations() const { return stations_; }
  /// Returns indices into stations() in the order of the first visit.
  const std::vector<int>& visited() const { return visited_; }
  /// Returns the duration of each complete lap in seconds. The first lap begins when the body has left its
  /// start by 1 cm: waiting and calibrating on the spot do not count.
  const std::vector<double>& laps_s() const { return laps_s_; }
  int junctions_visited() const { return junctions_visited_; }
  bool is_visited(const std::string& station) const;
  /// Returns the contest, which converts to true if the goal is a competition.
  Contest& contest() { return contest_; }
  const Contest& contest() const { return contest_; }
  /// Adds the present score of a competition.
  void score(result::Metrics& metrics) const { contest_.score(metrics); }

 private:
  // The progress of a lap in one direction.
  struct Lap {
    std::size_t next = 1;
    SimTime began = 0;
    int complete = 0;
  };

  // Stations and nodes are checked when the body has moved by kCheckEvery (m), has turned by acos(kCheckTurn)
  // (1.1 degrees), or has stopped. The first lap begins at the distance kDeparture (m) from the start.
  static constexpr double kCheckEvery = 4e-3, kCheckTurn = 0.9998, kDeparture = 0.01;
  // A body counts as at rest below both speeds (m/s and rad/s).
  static constexpr double kRestSpeed = 1e-3, kRestTurn = 0.01;

  static double square(Vec2 a) { return dot(a, a); }
  static bool at_rest(const world::Body& body) {
    return std::abs(body.speed()) < kRestSpeed && std::abs(body.turn_rate()) < kRestTurn;
  }
  bool is_near(const Pose& pose) const {
    return square(pose.position - checked_at_) < kCheckEvery * kCheckEvery &&
           dot(pose.heading, checked_heading_) > kCheckTurn;
  }
  bool may_depart(const Pose& pose) const {
    return laps_s_.empty() && square(pose.position - *origin_) < kDeparture * kDeparture;
  }
  /// Returns whether the body covers none of the remaining places.
  bool is_far_from_places(Vec2 position) const {
    return square(position - searched_at_) < free_reach_ * free_reach_;
  }
  void find_nothing();
  void search_places(const world::Body& body);
  void visit_places(const world::Body& body, Events& events);
  void begin_at(Vec2 position);
  void follow_loop(Vec2 position);
  bool has_gone_round(bool backwards);
  /// Returns the next point of a lap.
  Vec2 loop_point(const Lap& lap, bool backwards) const;
  bool advance(Lap& lap, bool backwards, const world::Body& body, SimTime t, Events& events);
  void compete(const RulesInput& now, Events& events);
  bool tour_done(const world::Body& body);
  bool rests_at_station(const world::Body& body, SimTime t);
  bool stands_still(const world::Body& body, SimTime t);

  Goal goal_;
  std::vector<Waypoint> stations_;
  std::vector<Waypoint> junctions_;
  std::vector<Vec2> loop_;
  Vec2 start_;
  bool left_start_ = false;
  std::vector<int> visited_;
  int junctions_visited_ = 0;
  std::vector<double> laps_s_;
  Lap forwards_, backwards_;
  // The number of the loop's node nearest to the body. The number does not wrap: a forward lap increases it
  // by the number of nodes. If the robot turns back, this number decreases, but Lap::next does not.
  std::int64_t node_ = 0;
  std::int64_t lap_node_ = 0;  ///< value of node_ at which the present lap began
  int goal_station_ = -1;
  Contest contest_;
  SimTime at_rest_since_ = kNever;
  bool has_moved_ = false;
  std::optional<Vec2> origin_;  ///< the body's first position
  Vec2 checked_at_{1e9, 1e9};   ///< far away before the first check
  Vec2 checked_heading_;
  bool takes_time_;               ///< the rules or the goal need a check in each tick
  bool is_around_origin_ = true;  ///< the body may be within kDeparture of origin_ until the next check
  Vec2 searched_at_;              ///< the body's position in the last search
  double free_reach_ = 0.0;       ///< within this distance (m) of searched_at_, no remaining place is covered
  bool reached_ = false;
};

}  // namespace robosim::judge
