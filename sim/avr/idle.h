// Skips loops that wait: delay(), repeated calls of millis() and micros(), flags that are polled. Firmware,
// pins and time are afterwards as if every pass had run; only the simulating processor saves work.
//
//   explores   from time to time, for some hundred instructions, looks where jumps lead back to; these are
//              heads
//   records    one pass from a head (path.h)
//   skips      at a head, if what the pass reads is unchanged: as many passes as end before the next event
//              and inside the window of the counter that it reads. One of them is run again, for everything
//              that the pass computes
//
// Heads are marked (Cpu), so other loops cost nothing. A head that does not pay off loses its mark.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/avr/core.h"
#include "sim/avr/path.h"
#include "sim/base/loop_credit.h"

namespace robosim::avr {

class Idle {
 public:
  explicit Idle(Core& core) : core_(core), path_(core) { heads_.reserve(kMostHeads); }

  /// Off: every instruction runs.
  void allow(bool allowed);
  bool is_allowed() const { return allowed_; }
  /// Cycles that no instruction has run for.
  Cycle skipped() const { return skipped_; }

  /// Before instructions run: whether they shall run one by one, with before() and after() around each.
  bool watches() {
    return recorded_ || exploring_ > 0 || (executed() >= explore_at_ && allowed_ && begins_to_explore());
  }
  void before();
  void after();
  /// The processor is at a head; what happens before `horizon` is known to it alone.
  void at_head(Cycle horizon);
  /// A mark was visited, behind which the chip ran on.
  void visited(std::uint32_t pc) {
    if (recorded_) path_.visited(pc);
  }
  /// The chip has slept for so long. A loop with sleep in it is none that waits.
  void slept(Cycle cycles) {
    slept_ += cycles;
    if (exploring_ > 0) landings_.clear();
  }
  /// Something came in between: an interrupt, a reset, an input.
  void interrupted() { recorded_ = nullptr; }
  /// It is another cycle now, maybe an earlier one.
  void moved_in_time();

 private:
  static constexpr std::size_t kMostHeads = 64;

  struct Head {
    std::uint32_t pc = 0;
    bool marked = false;
    bool is_known = false;  ///< `pass` was recorded
    LoopCredit credit;
    Path::Pass pass;
  };
  struct Landing {
    std::uint32_t pc = 0;
    int count = 0;
  };

  bool begins_to_explore();
  Head* find(std::uint32_t pc);
  void explored();
  void mark(Head& head, bool marked);
  bool is_as_recorded(const Path::Pass& pass) const;
  Cycle passes_before(Cycle horizon, const Path::Pass& pass) const;
  void skip(const Path::Pass& pass, Cycle passes);
  void pay(Head& head, std::int64_t cycles);
  /// Cycles in which instructions ran: what exploring costs is a share of them. It may go back in time.
  std::int64_t executed() const { return static_cast<std::int64_t>(core_.now() - skipped_ - slept_); }

  Core& core_;
  Path path_;
  bool allowed_ = true;
  std::vector<Head> heads_;   ///< that do not move
  Head* recorded_ = nullptr;  ///< whose pass is being recorded
  int steps_ = 0;             ///< of that pass
  int exploring_ = 0;         ///< instructions that are left
  std::vector<Landing> landings_;
  // By executed().
  std::int64_t explore_at_ = 0, explore_every_ = 0;
  std::uint32_t pc_before_ = 0;
  Cycle cycle_before_ = 0;
  Cycle skipped_ = 0, slept_ = 0;
};

}  // namespace robosim::avr
