// Skips waiting loops, which repeatedly call millis() or poll flags and buttons. Afterwards, firmware, pins
// and time are as if every pass of the loop had run. Skipping affects only the duration of the simulation. It
// has three steps:
//
//   explore   Checks from time to time which of the last jumps lead backwards. The target of such a jump is a
//             loop head.
//   record    Records the stores of one pass that begins at a head. Also records how long the values that the
//             pass reads from peripherals stay valid.
//   skip      If registers and RAM are as at the beginning of the recorded pass, skips further passes. These
//             passes end before the next event, and before a value read by the pass may change. The last of
//             these passes is executed, to reproduce all effects of a pass.
//
// Skipping is exact: passes that begin with equal registers, RAM and peripherals have equal effects. Only
// loop heads are marked (Cpu::Mark), so that other code runs at full speed. A head loses its mark if skipping
// takes more time than it saves.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/base/backoff_budget.h"
#include "sim/exec/stm32/clock.h"

namespace robosim::exec::stm32 {

class Cpu;

class Idle {
 public:
  explicit Idle(Cpu& cpu);

  /// Enables or disables skipping. While skipping is disabled, every instruction runs.
  void allow(bool allowed);
  /// Returns the number of skipped cycles.
  Cycle skipped() const { return skipped_; }

  /// Searches the last jumps for loops. Must be called while no instruction runs.
  void explore();
  /// Handles the arrival at a loop head, before the instruction there runs.
  void at_head(std::uint32_t pc);

  // --- while a pass is recorded
  bool is_recording() const { return recorded_ != nullptr; }
  /// Notes that `bytes` of RAM at `address` are about to change.
  void stores(std::uint32_t address, std::uint32_t bytes);
  /// Notes a read from a peripheral. A repeated read would return the same value before the cycle `until`. If
  /// `until` is the present cycle, it is unknown how long the value stays valid.
  void looks(Cycle until);
  /// Notes that a round of loop() begins.
  void round_began();
  /// Ends the recording, because the pass has an effect that cannot be skipped.
  void interrupted();
  /// Must be called before instructions run after a pause, in which the state of the chip may have changed.
  void runs_anew();

  /// Must be called after a snapshot was restored, which may have changed the time.
  void moved_in_time();

 private:
  static constexpr std::size_t kMostHeads = 16;

  struct Head {
    std::uint32_t pc = 0;
    bool marked = false;
    BackoffBudget credit;
    Cycle cycles = 0;  ///< duration of the last recorded pass
  };
  /// All state that a pass may change, except RAM and statistics.
  struct State {
    std::array<std::uint32_t, 15> registers{};
    std::array<std::uint32_t, 6> others{};
    bool operator==(const State&) const = default;
  };
  struct Word {
    std::uint32_t address = 0, value = 0;
  };

  Head* find(std::uint32_t pc);
  void mark(Head& head, bool marked);
  void pay(Head& head, std::int64_t cycles);
  State state() const;
  void begin(Head& head);
  /// Ends the recording. Returns whether the state is the same as at the beginning of the pass.
  bool ends();
  void skip(Cycle passes, Cycle cycles);

  Cpu& cpu_;
  bool allowed_ = true;
  std::vector<Head> heads_;  ///< element addresses are stable
  Cycle explore_at_ = 0, explore_every_ = 0;
  int tries_ = 0;  ///< number of passes that were recorded without success since runs_anew()
  Cycle skipped_ = 0;

  Head* recorded_ = nullptr;  ///< head whose pass is being recorded
  State state_;
  std::vector<Word> stored_;         ///< words to which the pass has stored, with their earlier values
  std::vector<std::uint32_t> seen_;  ///< for each word of RAM, the number of the last pass that stored there
  std::uint32_t number_ = 0;
  Cycle began_ = 0, until_ = 0, round_at_ = 0;
  int rounds_ = 0, others_ = 0, looks_ = 0;
  std::uint32_t jumps_before_ = 0;
};

}  // namespace robosim::exec::stm32
