// A chip's debug port, whatever the chip: it halts, steps, and keeps breakpoints and watchpoints for as long
// as a debugger is attached. A chip derives its own, which says what its registers and memories are.
//
//   machine ── begin_tick(), ran() ──► DebugPort ── stand_still() ──► Server ◄──► gdb
//   chip    ◄── what it holds ──────── (derived) ◄── Processor ───────
//
// With a watchpoint, every instruction runs alone, and what is watched is looked at behind each. One step is
// one instruction of the sketch: a handler that interrupts it runs to its end, unless it has a breakpoint. In
// all of these the firmware does at every cycle what it does without a debugger.
//
// What a debugger has set (breakpoints, watchpoints, how to go on) is not part of a run: it stays when a run
// that goes back (history.h) is restored.
#pragma once

#include <set>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/exec/gdb/history.h"
#include "sim/exec/gdb/server.h"

namespace robosim::exec::gdb {

class DebugPort : protected Processor {
 public:
  /// Before the instructions of a tick. Does not return while the chip is halted.
  void begin_tick();
  /// After some instructions. Does not return while the chip is halted.
  void ran(bool at_breakpoint);
  /// Whether instructions run one by one.
  bool steps_singly() const;
  /// The chip is what it was at another time.
  void restored();

 protected:
  explicit DebugPort(Server& server) : server_(server) {}
  ~DebugPort() = default;

  /// At power-on: the chip gets the breakpoints that are set, and halts before its first instruction if the
  /// debugger has not been met yet.
  void power_on();

  // --- what the chip says of itself
  /// The signal of what ended the firmware; none while it can run.
  virtual Signal fault() const = 0;
  virtual bool is_asleep() const = 0;
  /// Handlers that have begun and not returned.
  virtual std::size_t open_handlers() const = 0;
  virtual std::uint32_t pc() const = 0;
  virtual std::uint64_t cycle() const = 0;
  virtual SimTime time() const = 0;
  /// Addresses are gdb's.
  virtual bool has_code(std::uint32_t address) const = 0;
  virtual bool has_ram(std::uint32_t address, std::size_t size) const = 0;
  virtual void poke(std::uint32_t address, std::uint8_t value) = 0;
  virtual void trap(std::uint32_t address, bool set) = 0;
  /// It is about to run on after a halt.
  virtual void resume() = 0;
  /// It is about to run on into a tick that is run again.
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

  /// RAM only: flash stays what it is, as the tested image is the one that is flashed; EEPROM is the
  /// firmware's to write.
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
  bool restored_ = false;  ///< and has not run since
  Place here_;             ///< while it looks: where it was before the last instruction
  std::uint64_t step_began_ = 0;
  std::size_t step_depth_ = 0;
};

}  // namespace robosim::exec::gdb
