// The result of a run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/base/error.h"
#include "sim/base/vec.h"
#include "sim/exec/core/executor.h"
#include "sim/judge/goal.h"
#include "sim/wire/events.h"
#include "sim/wire/run_result.h"

namespace robosim::judge {

enum class Verdict {
  reached,      ///< the goal was reached
  lost,         ///< the wheels have turned 1 m with no sensor over a line
  stuck,        ///< motors driven for 3 s, neither moved 1 mm nor turned 1 degree
  toppled,      ///< it tipped over, or fell off an edge
  hung,         ///< no API call for 2 s, motors driven
  ended,        ///< no API call for 2 s, motors off: it parked itself
  crashed,      ///< the firmware cannot continue
  over_budget,  ///< a budget of the robot file is exceeded (chip targets)
  timeout,      ///< simulated time is up
  interrupted,  ///< by the user
};

const char* to_string(Verdict verdict);
ExitStatus exit_status(Verdict verdict);

using wire::Metrics;

/// A hint on what to examine next.
struct NextStep {
  /// The means for it: a run on the host, watching the run, a script.
  enum class By { none, host, watching, script };
  std::string text;  ///< empty if the verdict is clear enough
  By by = By::none;
};

/// The text of a moment at which the motors stopped for good.
inline constexpr const char* kMotorsStayOff = "its motors stopped here and stayed off";

/// The moment at which the run went wrong, for `robosim why`.
struct Decisive {
  SimTime t = 0;
  std::string text;            ///< "the robot left the line near column 20, row 4"; empty = there is none
  bool motors = false;         ///< asks why they were driven as they were
  bool place = false;          ///< asks why the firmware is at its place
  SimTime off_since = kNever;  ///< its motors have been off ever since; kNever = they were driven at the end
};

struct Outcome {
  Verdict verdict = Verdict::timeout;
  std::string why;  ///< one sentence a first-year student understands
  NextStep next;
  Decisive decisive;
  std::vector<wire::Cause> because;  ///< back from the verdict, if requested
  Goal goal;
  SimTime time = 0;  ///< simulated, at the end
  Metrics metrics;
  std::optional<exec::Crash> crash;
  std::vector<exec::DivisionByZero> divisions_by_zero;
  std::vector<exec::Lack> lacks;
  std::vector<exec::Detected> detected;
  std::optional<exec::Resources> resources;  ///< of a chip
  wire::Usage usage;
  std::vector<wire::RunEvent> events;  ///< the last few
  std::string serial;                  ///< the firmware's output, up to kSerialKept bytes
  std::string shown;                   ///< reports of parts, one per line, up to kShownKept bytes and a line
  Pose end;                            ///< the robot's pose
  std::uint64_t eeprom_writes = 0;     ///< bytes that the firmware wrote to its EEPROM
  std::string trace_hash;
};

/// The serial output that is stored; the trace hash includes more.
constexpr std::size_t kSerialKept = 1 << 20;
constexpr std::size_t kShownKept = 1 << 16;

}  // namespace robosim::judge
