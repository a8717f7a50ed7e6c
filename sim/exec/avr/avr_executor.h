// The target avr: the same ELF that is flashed, in an emulated ATmega328P (libsimavr, see avr/simavr.h about
// its licence), in lockstep with the world.
//
//   ELF ──► Chip (libsimavr) ──► Ports, Adc, Uart ──► FirmwarePort
//
// Time: one cycle is 62.5 ns. A tick runs to the first instruction that ends at or after its end, up to 3
// cycles over; edges and bytes that the robot has scheduled reach the chip at their cycle, or at the end of
// the instruction that is running then.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "hal/board/board_spec.h"
#include "sim/exec/core/clocked_board.h"
#include "sim/exec/core/executor.h"
#include "sim/exec/core/written_bytes.h"

namespace robosim::exec {

namespace avr {
class DebugPort;
class Machine;
}  // namespace avr

class AvrExecutor final : public Executor {
 public:
  /// Throws InputError if `image` is no ELF that this board's chip can run.
  AvrExecutor(const BoardSpec& spec, const std::filesystem::path& image);
  ~AvrExecutor() override;

  RobotPort& board() override { return board_; }
  BoardProbe& probe() override { return board_; }
  void power_on(SimTime t) override;
  void power_off(SimTime t) override;
  void run_until(SimTime t) override;
  const std::optional<Crash>& crash() const override { return crash_; }
  Activity activity() override;
  SimTime last_call() const override;
  int int_bits() const override { return 16; }
  std::optional<Resources> resources() const override;
  void set_clock_start(SimTime start) override;
  bool has_chip_faults() const override { return true; }
  void set_clock_drift(int ppm, SimTime t) override { clocked_.drift(ppm, t); }
  void debug_with(gdb::Server& server) override;
  SourceLine source() override;
  void trace_bytes(SimTime from, SimTime to) override { written_.emplace(from, to); }
  SourceLine source_of(std::uint8_t byte) override;

 private:
  struct Image;

  BoardState board_;
  ClockedBoard clocked_{board_};
  std::unique_ptr<const Image> image_;
  std::unique_ptr<avr::DebugPort> debug_port_;  ///< null = nobody debugs
  std::unique_ptr<avr::Machine> machine_;
  std::optional<WrittenBytes> written_;
  std::optional<Crash> crash_;
  std::optional<Resources> before_;  ///< what was measured before the last power-on
  SimTime clock_start_ = 0;
  SimTime reached_ = 0;  ///< until when firmware has run
};

}  // namespace robosim::exec
