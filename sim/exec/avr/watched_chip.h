// Runs a chip (sim/mcu/avr) with a sketch in its flash, and detects faults. Faults are, for example, accesses
// to invalid addresses, stack overflow, and repeated watchdog resets.
//
// The chip starts at the address to which the boot loader would jump. After a watchdog reset, the chip is in
// the state that the Uno's boot loader (optiboot) leaves: MCUSR is cleared, and the watchdog is off. Without
// a boot loader, WDRF stays set. The watchdog then resets the chip again in 16 ms, unless the sketch turns
// the watchdog off.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "sim/exec/avr/chip_observer.h"
#include "sim/exec/avr/clock_map.h"
#include "sim/exec/avr/firmware.h"
#include "sim/exec/avr/race_analysis.h"
#include "sim/exec/core/watchdog_resets.h"
#include "sim/exec/elf/line_counts.h"
#include "sim/exec/elf/loop_timer.h"
#include "sim/mcu/avr/chip.h"

namespace robosim::exec::avr {

/// The reason why the firmware cannot continue. Flash addresses are in bytes.
struct Fault {
  enum class Kind { bad_read, bad_write, bad_opcode, bad_jump, restart, stack, watchdog, flash_write, torn };
  Kind kind = Kind::bad_jump;
  std::uint32_t pc = 0;       ///< address of the instruction; for a jump, the target
  std::uint32_t address = 0;  ///< accessed address; for bad_opcode, the opcode
};

class WatchedChip final : robosim::avr::MarkVisitor {
 public:
  WatchedChip(const Firmware& firmware, const BoardSpec& board, robosim::avr::ChipEnvironment& outside);

  robosim::avr::Chip& chip() { return chip_; }
  const robosim::avr::Chip& chip() const { return chip_; }
  const ChipSpec& spec() const { return spec_; }
  std::uint32_t clock_hz() const { return clock_hz_; }
  Cycle cycle() const { return chip_.cycle(); }
  std::uint32_t pc() const { return 2 * cpu().pc(); }
  /// Returns the address of the current or last instruction.
  std::uint32_t last_pc() const { return 2 * cpu().last_pc(); }
  std::uint16_t sp() const { return cpu().sp(); }
  std::uint8_t status() const { return cpu().sreg(); }
  /// Returns a byte of data memory, without effect on the firmware.
  std::uint8_t data(reg::Address address) const { return cpu().data[address]; }
  bool in_handler() const { return cpu().open_handlers() > 0; }
  int open_handlers() const { return cpu().open_handlers(); }
  /// Returns the return address that a call or interrupt has pushed at `at`, as a flash address.
  std::uint32_t return_address(reg::Address at) const;

  /// Runs until `cycle` or a few cycles later. Returns earlier after a fault, before an instruction with a
  /// trap, when the firmware sleeps for ever, or after Cpu::stop().
  void run_to(Cycle cycle);
  const std::optional<Fault>& fault() const { return state_.fault; }
  /// Returns whether the firmware sleeps with interrupts off, so that nothing will ever wake the chip.
  bool is_off() const { return state_.off; }
  bool is_asleep() const { return chip_.is_asleep() && !state_.off; }

  // --- traps: run_to() returns before an instruction with a trap
  /// The purposes of a trap.
  enum Trap : unsigned {
    kLoopTrap = 1,
    kMainTrap = 2,
    kBreakpoint = 4,
    kWriteTrap = 8,
    kRestartTrap = 16,
    kFirstLoopTrap = 32,
    kLineTrap = 64,
    kTearingTrap = 128,
    kObserverTrap = 256
  };
  void set_trap(Trap trap, std::uint32_t pc);
  /// Counts in `lines` how often each line runs, by a kLineTrap at each address where a line begins.
  void count(LineCounts& lines);
  /// Counts in `rounds` the rounds that begin at a kLoopTrap, from the second round on. While `rounds` is
  /// running, run_to() returns at such an instruction only if the instruction also has another trap.
  void count(LoopTimer<Cycle>& rounds) { rounds_ = &rounds; }
  /// Reports torn reads and writes as faults.
  void look_for_tearing(const DebugInfo& debug);
  const std::optional<RaceAnalysis>& race_analysis() const { return race_analysis_; }
  /// Calls `observer` before the instruction at `pc` runs. The observer must outlive the chip's use.
  void show(ChipObserver& observer, std::uint32_t pc);
  /// Calls `observer` when a handler starts or returns.
  void show_handlers(ChipObserver& observer);
  void clear_trap(Trap trap, std::uint32_t pc);
  /// Returns the traps for which run_to() has returned, as a sum of Trap, and clears them.
  unsigned take_traps() { return std::exchange(state_.trapped, 0); }

  // --- for debuggers
  /// Makes run_to() return after each instruction, and whenever it has skipped time during sleep.
  void step_singly(bool singly);
  void set_status(std::uint8_t value) { chip_.cpu().set_sreg(value); }
  void set_pc(std::uint32_t pc);

  // --- the stack
  std::uint16_t lowest_sp() const { return state_.lowest_sp; }
  /// Sets the end of the variables and the heap, below which the stack must not grow.
  void set_stack_limit(std::uint16_t limit);
  /// Returns whether the sketch has set up the current stack itself, for example for a task. If so,
  /// own_stack_variable() returns the variable that contains the stack, or null if the stack is in the heap.
  bool has_own_stack() const { return state_.own_stack; }
  const Symbol* own_stack_variable() const { return state_.own_variable; }
  /// Returns false while the firmware has written only one half of the stack pointer.
  bool is_stack_pointer_whole() const { return state_.pointer_written == 0; }
  /// Returns the addresses of the most recent calls, returns and interrupted instructions, the latest first.
  std::vector<std::uint32_t> last_jumps() const;

  // --- statistics, in cycles
  Cycle last_io() const;  ///< cycle of the last access to an I/O register outside handlers
  std::uint32_t last_io_pc() const { return 2 * cpu().state.last_io_pc; }
  Cycle handler_cycles() const { return cpu().handler_cycles(); }
  Cycle sleep_cycles() const { return chip_.sleep_cycles(); }
  /// Returns the address at which the current or last handler interrupted the firmware.
  std::uint32_t interrupted_pc() const { return 2 * cpu().state.interrupted_pc; }
  /// Return the interrupt number of the current or last handler, as in avr-libc (`TIMER0_OVF_vect_num`), and
  /// the address of its vector.
  int vector() const { return cpu().state.vector; }
  std::uint32_t vector_address() const { return 2 * cpu().entry_of(cpu().state.vector); }

  // --- snapshots
  struct TrapPlace {
    std::uint32_t pc = 0;
    unsigned traps = 0;  ///< sum of Trap
  };
  /// All state that changes while the chip runs, except the state inside Chip.
  struct State {
    std::vector<TrapPlace> traps;  ///< sorted by pc
    unsigned trapped = 0;
    std::optional<Fault> fault;
    bool off = false;
    std::uint16_t lowest_sp = 0;
    std::uint16_t stack_limit = 0;
    bool own_stack = false;                ///< the sketch uses a stack that it has set up, such as a task's
    const Symbol* own_variable = nullptr;  ///< the variable that contains this stack; null = in the heap
    std::uint16_t own_limit = 0;
    std::uint16_t pointer_before = 0;                 ///< stack pointer before its first half was written
    std::map<std::uint16_t, int> handlers_of_stacks;  ///< number of open handlers of a suspended task, by SP
    Cycle pointer_written = 0;  ///< cycle at which SP's first half was written; 0 = SP is complete
    WatchdogResets watchdog_resets;
    Cycle last_bite = 0;
  };
  struct Saved {
    State own;
    SnapshotRegistry::Snapshot chip;
  };
  Saved save() const { return {state_, chip_.save()}; }
  /// Restores a saved state. Breakpoints and the traps of observers do not change, because they belong to the
  /// debugger and the observers.
  void restore(const Saved& saved);

  /// Returns the cycle of the last watchdog reset; 0 = never.
  Cycle last_bite() const { return state_.last_bite; }
  int watchdog_resets() const { return state_.watchdog_resets.count(); }
  /// Handles a reset by the watchdog. The chip's environment calls this function.
  void was_reset();
  std::vector<std::uint8_t> ram() const;
  /// Turns the power-on into a brown-out reset. Must be called before the chip runs. MCUSR then reports a
  /// brown-out, and RAM contains `ram`, since no reset changes RAM (DS40002061B, Resetting the AVR). Assumes
  /// that the boot loader preserves MCUSR and RAM, as optiboot does from version 7 on.
  void was_browned_out(const std::vector<std::uint8_t>& ram);

 private:
  bool visited(std::uint32_t pc, Cycle at) override;
  bool others_visited(std::uint32_t pc, Cycle at, unsigned traps);
  void handler_entered();
  void handler_left();
  void tell_of_handlers();
  bool fail_if_torn();
  void left_out(std::uint32_t pc, Cycle first, Cycle period, std::uint64_t count) override;

  const robosim::avr::Cpu& cpu() const { return chip_.cpu(); }
  void fail(Fault::Kind kind, std::uint32_t pc, std::uint32_t address);
  void start();
  void look_at_code(std::uint32_t pc);
  void stack_is_low();
  void stack_pointer_written();
  void stack_moved();
  const Symbol* variable_of_stack(std::uint16_t at, bool is_in_use) const;
  std::uint16_t lowest_of_own_stack() const;
  void task_changed(std::uint16_t from, std::uint16_t to);
  unsigned traps_at(std::uint32_t pc) const;
  /// Returns the first element of state_.traps at or after `pc`.
  std::vector<TrapPlace>::iterator trap_from(std::uint32_t pc);

  const Firmware& firmware_;
  const ChipSpec& spec_;
  const std::uint32_t clock_hz_;
  const bool has_boot_loader_;  ///< a boot loader occupies a part of the flash
  LoopTimer<Cycle>* rounds_ = nullptr;
  LineCounts* lines_ = nullptr;
  std::optional<RaceAnalysis> race_analysis_;
  std::multimap<std::uint32_t, ChipObserver*> shown_;  ///< observers, by address of the instruction
  std::vector<ChipObserver*> told_of_handlers_;
  bool singly_ = false;
  State state_;
  robosim::avr::Chip chip_;
};

}  // namespace robosim::exec::avr
