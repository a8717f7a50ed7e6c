// Observes a robot for `robosim compare`: finds the places that the robot reaches, and requests the events of
// a run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/campaign/analysis/history.h"
#include "sim/campaign/compare/target_runs.h"
#include "sim/map/map.h"
#include "sim/map/places.h"

namespace robosim::campaign {

/// Selects a robot of a target run, and the settings of the run that is observed.
struct ObservedRobot {
  std::size_t robot = 0;
  std::uint64_t seed = 1;
  std::int64_t until_ns = 0;           ///< latest end of the run; rounded down to whole milliseconds
  std::vector<result::Lateness> late;  ///< delays of the robot's sketch
};

/// The deviation of a robot's clock in a run.
struct ClockOffset {
  std::int64_t from_ns = 0;
  int ppm = 0;  ///< error of the clock, parts per million; above 0 = fast
};

class Observer {
 public:
  /// Uses the map and the robots' starts in `request`.
  explicit Observer(const wire::RunRequest& request);
  Observer(const Observer&) = delete;

  std::size_t robots() const { return places_.size(); }
  /// The recorder must not outlive this observer.
  analysis::HistoryRecorder recorder_of(const TargetRun& target_run, std::size_t robot) const;
  static wire::RunRequest request_of(const TargetRun& target_run, std::uint64_t seed);
  static bool is_of(const wire::Event& event, std::size_t robot);
  /// Makes a run in which the clock of the observed robot is wrong by `off`. The clocks of the other robots
  /// are wrong in the opposite direction: chance may also decide which robot comes first at a crossing.
  analysis::History run(TargetRun& target_run, const ObservedRobot& observed,
                        const ClockOffset& off = {}) const;

 private:
  std::string place_of(std::size_t robot, const wire::Sample& sample) const;

  map::Map map_;
  std::vector<map::Places> places_;  ///< for each robot; its start determines the stations' numbers
};

}  // namespace robosim::campaign
