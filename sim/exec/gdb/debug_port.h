// Implements the part of the debug port that all emulated chips have in common. While a debugger is attached,
// the debug port halts and steps the chip, and stores breakpoints and watchpoints. For each chip, a derived
// class describes the registers and memories.
//
//   machine ── begin_tick(), ran() ──► DebugPort ── stand_still() ──► Server ◄──► gdb
//   chip    ◄── its state ──────────── (derived) ◄── Processor ───────
//
// If there is a watchpoint, instructions run one by one, and the watched bytes are compared after each
// instruction. One step is one instruction of the sketch. A handler that interrupts the step runs to its end,
// or to a breakpoint. In all these cases, the firmware behaves at every cycle as without a debugger.
//
// The debugger's settings (breakpoints, watchpoints, how to continue) do not belong to the state of a run.
// When reverse execution restores an earlier state (history.h), these settings do not change.
#pragma once

#include <set>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/exec/gdb/history.h"
#include "sim/exec/gdb/server.h"

namespace robosim::exec::gdb {

class DebugPort : protected Processor {
 public:
  /// Must be called before the instructions of a tick. Does not return while the chip is halted.
  void begin_tick();
  /// Must be called after instructions have run. Does not return while the chip is halted.
  void ran(bool at_breakpoint);
  /// Returns whether instructions run one by one.
  bool steps_singly() const;
  /// Must be called after the chip's state has been restored to another time.
  void restored();

 protected:
  explicit DebugPort(Server& server) : server_(server) {}
  ~DebugPort() = default;

  /// Sets all breakpoints in the chip at power-on. At the first power-on, begin_tick() then halts the chip
  /// before its first instruction.
  void power_on();

  // --- implemented for each chip
  /// Returns the signal that describes why the firmware ended; Signal::none while the firmware can run.
  virtual Signal fault() const = 0;
  virtual bool is_asleep() const = 0;
  /// Returns the number of handlers that have begun but not returned.
  virtual std::size_t open_handlers() const = 0;
  virtual std::uint32_t pc() const = 0;
  virtual std::uint64_t cycle() const = 0;
  virtual SimTime time() const = 0;
  /// Returns whether there is code at an address, in gdb's numbering.
  virtual bool has_code(std::uint32_t address) const = 0;
  virtual bool has_ram(std::uint32_t address, std::size_t size) const = 0;
  virtual void poke(std::uint32_t address, std::uint8_t value) = 0;
  virtual void trap(std::uint32_t address, bool set) = 0;
  /// Prepares the chip to continue after a halt.
  virtual void resume() = 0;
  /// Prepares the chip to continue with a tick that is being repeated.
  virtual void resume_again() = 0;

  static std::string little_endian(std::uint32_t value, int size);
  static std::uint32_t from_little_endian(std::string_view bytes);

 private:
  struct Watch {
    std::uint32_t address;
    std::uint32_t size;
    Access access;
    std::string value;
  };

  /// Writes to RAM only. The debugger must not change flash, so that the tested image is the flashed image.
  /// Only the firmware writes EEPROM.
  bool write_memory(std::uint32_t address, std::string_view bytes) final;
  bool set_breakpoint(std::uint32_t address, bool set) final;
  bool set_watchpoint(std::uint32_t address, std::uint32_t size, Access access, bool set) final;
  std::string monitor(const std::string& command) final;

  void halt(Stop stop);
  void let_go();
  void read_watches();
  const Watch* changed_watch();

  Search* search() const;
  [[noreturn]] void go_back(bool steps);
  void begin_tick_again(Search& search);
  void look(Search& search, bool at_breakpoint);
  void seek(Search& search, bool at_breakpoint);

  Server& server_;
  std::set<std::uint32_t> breakpoints_;
  std::vector<Watch> watches_;
  bool begun_ = false;
  bool crashed_ = false;
  bool stepping_ = false;
  bool restored_ = false;  ///< the chip was restored and has not run since then
  Place here_;             ///< during a search, the place before the last instruction
  std::uint64_t step_began_ = 0;
  std::size_t step_depth_ = 0;
};

}  // namespace robosim::exec::gdb
