// The emulated ATmega328P as avr-gdb sees it (Server is gdb's side):
//
//   registers   0-31 r0 to r31, 32 SREG (1 byte), 33 SP (2), 34 PC (4; a byte address)
//   addresses   flash from 0, data memory from 0x800000, EEPROM from 0x810000
//
// Breakpoints cost nothing: they are traps in the emulator's flash. With a watchpoint, every instruction runs
// alone, and what is watched is looked at behind each. One step is one instruction of the sketch: a handler
// that interrupts it runs to its end, unless it has a breakpoint. In all of these the firmware does at every
// cycle what it does without a debugger.
#pragma once

#include <set>
#include <vector>

#include "sim/executors/avr/machine.h"
#include "sim/executors/gdb/server.h"

namespace robosim::executors::avr {

class DebugPort final : gdb::Processor {
 public:
  DebugPort(gdb::Server& server, const Firmware& firmware, BoardState& board);

  /// At power-on: the chip halts before its first instruction if the debugger has not been met yet, and gets
  /// the breakpoints that are set.
  void plug_into(Machine& machine);
  void unplug() { machine_ = nullptr; }

  /// Before the instructions of a tick. Does not return while the chip is halted.
  void begin_tick();
  /// After some instructions. Does not return while the chip is halted.
  void ran(bool at_breakpoint);

 private:
  struct Watch {
    std::uint32_t address;  ///< in data memory
    std::uint32_t size;
    gdb::Access access;
    std::string value;
  };

  std::string registers() const override;
  std::string read_register(unsigned number) const override;
  bool write_register(unsigned number, std::string_view bytes) override;
  std::string read_memory(std::uint32_t address, std::uint32_t size) const override;
  bool write_memory(std::uint32_t address, std::string_view bytes) override;
  bool set_breakpoint(std::uint32_t address, bool set) override;
  bool set_watchpoint(std::uint32_t address, std::uint32_t size, gdb::Access access, bool set) override;
  std::string monitor(const std::string& command) override;

  void halt(const gdb::Stop& stop);
  void let_go();
  const Watch* changed_watch();
  std::uint32_t pc() const;
  std::uint32_t flash_end() const;  ///< a --sanitize image may exceed the real chip's
  std::uint32_t data_end() const;
  Chip& chip() const { return machine_->chip(); }

  gdb::Server& server_;
  const Firmware& firmware_;
  BoardState& board_;
  Machine* machine_ = nullptr;
  std::set<std::uint32_t> breakpoints_;
  std::vector<Watch> watches_;
  bool begun_ = false;
  bool crashed_ = false;
  bool stepping_ = false;
  Cycle step_began_ = 0;
  int step_depth_ = 0;
};

}  // namespace robosim::executors::avr
