// The emulated STM32F103 as gdb-multiarch sees it (Server is gdb's side):
//
//   registers   0-12 r0 to r12, 13 sp, 14 lr, 15 pc, 16 xpsr, 4 bytes each
//   addresses   those of the chip; of its peripherals none, as reading some of them changes what they do
//
// Breakpoints cost next to nothing. With a watchpoint, every instruction runs alone, and what is watched is
// looked at behind each. One step is one instruction of the sketch, or an IT with all that depends on it: a
// handler that interrupts it runs to its end, unless it has a breakpoint. In all of these the firmware does
// at every cycle what it does without a debugger.
#pragma once

#include <set>
#include <vector>

#include "sim/executors/gdb/server.h"
#include "sim/executors/stm32/machine.h"

namespace robosim::executors::stm32 {

class DebugPort final : gdb::Processor {
 public:
  DebugPort(gdb::Server& server, const Firmware& firmware) : server_(server), firmware_(firmware) {}

  /// At power-on: the chip halts before its first instruction if the debugger has not been met yet, and gets
  /// the breakpoints that are set.
  void plug_into(Machine& machine);
  void unplug() { machine_ = nullptr; }

  /// Before the instructions of a tick. Does not return while the chip is halted.
  void begin_tick();
  /// After some instructions. Does not return while the chip is halted.
  void ran(bool at_breakpoint);
  /// Whether instructions run one by one.
  bool steps_singly() const { return stepping_ || !watches_.empty(); }

 private:
  struct Watch {
    std::uint32_t address;
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
  std::string description() const override;
  std::string monitor(const std::string& command) override;

  void halt(const gdb::Stop& stop);
  void let_go();
  const Watch* changed_watch();
  std::uint32_t pc() const;
  Cpu& cpu() const { return machine_->cpu(); }
  Cycle now() const { return machine_->bus().link().clock.now; }

  gdb::Server& server_;
  const Firmware& firmware_;
  Machine* machine_ = nullptr;
  std::set<std::uint32_t> breakpoints_;
  std::vector<Watch> watches_;
  bool begun_ = false;
  bool crashed_ = false;
  bool stepping_ = false;
  Cycle step_began_ = 0;
  std::size_t step_depth_ = 0;
};

}  // namespace robosim::executors::stm32
