// Defines the outcome of a run: the verdict, its explanation, and the measurements.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/base/error.h"
#include "sim/base/vec.h"
#include "sim/exec/core/executor.h"
#include "sim/judge/goal.h"
#include "sim/result/events.h"
#include "sim/result/run_result.h"

namespace robosim::judge {

enum class Verdict {
  reached,      ///< the goal was reached
  lost,         ///< the wheels have turned 1 m without a line under or between the sensors
  stuck,        ///< motors were driven for 3 s, and the robot neither moved 1 mm nor turned 1 degree
  toppled,      ///< the robot tipped over, or fell off an edge
  hung,         ///< no API call for 2 s, and none can follow; motors are driven
  ended,        ///< no API call for 2 s, and none can follow; motors are off, so the robot is parked
  crashed,      ///< the firmware cannot continue
  over_budget,  ///< a budget of the robot file is exceeded (chip targets)
  timeout,      ///< the time limit of the run is up
  interrupted,  ///< interrupted by the user
};

const char* to_string(Verdict verdict);
ExitStatus exit_status(Verdict verdict);

using result::Metrics;

/// Suggests what to examine next.
struct NextStep {
  /// How to examine it: run on the host, watch the run, or write a script.
  enum class By { none, host, watching, script };
  std::string text;  ///< empty if the verdict is clear enough
  By by = By::none;
};

/// Decisive::text for a moment at which the motors stopped for good.
inline constexpr const char* kMotorsStayOff = "its motors stopped here and stayed off";

/// The moment at which the run went wrong, for `robosim why`.
struct Decisive {
  SimTime t = 0;
  std::string text;            ///< "the robot left the line near column 20, row 4"; empty = none
  bool motors = false;         ///< requests an explanation of the motor commands
  bool place = false;          ///< requests the firmware's position in its source code
  SimTime off_since = kNever;  ///< time since which the motors are off; kNever = driven at the end
};

struct Outcome {
  Verdict verdict = Verdict::timeout;
  std::string why;  ///< one sentence that a first-year student understands
  NextStep next;
  Decisive decisive;
  std::vector<result::Cause> because;  ///< chain of causes that leads back from the verdict, if requested
  Goal goal;
  SimTime time = 0;  ///< simulated time at the end
  Metrics metrics;
  std::optional<exec::Crash> crash;
  std::vector<exec::DivisionByZero> divisions_by_zero;
  std::vector<exec::Lack> lacks;
  int watchdog_resets = 0;
  std::vector<exec::Detected> detected;
  std::optional<exec::Resources> resources;  ///< used on a chip target
  result::Usage usage;
  std::vector<result::RunEvent> events;  ///< the last few events
  std::string serial;                    ///< the firmware's output, up to kSerialKept bytes
  std::string shown;                ///< texts that parts displayed or sent, one per line; up to about 64 KiB
  Pose end;                         ///< the robot's pose
  std::uint64_t eeprom_writes = 0;  ///< bytes that the firmware wrote to its EEPROM
  std::string trace_hash;
};

/// The maximum size of the stored serial output in bytes. The trace hash also covers later output.
constexpr std::size_t kSerialKept = 1 << 20;
constexpr std::size_t kShownKept = 1 << 16;

}  // namespace robosim::judge
