// Implements the debug port of the emulated chip, for avr-gdb. gdb::DebugPort describes halts, steps and
// watchpoints.
//
//   registers   0-31 r0 to r31, 32 SREG (1 byte), 33 SP (2), 34 PC (4; a byte address)
//   addresses   flash from 0, data from kAvrData, EEPROM from kAvrEeprom (sim/base/elf/avr_addresses.h)
//
// Breakpoints do not slow the emulation, because they are traps in the decoded flash.
#pragma once

#include "sim/exec/avr/machine.h"
#include "sim/exec/gdb/debug_port.h"

namespace robosim::exec::avr {

class DebugPort final : public gdb::DebugPort {
 public:
  DebugPort(gdb::Server& server, const Firmware& firmware, ClockedBoard& board)
      : gdb::DebugPort(server), firmware_(firmware), board_(board) {}

  /// Connects the debug port at power-on.
  void plug_into(Machine& machine);
  void unplug() { machine_ = nullptr; }

 private:
  std::string registers() const override;
  std::string read_register(unsigned number) const override;
  bool write_register(unsigned number, std::string_view bytes) override;
  std::string read_memory(std::uint32_t address, std::uint32_t size) const override;

  gdb::Signal fault() const override;
  bool is_asleep() const override { return chip().is_asleep(); }
  std::size_t open_handlers() const override { return static_cast<std::size_t>(chip().open_handlers()); }
  std::uint32_t pc() const override;
  std::uint64_t cycle() const override { return chip().cycle(); }
  SimTime time() const override { return board_.to_world(machine_->now()); }
  bool has_code(std::uint32_t address) const override { return address < flash_end(); }
  bool has_ram(std::uint32_t address, std::size_t size) const override;
  void poke(std::uint32_t address, std::uint8_t value) override;
  void trap(std::uint32_t address, bool set) override;
  void resume() override { chip().step_singly(steps_singly()); }
  void resume_again() override { resume(); }

  std::uint32_t flash_end() const;  ///< an image built with --sanitize may exceed the real chip's flash
  std::uint32_t data_end() const;
  WatchedChip& chip() const { return machine_->chip(); }

  const Firmware& firmware_;
  ClockedBoard& board_;
  Machine* machine_ = nullptr;
};

}  // namespace robosim::exec::avr
