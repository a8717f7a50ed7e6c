// Reverse execution of a run that can be saved and restored. The driver of the run stores snapshots of it. A
// halted debug port that must go back leaves the run. The driver restores the run and runs it twice: to find
// the place where it should halt, and to halt there.
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

/// Thrown to leave a run that will be restored: nothing in it continues from here.
struct LeftRun {};

/// A place between two instructions.
struct Place {
  SimTime t = 0;  ///< of the world
  Stop stop;      ///< why it halts there
  bool at_breakpoint = false;
  std::uint32_t pc = 0;
};

/// The purpose for which a run is run again.
struct Search {
  enum class Goal { none, look, seek };
  Goal goal = Goal::none;
  /// Instructions run one by one in ticks that begin at this time or later: places are known there.
  SimTime closely_from = 0;

  // --- look: for the last place before `present` that has a breakpoint, or whose instruction changes watched
  // bytes. If it steps, for the place of the previous instruction.
  SimTime present = 0;
  bool steps = false;
  std::size_t depth = 0;  ///< depth of handlers; instructions in deeper ones are not the sketch's
  std::optional<Place> found;
  std::optional<Place> before;  ///< the place found before that

  // --- seek
  Place target;
};

class History {
 public:
  /// Returns whether there are snapshots to go back to.
  virtual bool reaches_back() const = 0;
  /// Returns whether the run is at its latest time, so that nothing already reported lies ahead of it.
  virtual bool is_at_front() const = 0;
  /// Drops the snapshots: the debugger has changed something, and a run from earlier would not come here any
  /// more.
  virtual void forget() = 0;

  Search search;

 protected:
  ~History() = default;
};

}  // namespace robosim::exec::gdb
