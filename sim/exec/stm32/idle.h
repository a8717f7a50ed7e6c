// Skips loops that wait: repeated calls of millis(), flags and buttons that are polled. Firmware, pins and
// time are afterwards as if every pass had run; only the simulating processor saves work.
//
//   explores   from time to time, looks which of the last jumps lead back; their targets are loop heads
//   records    one pass from a head: what it stores, and how long the values that it reads from peripherals
//              stay valid
//   skips      if registers and RAM are as at the beginning of the pass: as many passes as end before the
//              next event, and before a value that they read may change. One of them is run again, for
//              everything that a pass leaves behind
//
// This is exact, since a pass that begins with equal registers, RAM and peripherals does the same again.
// Heads are marked (Cpu), so other loops cost nothing. A head that does not pay off loses its mark.
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

  /// With false, every instruction runs.
  void allow(bool allowed);
  /// Returns the number of cycles for which no instruction has run.
  Cycle skipped() const { return skipped_; }

  /// Looks for loops. Called from time to time, while no instruction runs.
  void explore();
  /// Called when the processor is at a head, before the instruction there.
  void at_head(std::uint32_t pc);

  // --- while a pass is recorded
  bool is_recording() const { return recorded_ != nullptr; }
  /// Notes that RAM there is about to change.
  void stores(std::uint32_t address, std::uint32_t bytes);
  /// Notes a read from a peripheral whose value is valid until that cycle, exclusive; the present cycle =
  /// unknown.
  void looks(Cycle until);
  /// Notes that a round of loop() begins.
  void round_began();
  /// Notes an effect that cannot be skipped.
  void interrupted();
  /// Notes that something has come in between.
  void runs_anew();

  /// Notes that the processor is at another time.
  void moved_in_time();

 private:
  static constexpr std::size_t kMostHeads = 16;

  struct Head {
    std::uint32_t pc = 0;
    bool marked = false;
    BackoffBudget credit;
    Cycle cycles = 0;  ///< of the last recorded pass
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
  /// Returns whether the pass has led to where it began.
  bool ends();
  void skip(Cycle passes, Cycle cycles);

  Cpu& cpu_;
  bool allowed_ = true;
  std::vector<Head> heads_;  ///< their addresses are stable
  Cycle explore_at_ = 0, explore_every_ = 0;
  int tries_ = 0;  ///< passes recorded without success since instructions began to run
  Cycle skipped_ = 0;

  Head* recorded_ = nullptr;  ///< the one whose pass is recorded
  State state_;
  std::vector<Word> stored_;         ///< with the earlier values
  std::vector<std::uint32_t> seen_;  ///< by word of RAM: the last pass that stored there
  std::uint32_t number_ = 0;
  Cycle began_ = 0, until_ = 0, round_at_ = 0;
  int rounds_ = 0, others_ = 0, looks_ = 0;
  std::uint32_t jumps_before_ = 0;
};

}  // namespace robosim::exec::stm32
