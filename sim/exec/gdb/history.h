// Supports reverse execution of a run that can be saved and restored. The driver of the run stores snapshots.
// To go back, a halted debug port throws LeftRun. The driver then restores a snapshot and repeats the run
// twice. The first repetition finds the place where the run must halt. The second repetition halts at this
// place.
//
//   gdb: bs, bc ──► DebugPort ── throws LeftRun ──► driver ── Search: look, restored, runs ──► DebugPort
//                                                         ◄── found ──────────────────────────
//                                                         ── Search: seek, restored, runs ───► DebugPort
//                                                         halts
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "hal/board/sim_time.h"
#include "sim/exec/gdb/server.h"

namespace robosim::exec::gdb {

/// An exception that leaves the run. The driver then restores an earlier state of the run.
struct LeftRun {};

/// A place between two instructions.
struct Place {
  SimTime t = 0;  ///< time of the world
  Stop stop;      ///< reason for a halt at this place
  bool at_breakpoint = false;
  std::uint32_t pc = 0;
};

/// The purpose for which a run is repeated.
struct Search {
  enum class Goal { none, look, seek };
  Goal goal = Goal::none;
  /// In ticks that begin at this time or later, instructions run one by one, so that every place is examined.
  SimTime closely_from = 0;

  // --- look: finds the last place before `present` that has a breakpoint, or whose instruction changes
  // watched bytes. For a reverse step, finds the place of the previous instruction.
  SimTime present = 0;
  bool steps = false;
  std::size_t depth = 0;  ///< number of running handlers; a step ignores instructions in further handlers
  std::optional<Place> found;
  std::optional<Place> before;  ///< the previous result, at an earlier time than `found`

  // --- seek
  Place target;
};

class History {
 public:
  /// Returns whether the driver has an earlier snapshot that can be restored.
  virtual bool reaches_back() const = 0;
  /// Returns whether the run is at its latest time. If not, the run has already reported events of later
  /// times.
  virtual bool is_at_front() const = 0;
  /// Drops the snapshots. Must be called after the debugger has changed the state, because a run from a
  /// snapshot would not reach the changed state.
  virtual void forget() = 0;

  Search search;

 protected:
  ~History() = default;
};

}  // namespace robosim::exec::gdb
