// Skips loops that wait: delay(), repeated calls of millis() and micros(), flags that are polled. Firmware,
// pins and time are afterwards as if every pass had run; only the simulating processor saves work.
//
//   explores   from time to time, for some hundred instructions, looks where jumps lead back to; these are
//              heads
//   records    one pass from a head (loop_trace.h)
//   skips      at a head, if what the pass reads is unchanged: as many passes as end before the next event
//              and inside the window of the counter that it reads. One of them is run again, for everything
//              that the pass computes
//
// Heads are marked (Cpu), so other loops cost nothing. A head that does not pay off loses its mark.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/avr/core.h"
#include "sim/avr/loop_trace.h"
#include "sim/base/backoff_budget.h"

namespace robosim::avr {

class Idle {
 public:
  explicit Idle(Core& core) : core_(core), path_(core) { heads_.reserve(kMostHeads); }

  /// With false, every instruction runs.
  void allow(bool allowed);
  bool is_allowed() const { return allowed_; }
  /// Returns the number of cycles for which no instruction has run.
  Cycle skipped() const { return skipped_; }

  /// Call it before instructions run: returns whether they must run one by one, with before() and after()
  /// around each.
  bool watches() {
    return recorded_ || exploring_ > 0 || (executed() >= explore_at_ && allowed_ && begins_to_explore());
  }
  void before();
  void after();
  /// Called when the processor is at a head; only the processor has effects before `horizon`.
  void at_head(Cycle horizon);
  /// Notes a mark at which the chip continued.
  void visited(std::uint32_t pc) {
    if (recorded_) path_.visited(pc);
  }
  /// Notes that the chip has slept for that long. A loop with sleep does not count as waiting.
  void slept(Cycle cycles) {
    slept_ += cycles;
    if (exploring_ > 0) landings_.clear();
  }
  /// Notes an event in between: an interrupt, a reset, an input.
  void interrupted() { recorded_ = nullptr; }
  /// Notes a jump to another cycle, possibly an earlier one.
  void moved_in_time();

 private:
  static constexpr std::size_t kMostHeads = 64;

  struct Head {
    std::uint32_t pc = 0;
    bool marked = false;
    bool is_known = false;  ///< `pass` was recorded
    BackoffBudget credit;
    LoopTrace::Pass pass;
  };
  struct Landing {
    std::uint32_t pc = 0;
    int count = 0;
  };

  bool begins_to_explore();
  Head* find(std::uint32_t pc);
  void explored();
  void mark(Head& head, bool marked);
  bool is_as_recorded(const LoopTrace::Pass& pass) const;
  Cycle passes_before(Cycle horizon, const LoopTrace::Pass& pass) const;
  void skip(const LoopTrace::Pass& pass, Cycle passes);
  void pay(Head& head, std::int64_t cycles);
  /// Returns the cycles in which instructions ran: exploration costs a share of them. It may decrease.
  std::int64_t executed() const { return static_cast<std::int64_t>(core_.now() - skipped_ - slept_); }

  Core& core_;
  LoopTrace path_;
  bool allowed_ = true;
  std::vector<Head> heads_;   ///< their addresses are stable
  Head* recorded_ = nullptr;  ///< the one whose pass is recorded
  int steps_ = 0;             ///< of that pass
  int exploring_ = 0;         ///< remaining instructions
  std::vector<Landing> landings_;
  // Counted as by executed().
  std::int64_t explore_at_ = 0, explore_every_ = 0;
  std::uint32_t pc_before_ = 0;
  Cycle cycle_before_ = 0;
  Cycle skipped_ = 0, slept_ = 0;
};

}  // namespace robosim::avr
