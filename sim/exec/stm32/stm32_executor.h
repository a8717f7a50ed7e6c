// The target stm32: the same ELF that is flashed, in an emulated STM32F103 (libunicorn, see stm32/unicorn.h
// about its licence), in lockstep with the world.
//
//   ELF ──► Cpu (libunicorn) ──► Bus: Clocks, Ports, Adc, Timers, Usart, Flash ──► FirmwarePort
//
// Time: processor cycles, by a table (stm32/cycles.h). A tick runs to the first instruction that ends at or
// behind its end; edges and bytes that the robot has scheduled reach the chip at the first instruction behind
// their time.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/exec/core/clocked_board.h"
#include "sim/exec/core/executor.h"
#include "sim/exec/core/written_bytes.h"

namespace robosim::exec {

namespace stm32 {
class DebugPort;
class Machine;
}  // namespace stm32

class Stm32Executor final : public Executor {
 public:
  /// Throws InputError if `image` is no ELF that this board's chip can run.
  Stm32Executor(const BoardSpec& spec, const std::filesystem::path& image);
  ~Stm32Executor() override;

  RobotPort& board() override { return board_; }
  BoardProbe& probe() override { return board_; }
  void power_on(SimTime t) override;
  void power_off(SimTime t) override;
  void run_until(SimTime t) override;
  const std::optional<Crash>& crash() const override { return crash_; }
  Activity activity() override;
  SimTime last_call() const override;
  std::optional<Resources> resources() const override;
  void set_clock_start(SimTime start) override;
  void debug_with(gdb::Server& server) override;
  SourceLine source() override;
  void trace_bytes(SimTime from, SimTime to) override { written_.emplace(from, to); }
  SourceLine source_of(std::uint8_t byte) override;

 private:
  struct Image;

  BoardState board_;
  ClockedBoard clocked_{board_};
  std::unique_ptr<const Image> image_;
  std::vector<std::uint8_t> eeprom_pages_;
  std::unique_ptr<stm32::DebugPort> debug_port_;  ///< null = nobody debugs
  std::unique_ptr<stm32::Machine> machine_;
  std::optional<WrittenBytes> written_;
  std::optional<Crash> crash_;
  std::optional<Resources> before_;  ///< what was measured before the last power-on
  SimTime clock_start_ = 0;
  SimTime reached_ = 0;  ///< until when firmware has run
};

}  // namespace robosim::exec
