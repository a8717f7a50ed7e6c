// Implements the debug port of the emulated STM32F103, for gdb-multiarch. gdb::DebugPort describes halting,
// stepping and watchpoints.
//
//   registers   0-12 r0 to r12, 13 sp, 14 lr, 15 pc, 16 xpsr, 4 bytes each
//   addresses   as on the chip. Peripherals cannot be read, since some reads have side effects
//
// Breakpoints hardly slow down the simulation. An IT instruction and its block count as one step.
#pragma once

#include "sim/exec/gdb/debug_port.h"
#include "sim/exec/stm32/machine.h"

namespace robosim::exec::stm32 {

class DebugPort final : public gdb::DebugPort {
 public:
  DebugPort(gdb::Server& server, const Firmware& firmware, const ClockedBoard& board)
      : gdb::DebugPort(server), firmware_(firmware), board_(board) {}

  /// Connects the debug port to `machine` at power-on.
  void plug_into(Machine& machine);
  void unplug() { machine_ = nullptr; }

 private:
  std::string registers() const override;
  std::string read_register(unsigned number) const override;
  bool write_register(unsigned number, std::string_view bytes) override;
  std::string read_memory(std::uint32_t address, std::uint32_t size) const override;
  std::string description() const override;

  gdb::Signal fault() const override;
  bool is_asleep() const override { return cpu().is_asleep(); }
  std::size_t open_handlers() const override { return cpu().open_handlers(); }
  std::uint32_t pc() const override;
  std::uint64_t cycle() const override { return machine_->bus().link().clock.now; }
  SimTime time() const override { return board_.to_world(machine_->time_of(cycle())); }
  bool has_code(std::uint32_t address) const override { return firmware_.has_code(address); }
  bool has_ram(std::uint32_t address, std::size_t size) const override;
  void poke(std::uint32_t address, std::uint8_t value) override { cpu().set_byte(address, value); }
  void trap(std::uint32_t address, bool set) override { cpu().set_breakpoint(address, set); }
  void resume() override { cpu().pass_breakpoint(); }
  void resume_again() override {}

  Cpu& cpu() const { return machine_->cpu(); }

  const Firmware& firmware_;
  const ClockedBoard& board_;
  Machine* machine_ = nullptr;
};

}  // namespace robosim::exec::stm32
