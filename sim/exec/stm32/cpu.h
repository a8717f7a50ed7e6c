// Models the Cortex-M3: instructions, time, exceptions, sleep and faults.
//
// Most instructions are decoded once (thumb.h, step.h) and executed by the interpreter's loop (cpu_run.cpp).
// The library libunicorn runs rare instructions, and instructions that fault, one at a time. Cycles are
// counted before each instruction (cycles.h). The loop stops only between instructions. Interrupts and tick
// ends are therefore at most one instruction (or IT block) late. Exceptions are entered and left as in PM0056
// 2.3.7.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "sim/exec/elf/line_counts.h"
#include "sim/exec/elf/loop_marker.h"
#include "sim/exec/elf/loop_timer.h"
#include "sim/exec/stm32/bus.h"
#include "sim/exec/stm32/cycles.h"
#include "sim/exec/stm32/firmware.h"
#include "sim/exec/stm32/flags.h"
#include "sim/exec/stm32/idle.h"
#include "sim/exec/stm32/step.h"

struct uc_struct;
struct uc_context;

namespace robosim::exec::stm32 {

class Engine;

/// The reason why the firmware cannot continue.
struct Fault {
  enum class Kind {
    bad_read,
    bad_write,
    flash_write,
    bad_opcode,
    bad_jump,
    breakpoint,
    division,
    stack,
    exception_return,
    watchdog,
    unhandled,
    unmodelled
  };
  Kind kind = Kind::bad_jump;
  std::uint32_t pc = 0;       ///< address of the instruction; for a bad jump, the target of the jump
  std::uint32_t address = 0;  ///< address read or written, opcode, or number of the unhandled exception
};

class Cpu {
 public:
  enum Register { kSp = 13, kLr = 14, kPc = 15 };

  /// `engine` belongs to the chip. No other Cpu may use it while this Cpu exists.
  Cpu(const Firmware& firmware, Bus& bus, Engine& engine, const LoopMarks& loop);
  ~Cpu();
  Cpu(const Cpu&) = delete;
  Cpu& operator=(const Cpu&) = delete;

  /// Resets everything as after power-on, except RAM and statistics.
  void reset();
  /// Enters the handler of the pending exception with the highest priority, if that exception may interrupt
  /// the running code.
  void take_exception();
  /// Runs until `cycle`. Returns earlier if the processor sleeps or fails, or if another part of the chip may
  /// have an event.
  void run_to(Cycle cycle);
  bool is_asleep() const { return state_.asleep; }
  /// Wakes up if an interrupt or event is pending; otherwise sleeps until `cycle`.
  void sleep_to(Cycle cycle);

  const std::optional<Fault>& fault() const { return state_.fault; }
  void fail(Fault::Kind kind, std::uint32_t pc, std::uint32_t address = 0);

  std::uint32_t reg(int number) const { return state_.r[static_cast<std::size_t>(number)]; }
  std::uint32_t status() const;
  std::uint32_t pc() const { return state_.pc; }
  /// Returns a word of RAM; 0 outside RAM.
  std::uint32_t word(Address address) const;
  void set_word(Address address, std::uint32_t value);

  bool in_handler() const { return !state_.handlers.empty(); }
  std::size_t open_handlers() const { return state_.handlers.size(); }
  /// Returns the address at which the outermost running handler interrupted the firmware.
  std::uint32_t interrupted_pc() const { return state_.interrupted_pc; }
  std::uint32_t lowest_sp() const { return state_.lowest_sp; }
  void set_stack_limit(Address limit) {
    state_.stack_limit = limit;
    watch_stack();
  }
  Address stack_limit() const { return state_.stack_limit; }
  /// Returns the addresses of the most recent jump instructions, the latest first. In a handler, returns only
  /// the jumps of this handler.
  std::vector<std::uint32_t> last_jumps() const;

  /// Makes libunicorn execute every instruction that it can, as a reference for tests.
  void use_referee();

  /// Returns the object that skips waiting loops.
  Idle& idle() { return idle_; }
  const Idle& idle() const { return idle_; }

  // --- for debuggers
  /// Makes run_to() return before the instruction at `pc`. The next call of run_to() runs the instruction. In
  /// an IT block, run_to() returns after the block.
  void set_breakpoint(std::uint32_t pc, bool set);
  /// Runs the next instruction even if it has a breakpoint.
  void pass_breakpoint() { passing_ = state_.next; }
  /// Returns whether run_to() has returned at a breakpoint since the last call.
  bool take_breakpoint() { return std::exchange(at_breakpoint_, false); }
  /// Returns the address of the next instruction.
  std::uint32_t next_pc() const { return state_.next; }
  /// Sets a register. Returns false if the new pc has no code.
  bool write_register(int number, std::uint32_t value);
  /// Returns a pointer to memory at `address`; null if no memory is there.
  const std::uint8_t* memory(Address address, unsigned bytes) const;
  void set_byte(Address address, std::uint8_t value);

  struct Saved;
  Saved save() const;
  void restore(const Saved& saved);
  /// Discards the decoded instructions of the changed flash page at `page`.
  void forget(Address page);

  // --- statistics
  Cycle last_io() const {
    return state_.last_io;
  }  ///< cycle of the last access to a peripheral, or of the last call of millis(), outside handlers
  std::uint32_t last_io_pc() const { return state_.last_io_pc; }
  Cycle handler_cycles() const;
  Cycle sleep_cycles() const { return state_.sleep_cycles; }
  /// Returns the cycle at which the outermost running handler began. If no handler runs, returns the cycle at
  /// which the last handler began.
  Cycle handler_began() const { return state_.handler_began; }
  /// Returns whether PRIMASK and FAULTMASK are both clear, so that interrupts are not masked.
  bool interruptible() const { return !(state_.primask | state_.faultmask); }
  const LoopTimer<SimTime>& rounds() const { return state_.rounds; }

  /// Counts in `lines` how often each source line begins to run.
  void count(LineCounts& lines);
  /// Calls `watcher` whenever the instruction at `pc` is about to run.
  void watch(std::uint32_t pc, std::function<void()> watcher);
  /// Sets the word at `variable` to `value` once, when the instruction at `pc` is about to run.
  void set_at(std::uint32_t pc, Address variable, std::uint32_t value);

 private:
  static constexpr std::uint32_t kExceptionReturn = 0xFFFFFFF0;  // EXC_RETURN (PM0056 2.3.7)
  static constexpr Address kPrivate = 0xE0000000;
  static constexpr std::uint32_t kPeripheralBytes = 0x24000, kBitBandBytes = 0x500000,
                                 kPrivateBytes = 0x100000;

  friend class Idle;
  friend class Engine;
  struct Hooks;
  /// The actions to take before the instruction at `pc` runs; see reached(), halts_at() and Idle::at_head().
  struct Mark {
    std::uint32_t pc = 0;
    bool starts = false, loop = false, call = false, sets = false, watched = false, counted = false,
         breaks = false, head = false;
    Step::Kind kind = Step::Kind::fetch, within = Step::Kind::fetch;  ///< kinds of the instruction's Step
    /// Returns whether reached() must be called before the instruction.
    bool is_told() const { return starts || loop || call || sets || watched || counted; }
    bool is_set() const { return is_told() || breaks || head; }
  };
  struct Handler {
    Exception exception;
    std::uint32_t interrupted;
    std::uint32_t jumps;  ///< number of jumps when the handler began
  };
  struct EarlySet {
    std::uint32_t pc = 0;
    Address variable = 0;
    std::uint32_t value = 0;
  };

  /// All state that changes during a run, except the monitor of LDREX and STREX, which libunicorn stores.
  struct State {
    std::array<std::uint32_t, 17> r{};  ///< r[15] is the pc that instructions read; r[16] is always 0
    Flags flags;
    bool saturated = false;
    std::uint32_t it = 0;  ///< ITSTATE (ARMv7-M ARM, A7.3.2)
    std::uint32_t primask = 0, faultmask = 0, basepri = 0;
    std::uint32_t other_sp = 0;  ///< the inactive stack pointer: MSP or PSP
    bool on_process_stack = false;
    std::uint32_t pc = 0;    ///< address of the running instruction
    std::uint32_t next = 0;  ///< address of the next instruction
    bool returning = false, asleep = false;
    bool waits_for_event = false;  ///< the processor sleeps because of WFE, not WFI
    int predicated = 0;            ///< number of instructions left in the IT block
    std::vector<Handler> handlers;
    std::uint32_t interrupted_pc = 0;
    std::optional<Fault> fault;
    std::array<std::uint32_t, 32> jumps{};
    std::uint32_t jump_count = 0;
    std::uint32_t lowest_sp = 0, stack_limit = 0;
    std::uint32_t stack_watch = 0;  ///< check_stack() must be called when SP falls below this
    std::optional<EarlySet> early;
    Cycle last_io = 0;
    std::uint32_t last_io_pc = 0;
    Cycle handler_began = 0, handler_cycles = 0, sleep_cycles = 0;
    LoopTimer<SimTime> rounds;
  };

  /// Runs the interpreter's loop until the cycle stop_.
  void run();
  /// Runs the instruction at state_.pc with libunicorn.
  void emulate();
  /// Returns whether libunicorn may continue with the instruction at `pc`.
  bool begins(std::uint32_t pc);
  /// Returns the Step at `pc`; null if the address cannot contain code.
  const Step* step_at(std::uint32_t pc);
  /// Decodes the instruction at `at.pc` and returns its Step; null if the address cannot contain code.
  const Step* fetched(const Step& at);
  bool make(std::uint32_t pc, Step& step) const;

  std::optional<std::uint32_t> load_elsewhere(Address address, unsigned bytes);
  bool store_elsewhere(Address address, unsigned bytes, std::uint32_t value);
  /// Sets `target` to the target of a load into the program counter. Returns false if libunicorn must
  /// determine the target.
  bool load_target(Address address, std::uint32_t& target) const;
  bool load_two(const Step& step);
  bool store_two(const Step& step);
  /// `registers` has one bit for each register to load.
  bool load_many(const Step& step, std::uint32_t registers);
  bool store_many(const Step& step);
  void multiply_long(const Step& step);
  /// Computes a data operation. `b` is the second operand. `carry` is the last bit that was shifted out of
  /// `b`.
  void compute(Op op, const Step& step, std::uint32_t b, std::uint32_t carry, bool sets, Flags& flags);
  void change_masks(std::uint32_t value);
  void masks_changed();
  bool read_special(std::uint32_t number, std::uint32_t& value) const;
  bool write_special(std::uint32_t number, std::uint32_t value);
  void set_status(std::uint32_t value);
  void select_stack(bool process);
  bool halts_at(std::uint32_t pc);
  void reached(const Mark& mark);
  void check_stack();
  void watch_stack();
  void note_jump() { state_.jumps[state_.jump_count++ % state_.jumps.size()] = state_.pc; }
  /// Deletes all recorded jumps after the first `count` jumps.
  void forget_jumps(std::uint32_t count);
  void jumped_nowhere(std::uint32_t pc);
  void accessed();
  void enter(Exception exception);
  void leave();
  std::uint32_t opcode(std::uint32_t pc) const;
  /// Returns the halfword at `address`; 0 if no memory is there.
  std::uint16_t half(Address address) const;
  Mark* mark_at(std::uint32_t pc);
  void mark(std::uint32_t pc, bool Mark::*flag, bool set = true);
  /// Returns the target of the branch at `pc` if it branches backwards; otherwise 0.
  std::uint32_t leads_back_to(std::uint32_t pc);
  /// Starts or stops calling idle_.stores() for each store to RAM.
  void records(bool recording);
  std::uint8_t* ram(Address address, unsigned bytes) const;
  /// Returns whether the bus handles accesses to `address`.
  static bool has_registers(Address address);
  void set_reg(int number, std::uint32_t value) { state_.r[static_cast<std::size_t>(number)] = value; }

  const Firmware& firmware_;
  Bus& bus_;
  Clock& clock_;
  Nvic& nvic_;
  Engine& engine_;
  uc_struct* const uc_;
  std::uint8_t* const flash_;
  std::uint8_t* const ram_;
  std::vector<Step> code_;  ///< one Step for each halfword of flash, and two empty Steps at the end
  /// The instructions outside flash that were decoded last. Two empty Steps follow each of these.
  std::array<std::array<Step, 3>, 4> elsewhere_;
  std::size_t elsewhere_count_ = 0;
  std::vector<Mark> marks_;                     ///< sorted by address
  std::array<std::uint16_t, 8> known_marks_{};  ///< cache: indices of marks that were looked up recently
  LineCounts* lines_ = nullptr;
  Idle idle_{*this};
  std::uint32_t writable_ = 0;  ///< bytes of RAM that the loop may write directly
  State state_;

  std::uint32_t after_ = 0;        ///< address at which execution continues after the running instruction
  bool first_ = false;             ///< libunicorn has not begun the instruction yet
  std::uint32_t block_bytes_ = 0;  ///< size of the IT block that libunicorn runs; 0 = none
  bool ends_ = false, falls_asleep_ = false;
  Cycle stop_ = 0;
  std::function<void()> watcher_;
  std::uint32_t passing_ = 1;  ///< address whose breakpoint is ignored once; 1 = no address
  bool halting_ = false, at_breakpoint_ = false;
  bool referee_ = false;
};

/// The state of a Cpu without the debugger's settings.
struct Cpu::Saved {
  State own;
  std::shared_ptr<const uc_context> monitor;
};

}  // namespace robosim::exec::stm32
