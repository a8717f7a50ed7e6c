// The Cortex-M3: instructions by libunicorn; time, exceptions, sleep and faults by us.
//
// Before every instruction the emulator calls back: that is where cycles are counted (cycles.h) and where it
// is stopped, so that an interrupt comes at its instruction and a tick ends at its cycle, at most one
// instruction (and what follows an IT) late. libunicorn knows no interrupts: entry and return are done here
// (PM0056 2.3.7).
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "sim/exec/elf/rounds.h"
#include "sim/exec/stm32/bus.h"
#include "sim/exec/stm32/cycles.h"
#include "sim/exec/stm32/firmware.h"

struct uc_struct;

namespace robosim::exec::stm32 {

/// Why the firmware can run no further.
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
    unhandled,
    unmodelled
  };
  Kind kind = Kind::bad_jump;
  std::uint32_t pc = 0;       ///< of the instruction; of a jump, where it led
  std::uint32_t address = 0;  ///< of a read or write; the opcode; the exception that has no handler
};

/// How long passes of loop() take.
struct LoopTimes {
  std::uint64_t count = 0;
  SimTime longest = 0;
  SimTime total = 0;
};

class Cpu {
 public:
  enum Register { kSp = 13, kLr = 14, kPc = 15 };

  Cpu(const Firmware& firmware, Bus& bus, const Rounds& loop);
  ~Cpu();
  Cpu(const Cpu&) = delete;
  Cpu& operator=(const Cpu&) = delete;

  /// Takes the exception that is due, if one is.
  void take_exception();
  /// Runs until `cycle`, or to where something may have changed that matters outside.
  void run_to(Cycle cycle);
  bool is_asleep() const { return asleep_; }
  /// Until `cycle`, or the interrupt that is there already.
  void sleep_to(Cycle cycle);

  const std::optional<Fault>& fault() const { return fault_; }
  void fail(Fault::Kind kind, std::uint32_t pc, std::uint32_t address = 0);

  std::uint32_t reg(int number) const;
  std::uint32_t status() const;
  std::uint32_t pc() const { return pc_; }
  /// A word of RAM; 0 outside of it.
  std::uint32_t word(Address address) const;
  void set_word(Address address, std::uint32_t value);

  bool in_handler() const { return !handlers_.empty(); }
  std::size_t open_handlers() const { return handlers_.size(); }
  /// Where the firmware was when the outermost handler that runs interrupted it.
  std::uint32_t interrupted_pc() const { return interrupted_pc_; }
  std::uint32_t lowest_sp() const { return lowest_sp_; }
  void set_stack_limit(Address limit) { stack_limit_ = limit; }
  Address stack_limit() const { return stack_limit_; }
  /// Addresses of the instructions that jumped last, the last first.
  std::vector<std::uint32_t> last_jumps() const;

  // --- for debuggers
  /// run_to() returns before the instruction at `pc` runs; within an IT block, behind the block.
  void set_breakpoint(std::uint32_t pc, bool set);
  /// The next instruction runs though there is a breakpoint.
  void pass_breakpoint() { passing_ = next_; }
  /// Whether run_to() has returned for a breakpoint; asked once.
  bool take_breakpoint() { return std::exchange(at_breakpoint_, false); }
  /// Of the instruction that comes next.
  std::uint32_t next_pc() const { return next_; }
  /// False for a pc where there is no code.
  bool write_register(int number, std::uint32_t value);
  std::uint8_t byte(Address address) const;
  void set_byte(Address address, std::uint8_t value);

  // --- accounts
  Cycle last_io() const {
    return last_io_;
  }  ///< last access to a register, or call of millis(), outside handlers
  std::uint32_t last_io_pc() const { return last_io_pc_; }
  Cycle handler_cycles() const;
  Cycle sleep_cycles() const { return sleep_cycles_; }
  const LoopTimes& loop_times() const { return loop_times_; }
  /// Of the pass that has begun; 0 before the first.
  SimTime present_loop() const;

  /// Whom to call whenever the instruction at `pc` is about to run.
  void watch(std::uint32_t pc, std::function<void()> watcher);
  /// Once, when the instruction at `pc` is about to run, the word at `variable` becomes `value`.
  void set_at(std::uint32_t pc, Address variable, std::uint32_t value);

 private:
  static constexpr std::uint32_t kMappedFlash = robosim::stm32::kEepromFlash - robosim::stm32::kFlash;

  struct Hooks;
  struct Cached {
    Instruction instruction{};
    bool known = false, plain = false, starts = false, loop = false, call = false, sets = false,
         watched = false, breaks = false;
  };
  struct Handler {
    Exception exception;
    std::uint32_t interrupted;
  };
  struct EarlySet {
    std::uint32_t pc = 0;
    Address variable = 0;
    std::uint32_t value = 0;
  };

  void before(std::uint32_t pc);
  bool halts_at(std::uint32_t pc, const Cached& cached);
  void before_special(const Cached& cached);
  void after_special();
  void loop_began();
  void check_stack();
  void note_jump();
  void jumped_nowhere(std::uint32_t pc);
  void accessed();
  void enter(Exception exception);
  void leave();
  std::uint32_t opcode(std::uint32_t pc) const;
  Cached& cached(std::uint32_t pc);
  void mark(std::uint32_t pc, bool Cached::*flag);
  std::uint8_t* ram(Address address, unsigned bytes) const;
  void set_reg(int number, std::uint32_t value);

  const Firmware& firmware_;
  Bus& bus_;
  Clock& clock_;
  Nvic& nvic_;
  uc_struct* uc_ = nullptr;
  std::unique_ptr<std::uint8_t[], void (*)(void*)> flash_, ram_;
  std::vector<Cached> cache_;
  Cached elsewhere_;  ///< of code outside of flash

  std::uint32_t pc_ = 0;    ///< of the instruction that runs
  std::uint32_t next_ = 0;  ///< and behind it
  Cycle stop_ = 0;
  bool stopped_ = false, returning_ = false, asleep_ = false, sleeps_ = false;
  bool look_after_ = false;
  Instruction last_{};
  int predicated_ = 0;  ///< instructions left of an IT block
  std::vector<Handler> handlers_;
  std::uint32_t interrupted_pc_ = 0;
  std::optional<Fault> fault_;
  std::array<std::uint32_t, 32> jumps_{};
  std::uint32_t jump_count_ = 0;
  std::uint32_t lowest_sp_ = 0, stack_limit_ = 0;
  std::optional<EarlySet> early_;
  std::function<void()> watcher_;
  std::uint32_t passing_ = 1;  ///< where a breakpoint is passed; no instruction's address if none is
  bool halting_ = false, at_breakpoint_ = false;
  Cycle last_io_ = 0;
  std::uint32_t last_io_pc_ = 0;
  Cycle handler_began_ = 0, handler_cycles_ = 0, sleep_cycles_ = 0;
  LoopTimes loop_times_;
  SimTime loop_began_ = 0;
  bool looped_ = false;
};

}  // namespace robosim::exec::stm32
