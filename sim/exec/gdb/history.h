// Going back in a run that can be saved and restored. Who drives the run keeps snapshots of it. A halted
// debug port that shall go back leaves the run; the driver restores it and runs it again, to look for the
// place where it is to halt, and once more to halt there.
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

/// Out of a run that is to be restored: nothing in it goes on from here.
struct LeftRun {};

/// Between two instructions.
struct Place {
  SimTime t = 0;  ///< of the world
  Stop stop;      ///< why it halts there
  bool at_breakpoint = false;
  std::uint32_t pc = 0;
};

/// What a run is run again for.
struct Search {
  enum class Goal { none, look, seek };
  Goal goal = Goal::none;
  /// Instructions run one by one in ticks that begin then or later: places are known there.
  SimTime closely_from = 0;

  // --- look: for the last place before `present` that has a breakpoint, or whose instruction changes what is
  // watched; or, if it steps, for that of the instruction before.
  SimTime present = 0;
  bool steps = false;
  std::size_t depth = 0;  ///< of handlers; what is deeper is no instruction of the sketch's
  std::optional<Place> found;
  std::optional<Place> before;  ///< what was found before that

  // --- seek
  Place target;
};

class History {
 public:
  /// Whether there are snapshots to go back to.
  virtual bool reaches_back() const = 0;
  /// Whether the run has come as far as ever: nothing that it has told lies ahead of it.
  virtual bool is_at_front() const = 0;
  /// The debugger has changed something: run again from before, it would not come here any more.
  virtual void forget() = 0;

  Search search;

 protected:
  ~History() = default;
};

}  // namespace robosim::exec::gdb
