// Creates all detectors for a robot in a run, and passes each tick to the detectors that examine ticks.
// result/detector_names.h lists the names of the detectors.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "sim/base/snapshot_registry.h"
#include "sim/detect/floor_reads.h"
#include "sim/detect/steering_detector.h"
#include "sim/exec/core/executor.h"
#include "sim/robot/robot.h"

namespace robosim::detect {

class Detectors {
 public:
  /// Attaches to `executor`, which has not been switched on yet. `robot` and `executor` must outlive this
  /// object. This object must outlive all use of `executor`. `line_m` is the width of the line.
  Detectors(const robot::Robot& robot, exec::Executor& executor, double line_m);
  Detectors(const Detectors&) = delete;
  Detectors& operator=(const Detectors&) = delete;

  /// Notifies the detectors if the firmware has started again. `times` is the number of starts so far.
  void booted(std::uint64_t times);
  /// Passes a tick to the detectors of steering. Ignores `now.asks_floor`, which this function computes.
  void look(Steering now);
  /// Returns the findings of the run, which has lasted until `now`.
  std::vector<exec::Detected> found(SimTime now) const;

  SnapshotRegistry::Snapshot save() const { return snapshots_.save(); }
  void restore(const SnapshotRegistry::Snapshot& saved) { snapshots_.restore(saved); }

 private:
  struct State {
    std::uint64_t boots = 1;
    SimTime before = 0;  ///< time of the previous tick
  };
  template <class Detector, class... Arguments>
  Detector& add(Arguments&&... arguments) {
    auto made = std::make_unique<Detector>(executor_, snapshots_, std::forward<Arguments>(arguments)...);
    Detector& added = *made;
    all_.push_back(std::move(made));
    return added;
  }

  exec::Executor& executor_;
  const FloorReads floor_;
  SnapshotRegistry snapshots_;
  std::vector<std::unique_ptr<FirmwareDetector>> all_;
  std::vector<SteeringDetector*> steering_;  ///< the detectors of all_ that examine each tick
  State state_;
};

}  // namespace robosim::detect
