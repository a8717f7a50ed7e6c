// The executor for targets that run the flashed ELF file in an emulated chip, in lockstep with the world.
//
//   ELF ──► ChipFirmware ── power_on() ──► RunningChip ──► ClockedBoard ──► board
//
// A tick runs up to the first instruction that ends at or after the tick's end. An edge or byte from the
// robot is scheduled for a certain time. It reaches the chip after the instruction that runs at this time.
#pragma once

#include <memory>
#include <optional>

#include "hal/board/board_spec.h"
#include "sim/exec/chip/chip.h"
#include "sim/exec/core/hang_probe_backoff.h"

namespace robosim::exec {

class ChipExecutor : public Executor, public ChipAccess {
 public:
  ChipExecutor(const BoardSpec& spec, std::unique_ptr<ChipFirmware> firmware);

  RobotPort& board() override { return board_; }
  BoardProbe& probe() override { return board_; }
  void power_on(SimTime t) override;
  void power_recovered(SimTime t) override;
  void power_off(SimTime t) override;
  void run_until(SimTime t) override;
  const std::optional<Crash>& crash() const override { return state_.crash; }
  Activity activity() override;
  SimTime last_call() const override;
  bool hangs() override;
  int int_bits() const override { return firmware_->int_bits(); }
  ChipAccess* chip_access() override { return this; }
  std::optional<Resources> resources() const override;
  int watchdog_resets() const override { return state_.resets + (chip_ ? chip_->watchdog_resets() : 0); }
  void set_clock_start(SimTime start) override;
  bool has_boards_eeprom() const override { return firmware_->has_boards_eeprom(); }
  void set_clock_drift(int ppm, SimTime t) override { clocked_.drift(ppm, t); }
  void debug_with(gdb::Server& server) override { firmware_->debug_with(server, clocked_); }
  void count_lines() override { firmware_->count_lines(); }
  std::vector<ArchivedFile> counters() override { return {{"lines", firmware_->line_counts()}}; }
  void detect(const std::vector<Pin>& counted) override { firmware_->detect(counted); }
  std::vector<Detected> detected() const override;
  std::any save() const override;
  void restore(const std::any& saved) override;
  SourceLine sketch_source() override { return chip_ ? chip_->sketch_line() : SourceLine{}; }
  SourceLine source() override { return chip_ ? chip_->where_now() : SourceLine{}; }
  bool trace_drives() override { return firmware_->trace_drives(); }
  CauseFinder* find_causes() override { return firmware_->find_causes(clocked_); }
  const SourceLine& driving(Pin pin, const PinDrive& drive) override {
    static const SourceLine unknown;
    return chip_ ? chip_->driving(pin, drive) : unknown;
  }
  void trace_bytes(SimTime from, SimTime to) override { tx_provenance_.emplace(from, to); }
  SourceLine source_of(std::uint8_t byte) override {
    return tx_provenance_ ? tx_provenance_->take(byte) : SourceLine{};
  }

 private:
  struct State {
    std::optional<Crash> crash;
    std::optional<Resources> before;  ///< resources used before the last power-on
    std::vector<Detected> detected;   ///< findings from before the last power-on
    int resets = 0;                   ///< number of watchdog resets before the last power-on
    std::vector<std::uint8_t> ram;    ///< while the power is off: content of the RAM at power-off
    SimTime clock_start = 0;
    SimTime reached = 0;  ///< time up to which the firmware has run
    HangProbeBackoff silence;
    bool hangs = false;  ///< result of the last call of RunningChip::hangs()
  };
  struct Saved {
    State own;
    BoardState::State board;
    ClockedBoard::State clocked;
    std::any chip;      ///< empty while the power is off
    std::any firmware;  ///< state that the firmware retains without power
    std::optional<TxProvenance::State> written;
  };

  void make_chip(SimTime t);

  BoardState board_;
  ClockedBoard clocked_{board_};
  std::unique_ptr<ChipFirmware> firmware_;
  std::unique_ptr<RunningChip> chip_;  ///< null while the power is off
  std::optional<TxProvenance> tx_provenance_;
  State state_;
};

}  // namespace robosim::exec
