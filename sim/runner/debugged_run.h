// A run that a debugger can halt and run in reverse. The run is saved at intervals, and parts of the run are
// repeated from these snapshots (sim/exec/gdb/history.h). The results and reports are the same as without a
// debugger.
#pragma once

#include <atomic>
#include <optional>

#include "sim/exec/gdb/history.h"
#include "sim/run/simulation.h"
#include "sim/runner/dedup_listener.h"
#include "sim/runner/snapshot_index.h"

namespace robosim::runner {

class DebuggedRun final : exec::gdb::History {
 public:
  /// Debugs a run of one robot. If the robot's executor cannot be saved, the run cannot go back. Both
  /// arguments outlive this object.
  DebuggedRun(const run::Setup& setup, exec::gdb::Server& server);

  judge::Outcome go();

 private:
  bool reaches_back() const override { return !moments_.empty(); }
  bool is_at_front() const override { return told_.is_at_front(); }
  void forget() override { moments_.clear(); }

  void run_on();
  bool halts_at_end(const judge::Outcome& outcome);
  void go_back();
  std::optional<std::size_t> find();
  bool look(std::size_t moment, SimTime closely_from);
  void seek(std::size_t moment, const exec::gdb::Place& place);
  void restore(std::size_t moment);
  /// Returns whether the debugger has disconnected, or the run must end.
  bool is_left_alone() const { return !server_.attached() || (interrupted_ && *interrupted_); }

  exec::gdb::Server& server_;
  DedupListener told_;
  const std::atomic<bool>* const interrupted_;
  run::Setup setup_;
  run::Simulation simulation_;
  SnapshotIndex moments_;
  bool end_shown_ = false;
};

}  // namespace robosim::runner
