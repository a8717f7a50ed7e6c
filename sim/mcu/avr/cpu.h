// Models the processor of an AVR: registers, status, program counter, memory, and a loop that runs decoded
// instructions. Sources: AVR Instruction Set Manual, DS40002198B; ATmega328P data sheet DS40002061B, chapter
// 7.
//
//   cycle     an instruction of n cycles that starts at cycle c accesses memory and registers at c + n: two
//             consecutive INs read one cycle apart, two consecutive LDSs two cycles apart
//   horizon   run() stops at this cycle: the next event of a peripheral, or the end that the caller requests
//
// The processor does not access peripherals directly. It calls the hooks that peripherals register for their
// I/O registers, and enters interrupt vectors.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "hal/board/avr_registers.h"
#include "hal/board/chip_spec.h"
#include "sim/mcu/avr/cycle.h"
#include "sim/mcu/avr/decode.h"
#include "sim/mcu/avr/read_forecast.h"
#include "sim/mcu/avr/time_count.h"

namespace robosim::avr {

using Address = std::uint16_t;  ///< address in data memory

class Cpu {
 public:
  /// Bits of SREG.
  static constexpr std::uint8_t kC = 1, kZ = 2, kN = 4, kV = 8, kS = 16, kH = 32, kT = 64, kI = 128;

  /// The reason why run(), or Chip::run_to(), returned.
  enum class Stop : std::uint8_t {
    reached,   ///< the given cycle was reached
    sleep,     ///< SLEEP ran; the program counter is after SLEEP
    mark,      ///< the instruction at the program counter has a mark; the next run() executes it
    break_,    ///< BREAK ran
    illegal,   ///< the program counter is at a reserved opcode
    outside,   ///< the program counter is after the flash's end, perhaps after a jump to outside_pc()
    bad_read,  ///< the last instruction read bad_address(), which has no memory
    bad_write,
    spm,      ///< SPM ran
    stopped,  ///< stop() was called; in Chip's single-step mode, an instruction has run
    off,      ///< from Chip only: the chip sleeps with interrupts off, and only a reset can wake it
  };

  /// `flash` consists of whole words, at most as many as the program counter can address. `last_ram` is the
  /// last address of data memory.
  Cpu(const ChipSpec& chip, std::span<const std::uint8_t> flash, Address last_ram);

  // --- running
  /// Runs until a reason to stop occurs, or until cycle `until`. The last instruction may end after `until`.
  Stop run(Cycle until);
  /// Makes run() return Stop::reached after the current instruction. Called by hooks.
  void look_up() { horizon_ = 0; }
  /// Makes run() return Stop::stopped after the current instruction. Called by hooks.
  void stop() { stop_with(Stop::stopped); }

  /// A callback without arguments, as for WDR.
  struct Call {
    void (*function)(void* self) = nullptr;
    void* self = nullptr;
    void operator()() const {
      if (function) function(self);
    }
  };
  template <auto Method, typename Owner>
  static Call call(Owner* owner) {
    return {[](void* self) { (static_cast<Owner*>(self)->*Method)(); }, owner};
  }
  Call on_wdr;

  // --- interrupts
  /// Enters the handler of an interrupt: pushes the return address and clears the flag I. Takes 4 cycles; 5
  /// with a 22-bit program counter.
  void enter(int vector);
  /// Runs the complete handler in one step if it is the Arduino core's handler of timer 0 (time_count.h).
  /// Otherwise does nothing. Call this after enter(). The caller guarantees that no event affects the handler
  /// before `until`.
  void count_time(Cycle until);
  /// Returns the word address of an interrupt vector.
  std::uint32_t entry_of(int vector) const;
  /// Returns whether an interrupt can be entered now: the flag I must be set. After an instruction that sets
  /// I, such as SEI or RETI, one more instruction runs first.
  bool interruptible() const { return state.sreg & kI && state.cycle != state.held_at; }
  bool interrupts_enabled() const { return state.sreg & kI; }
  /// Points to the pending interrupts, one bit per vector. An instruction that sets I makes run() return if
  /// an interrupt is pending, or if this pointer is null.
  const std::uint64_t* waiting = nullptr;
  /// Resets the processor: the program counter and I/O registers become 0, memory is retained.
  void reset();

  // --- registers and memory
  /// The callbacks that implement an I/O register. A register without callbacks stores the written value.
  /// Callbacks run at the cycle of the access, after all earlier events (on_time).
  struct Hook {
    std::uint8_t (*read)(void* self, Address address) = nullptr;
    void (*write)(void* self, Address address, std::uint8_t value) = nullptr;
    /// Implements SBI and CBI. `value` is the byte in `data` with the bit already changed; `bit` is the bit's
    /// mask. Without this hook, SBI and CBI read and write the register.
    void (*write_bit)(void* self, Address address, std::uint8_t value, std::uint8_t bit) = nullptr;
    /// Predicts reads. Without this hook, a register with `read` has a forecast only if it is steady.
    ReadForecast (*forecast)(void* self, Address address, std::uint8_t bits) = nullptr;
    bool is_steady = false;
    void* read_self = nullptr;
    void* forecast_self = nullptr;
    void* write_self = nullptr;
    void* write_bit_self = nullptr;
  };
  /// Registers ReadForecast Owner::Method(Address, uint8_t bits), which predicts reads of a register. Only
  /// the bits in `bits` must be correct. The method is called after all earlier events.
  template <auto Method, typename Owner>
  void on_forecast(Address address, Owner* owner) {
    Hook& hook = hooks_[address];
    hook.forecast = [](void* self, Address at, std::uint8_t bits) {
      return (static_cast<Owner*>(self)->*Method)(at, bits);
    };
    hook.forecast_self = owner;
  }
  /// Declares that reads of the register have no side effects. They return the same value until the next
  /// event or write.
  void is_steady(Address address) { hooks_[address].is_steady = true; }
  ReadForecast forecast(Address address, std::uint8_t bits) const;
  /// Returns the relevant bits of the I/O register that the instruction at `pc` reads. The other bits are
  /// discarded by this instruction or the next one. Returns kAllBits if the relevant bits are unknown.
  std::uint8_t bits_read(std::uint32_t pc) const;
  /// Returns the bits that firmware tests first after a read. It may still use further bits later, but never
  /// the bits that bits_read() excludes.
  std::uint8_t bits_tested(std::uint32_t pc) const;
  static constexpr std::uint8_t kAllBits = 0xFF;

  /// Registers uint8_t Owner::Method(Address) as the read hook.
  template <auto Method, typename Owner>
  void on_read(Address address, Owner* owner) {
    Hook& hook = hooks_[address];
    hook.read = [](void* self, Address at) { return (static_cast<Owner*>(self)->*Method)(at); };
    hook.read_self = owner;
    plain_[address] &= static_cast<std::uint8_t>(~kPlainRead);
  }
  /// Registers void Owner::Method(Address, uint8_t value) as the write hook.
  template <auto Method, typename Owner>
  void on_write(Address address, Owner* owner) {
    Hook& hook = hooks_[address];
    hook.write = [](void* self, Address at, std::uint8_t value) {
      (static_cast<Owner*>(self)->*Method)(at, value);
    };
    hook.write_self = owner;
    plain_[address] &= static_cast<std::uint8_t>(~kPlainWrite);
  }
  /// Adds a second write hook to a register. The second hook is called after the first. The first hook stores
  /// the register's value. The second hook changes only the bits of its owner.
  template <auto Method, typename Owner>
  void also_on_write(Address address, Owner* owner) {
    const Hook before = hooks_[address];
    on_write<Method>(address, owner);
    if (!before.write) return;
    Hook& hook = hooks_[address];
    shared_.push_back({before.write, before.write_self, hook.write, owner});
    hook.write = [](void* self, Address at, std::uint8_t value) {
      const Shared& both = *static_cast<Shared*>(self);
      both.first(both.first_self, at, value);
      both.second(both.second_self, at, value);
    };
    hook.write_self = &shared_.back();
  }
  /// Registers void Owner::Method(Address), which is called before each write. Has no effect on a register
  /// without a write hook.
  template <auto Method, typename Owner>
  void before_write(Address address, Owner* owner) {
    Hook& hook = hooks_[address];
    if (!hook.write) return;
    early_.push_back({hook, [](void* self, Address at) { (static_cast<Owner*>(self)->*Method)(at); }, owner});
    hook.write = [](void* self, Address at, std::uint8_t value) {
      const Early& early = *static_cast<Early*>(self);
      early.tell(early.self, at);
      early.hook.write(early.hook.write_self, at, value);
    };
    hook.write_self = &early_.back();
    if (!hook.write_bit) return;
    hook.write_bit = [](void* self, Address at, std::uint8_t value, std::uint8_t bit) {
      const Early& early = *static_cast<Early*>(self);
      early.tell(early.self, at);
      early.hook.write_bit(early.hook.write_bit_self, at, value, bit);
    };
    hook.write_bit_self = &early_.back();
  }
  /// Registers void Owner::Method(Address, uint8_t value, uint8_t bit) as the hook of SBI and CBI.
  template <auto Method, typename Owner>
  void on_write_bit(Address address, Owner* owner) {
    Hook& hook = hooks_[address];
    hook.write_bit = [](void* self, Address at, std::uint8_t value, std::uint8_t bit) {
      (static_cast<Owner*>(self)->*Method)(at, value, bit);
    };
    hook.write_bit_self = owner;
  }
  /// Called before a hook if an event may be due by the current cycle. The callee runs the due events, so
  /// that they precede the hook.
  Call on_time;

  /// Read and write an address as firmware does, with all side effects.
  std::uint8_t load(Address address);
  void store(Address address, std::uint8_t value);

  std::uint16_t pair(Address low) const { return static_cast<std::uint16_t>(data[low] | data[low + 1] << 8); }
  std::uint8_t sreg() const { return state.sreg; }
  void set_sreg(std::uint8_t value);
  std::uint16_t sp() const { return state.sp; }
  void set_sp(std::uint16_t value) { state.sp = value; }
  std::uint32_t pc() const { return state.pc; }  ///< in words
  void set_pc(std::uint32_t words) { state.pc = words; }
  Cycle cycle() const { return state.cycle; }
  /// Advances time without running instructions, as during sleep.
  void skip_to(Cycle cycle) { state.cycle = cycle; }
  /// Returns the word address of the current or last instruction.
  std::uint32_t last_pc() const { return state.last_pc; }
  /// Returns the target of the last jump out of the flash, as a word address.
  std::uint32_t outside_pc() const { return state.outside_pc; }
  Address bad_address() const { return state.bad_address; }
  Address last_ram() const { return last_ram_; }

  const ChipSpec& chip() const { return chip_; }
  std::span<const std::uint8_t> flash() const { return flash_; }
  const Instruction& instruction(std::uint32_t pc) const { return original_[pc]; }

  /// Data memory: registers, I/O and RAM. SREG and SP are stored in `state`.
  std::vector<std::uint8_t> data;

  /// Returns whether the instruction at `pc` ends a loop that only counts down. run() executes the loop in
  /// one step.
  bool is_count(std::uint32_t pc) const;

  // --- marks: run() stops before a marked instruction
  void set_mark(std::uint32_t pc, bool set);
  bool has_mark(std::uint32_t pc) const { return marks_[pc] & kMark; }
  /// Marks the head of a loop, which is the loop's first instruction (idle.h). run() also stops before a
  /// head.
  void set_head(std::uint32_t pc, bool set);
  bool is_head(std::uint32_t pc) const { return marks_[pc] & kHead; }
  /// Registers bool Owner::Method(), which is called at a mark that is not a head. At this time, `state` is
  /// up to date. The method returns whether run() continues.
  template <auto Method, typename Owner>
  void on_mark(Owner* owner) {
    may_pass_ = [](void* self) { return (static_cast<Owner*>(self)->*Method)(); };
    may_pass_self_ = owner;
  }

  // --- the stack
  /// on_sp_low is called when a push, a call or an interrupt moves the stack pointer below `sp_watch`.
  /// on_sp_written is called when firmware writes SPL or SPH.
  Call on_sp_low;
  Call on_sp_written;
  /// Returns the word addresses of the most recent calls, returns and interrupts, the latest first.
  std::vector<std::uint32_t> last_jumps() const;
  /// Returns the number of interrupt handlers that were entered and have not returned yet.
  int open_handlers() const { return state.open_handlers; }
  /// on_entered is called when the processor enters a handler, before the return address is pushed. on_left
  /// is called after RETI has popped the return address, before interrupts are enabled.
  Call on_entered, on_left;
  /// Notes a switch to another task, which has its own stack and is inside `count` handlers.
  void set_open_handlers(int count);
  Cycle handler_cycles() const {
    return state.handler_cycles + (state.open_handlers > 0 ? state.cycle - state.handler_began : 0);
  }

  /// All processor state that changes while firmware runs, except `data`.
  struct State {
    Cycle cycle = 0;
    std::uint32_t pc = 0;
    std::uint32_t last_pc = 0;
    std::uint16_t sp = 0;
    std::uint16_t sp_watch = 0;
    std::uint16_t sp_before = 0;  ///< stack pointer before the last write to SPL or SPH
    std::uint8_t sreg = 0;
    Cycle held_at = kNoCycle;  ///< cycle at which an instruction set I; the next instruction is uninterrupted
    Address bad_address = 0;
    std::uint32_t outside_pc = 0;
    std::uint32_t passing = ~0u;   ///< word address whose mark was already reported
    bool reads_signature = false;  ///< LPM reads the signature row instead of flash
    int open_handlers = 0;
    Cycle handler_began = 0, handler_cycles = 0;
    std::uint32_t interrupted_pc = 0;  ///< where the current or last handler interrupted the firmware
    std::uint8_t vector = 0;           ///< vector of that handler
    Cycle last_io = 0;                 ///< last access to an I/O register outside handlers
    std::uint32_t last_io_pc = 0;
    std::array<std::uint32_t, 32> jumps{};
    std::uint32_t jump_count = 0;
  };
  State state;

 private:
  static constexpr std::uint8_t kMark = 1, kHead = 2;
  static constexpr std::uint8_t kPlainRead = 1, kPlainWrite = 2;
  static constexpr std::uint32_t kWordsOfNumberRead = 11;

  void find_time_count(std::size_t words);
  bool is_in_time_count(std::uint32_t pc) const {
    return time_count_ && pc - time_count_pc_ < TimeCount::kWords;
  }
  bool reads_number(std::uint32_t pc) const;
  Op unmarked(std::uint32_t pc) const;
  Op alone(std::uint32_t pc) const;
  void prepare(std::uint32_t pc);
  void put_mark(std::uint32_t pc, std::uint8_t kind, bool set);
  std::uint8_t load_elsewhere(Address address);
  void store_elsewhere(Address address, std::uint8_t value);
  void touch();
  /// Returns whether an OUT to SREG at `pc` follows a write of SPH. A function's prologue has such an OUT
  /// between its writes of SPH and SPL.
  bool is_in_prologue(std::uint32_t pc) const {
    if (pc == 0) return false;
    const Instruction& before = original_[pc - 1];
    return before.op == Op::out && before.k == reg::kSpH;
  }
  void stop_with(Stop why) {
    stop_ = why;
    horizon_ = 0;
  }
  void note_jump(std::uint32_t pc) { state.jumps[state.jump_count++ % state.jumps.size()] = pc; }
  void push(std::uint8_t value);
  std::uint8_t pop();
  void push_pc(std::uint32_t pc);
  std::uint32_t pop_pc();
  void leave_handler() {
    if (state.open_handlers > 0 && --state.open_handlers == 0)
      state.handler_cycles += state.cycle - state.handler_began;
    on_left();
  }
  /// Returns the program counter after a jump to `pc`. All targets outside the flash become the flash's end.
  std::uint32_t target_of(std::uint32_t pc) {
    if (pc < words_) return pc;
    state.outside_pc = pc;
    return words_;
  }
  std::uint8_t signature_row(std::uint32_t address) const;
  void write_bit(Address address, std::uint8_t bit, bool set);
  void skip_if(bool taken);

  const ChipSpec& chip_;
  std::vector<std::uint8_t> flash_;
  std::uint32_t words_ = 0;                   ///< size of the flash, in words; a power of two
  std::vector<Instruction> original_, code_;  ///< `code_` has marks and specialised operations for run()
  std::vector<Op> unmarked_;                  ///< by word: the operation in `code_` if the word had no mark
  std::vector<std::uint8_t> marks_;           ///< by word: kMark, kHead
  std::optional<TimeCount> time_count_;
  std::uint32_t time_count_pc_ = 0;
  Address ram_begin_, last_ram_;
  std::vector<Hook> hooks_;          ///< by address
  std::vector<std::uint8_t> plain_;  ///< by address: kPlainRead = no read hook, kPlainWrite = no write hook
  struct Shared {
    void (*first)(void* self, Address address, std::uint8_t value) = nullptr;
    void* first_self = nullptr;
    void (*second)(void* self, Address address, std::uint8_t value) = nullptr;
    void* second_self = nullptr;
  };
  std::deque<Shared> shared_;  ///< registers with two owners
  struct Early {
    Hook hook;  ///< the original hook
    void (*tell)(void* self, Address address);
    void* self;
  };
  std::deque<Early> early_;  ///< registers with a callback before each write
  bool (*may_pass_)(void* self) = [](void*) { return false; };
  void* may_pass_self_ = nullptr;
  Cycle horizon_ = 0;
  Stop stop_ = Stop::reached;
};

}  // namespace robosim::avr
