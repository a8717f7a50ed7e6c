// Performs a script's changes of the world: obstacles, paint on the floor, doors, lights.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/map/map.h"
#include "sim/map/stripes.h"
#include "sim/result/events.h"
#include "sim/run/scenario/scenario.h"
#include "sim/world/world.h"

namespace robosim::scenario {

class WorldChanges {
 public:
  WorldChanges(const map::Map& map, const map::Stripes& stripes, world::World& world)
      : map_(map), stripes_(stripes), world_(world) {}

  /// Checks an action. Throws InputError for unknown objects. Accepts any action that does not change the
  /// world.
  void check(const Action& action) const;
  result::ScriptActed put_obstacle(const Action& action, SimTime t);
  void clear_obstacle(const std::string& cell);
  /// Runs paint, erase, door or light.
  result::ScriptActed perform(const Action& action);
  /// Undoes paint, erase, door or light.
  result::ScriptActed undo(const Action& action);
  /// Moves moving obstacles to their places at `t`.
  void act(SimTime t) {
    if (!state_.obstacles.empty()) move_obstacles(t);
  }

  /// Returns whether act() may move something.
  bool go_on() const { return !state_.obstacles.empty(); }

  struct Obstacle {
    map::CellAt cell;               ///< initial cell of the obstacle
    int number;                     ///< number of the obstacle in the world
    Vec2 from = {}, to = {};        ///< m, start and end of a moving obstacle's path
    SimTime began = 0, period = 0;  ///< period 0: the obstacle does not move
  };
  /// The state that changes during a run. The keys of the maps are the script's words, such as "2,3 5,3".
  struct State {
    std::vector<Obstacle> obstacles;
    std::map<std::string, int> patches;             ///< numbers of patches in the world
    std::map<std::string, std::vector<int>> doors;  ///< numbers of the discs that form a closed door
  };
  const State& save() const { return state_; }
  void restore(const State& saved) { state_ = saved; }

 private:
  void move_obstacles(SimTime t);
  void bring_about(const Action& action);
  Vec2 place_of(map::CellAt cell) const;
  double half_width(const Action& action) const;
  result::ScriptActed told(const char* verb, const Action& action) const;
  std::vector<std::size_t> lights_of(const std::string& text) const;
  void remove_patch(const std::string& text);
  void add_patch(const Action& action);
  void open_door(const std::string& text);
  void shut_door(const std::string& text);

  const map::Map& map_;
  const map::Stripes& stripes_;
  world::World& world_;
  State state_;
};

}  // namespace robosim::scenario
