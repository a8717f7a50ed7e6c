// Skips passes of waiting loops (busy waiting): delay(), repeated calls of millis() and micros(), polled
// flags. Afterwards, firmware, pins and time are as if every pass had run. Skipping only saves computing time
// on the host.
//
//   explores   occasionally watches some hundred instructions: targets of repeated backward jumps become
//              loop heads
//   records    runs one pass, from a head back to this head, and stores its inputs (loop_trace.h)
//   skips      at a head with unchanged inputs, counts the passes that end before the next event and within
//              the counter's window (counter_extrapolation.h). Skips all of them except the last, which runs
//              to compute its results
//
// The processor stops only at the marks of heads, so that loops without a head cost nothing. If a head costs
// more than it saves, it loses its mark (backoff_budget.h).
#pragma once

#include <cstdint>
#include <vector>

#include "sim/base/backoff_budget.h"
#include "sim/mcu/avr/core.h"
#include "sim/mcu/avr/loop_trace.h"

namespace robosim::avr {

class Idle {
 public:
  explicit Idle(Core& core) : core_(core), path_(core) { heads_.reserve(kMostHeads); }

  /// Allows or forbids skipping. If forbidden, every instruction runs.
  void allow(bool allowed);
  bool is_allowed() const { return allowed_; }
  /// Returns the number of skipped cycles, in which no instruction ran.
  Cycle skipped() const { return skipped_; }

  /// Returns whether the next instruction must run alone, between calls of before() and after(). Call
  /// watches() before running instructions.
  bool watches() {
    return recorded_ || exploring_ > 0 || (executed() >= explore_at_ && allowed_ && begins_to_explore());
  }
  void before();
  void after();
  /// Handles the processor's arrival at a head. No event affects the chip before `horizon`.
  void at_head(Cycle horizon);
  /// Notes that the processor has passed the mark at `pc` without stopping.
  void visited(std::uint32_t pc) {
    if (recorded_) path_.visited(pc);
  }
  /// Notes that the chip has slept for `cycles`. A loop that sleeps does not count as a waiting loop.
  void slept(Cycle cycles) {
    slept_ += cycles;
    if (exploring_ > 0) landings_.clear();
  }
  /// Discards the pass that is being recorded, because of an interrupt, a reset or an input.
  void interrupted() { recorded_ = nullptr; }
  /// Notes that the chip was set to another cycle, possibly an earlier one.
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
  /// Returns the number of cycles in which instructions ran. The intervals between explorations are measured
  /// in these cycles. moved_in_time() can decrease the number.
  std::int64_t executed() const { return static_cast<std::int64_t>(core_.now() - skipped_ - slept_); }

  Core& core_;
  LoopTrace path_;
  bool allowed_ = true;
  std::vector<Head> heads_;   ///< reserved, so that pointers to heads stay valid
  Head* recorded_ = nullptr;  ///< head whose pass is being recorded
  int steps_ = 0;             ///< instructions of that pass so far
  int exploring_ = 0;         ///< remaining instructions to explore
  std::vector<Landing> landings_;
  // The value of executed() at which the next exploration starts, and the interval between explorations.
  std::int64_t explore_at_ = 0, explore_every_ = 0;
  std::uint32_t pc_before_ = 0;
  Cycle cycle_before_ = 0;
  Cycle skipped_ = 0, slept_ = 0;
};

}  // namespace robosim::avr
