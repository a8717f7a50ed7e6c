// Supports reverse execution of a run that can be saved and restored. The run's driver stores snapshots. To
// go back, a halted debug port leaves the run by an exception. The driver then restores and repeats the run
// twice: first to find the place where it must halt, then to halt there.
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

/// Thrown to leave a run that will be restored. The run does not continue from the present place.
struct LeftRun {};

/// A place between two instructions.
struct Place {
  SimTime t = 0;  ///< time of the world
  Stop stop;      ///< reason for halting there
  bool at_breakpoint = false;
  std::uint32_t pc = 0;
};

/// The purpose for which a run is repeated.
struct Search {
  enum class Goal { none, look, seek };
  Goal goal = Goal::none;
  /// In ticks that begin at this time or later, instructions run one by one, so that places are known.
  SimTime closely_from = 0;

  // --- look: finds the last place before `present` that has a breakpoint, or whose instruction changes
  // watched bytes. A reverse step finds the place of the previous instruction.
  SimTime present = 0;
  bool steps = false;
  std::size_t depth = 0;  ///< number of open handlers; a step ignores instructions in further handlers
  std::optional<Place> found;
  std::optional<Place> before;  ///< the result at an earlier time than `found`

  // --- seek
  Place target;
};

class History {
 public:
  /// Returns whether there are snapshots to go back to.
  virtual bool reaches_back() const = 0;
  /// Returns whether the run is at its latest time, so that no reports about later times exist.
  virtual bool is_at_front() const = 0;
  /// Drops the snapshots, because the debugger has changed the state. A run from a snapshot would no longer
  /// reach the present state.
  virtual void forget() = 0;

  Search search;

 protected:
  ~History() = default;
};

}  // namespace robosim::exec::gdb
