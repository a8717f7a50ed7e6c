// Declares the base class of detectors that observe firmware through its board, on any target.
#pragma once

#include "hal/board/robot_port.h"
#include "sim/base/snapshot_registry.h"
#include "sim/exec/core/detector.h"
#include "sim/exec/core/executor.h"
#include "sim/result/detector_names.h"

namespace robosim::detect {

class FirmwareDetector : public exec::Detector {
 public:
  /// Called when the firmware has started again after its chip had lost power.
  virtual void powered_on() {}
};

}  // namespace robosim::detect
