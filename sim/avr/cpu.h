// The processor of an AVR: registers, status, program counter, memory, and a loop that runs decoded
// instructions. Source: AVR Instruction Set Manual, DS40002198B; ATmega328P data sheet DS40002061B, chapter
// 7.
//
//   cycle     an instruction that begins at cycle c and takes n accesses memory and registers at c + n: two
//             consecutive IN read one cycle apart, two LDS two
//   horizon   run() stops at this cycle: the next event of a peripheral, or the end that its caller requests
//
// It does not know peripherals and interrupts by name: those are hooks of registers, and vectors.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "hal/board/avr_registers.h"
#include "hal/board/chip_spec.h"
#include "sim/avr/cycle.h"
#include "sim/avr/decode.h"
#include "sim/avr/outlook.h"
#include "sim/avr/time_count.h"

namespace robosim::avr {

using Address = std::uint16_t;  ///< in data memory

class Cpu {
 public:
  /// Bits of SREG.
  static constexpr std::uint8_t kC = 1, kZ = 2, kN = 4, kV = 8, kS = 16, kH = 32, kT = 64, kI = 128;

  /// Why run(), or Chip::run_to(), came back.
  enum class Stop : std::uint8_t {
    reached,   ///< the cycle
    sleep,     ///< SLEEP ran; the program counter is behind it
    mark,      ///< the instruction at the program counter has a mark; run() again runs it
    break_,    ///< BREAK ran
    illegal,   ///< a reserved opcode; the program counter is at it
    outside,   ///< the program counter is behind the flash: by a jump to outside_pc(), or by running on
    bad_read,  ///< the instruction before has touched bad_address(), which has no memory
    bad_write,
    spm,      ///< SPM ran
    stopped,  ///< somebody called stop(); of a chip in single steps: an instruction has run
    off,      ///< of a chip: it sleeps with interrupts off, and nothing but a reset will wake it
  };

  /// `flash` holds whole words, at most all that the program counter reaches; `last_ram`: the last address of
  /// data memory.
  Cpu(const ChipSpec& chip, std::span<const std::uint8_t> flash, Address last_ram);

  // --- running
  /// Runs until `until`, or a few cycles later, or until something stops it.
  Stop run(Cycle until);
  /// From within a hook: run() comes back after this instruction, though nothing stopped it.
  void look_up() { horizon_ = 0; }
  /// The same, with Stop::stopped.
  void stop() { stop_with(Stop::stopped); }

  /// WDR calls this, and whoever wants to knows that.
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
  /// Takes 4 cycles, 5 with a program counter of 22 bits: the return address is pushed, I is cleared.
  void enter(int vector);
  /// Behind enter(): all of the handler at once, if it is the core's of timer 0 and nothing comes before
  /// `until` that it must wait for (time_count.h).
  void count_time(Cycle until);
  /// Where the processor goes on then, in words.
  std::uint32_t entry_of(int vector) const;
  /// Whether an interrupt may be taken now: I is set, and not by the instruction that has just run, behind
  /// which one more runs (SEI, RETI, and what else sets I).
  bool interruptible() const { return state.sreg & kI && state.cycle != state.held_at; }
  bool interrupts_enabled() const { return state.sreg & kI; }
  /// Those that wait, a bit each: whoever sets I while one does has run() come back. Null: always.
  const std::uint64_t* waiting = nullptr;
  /// As after a reset: the program counter is 0, registers of I/O are 0, memory is kept.
  void reset();

  // --- registers and memory
  /// What stands behind a register of I/O. Without hooks it keeps what is written. Hooks are called at the
  /// cycle of the access, with everything due before it done (on_time).
  struct Hook {
    std::uint8_t (*read)(void* self, Address address) = nullptr;
    void (*write)(void* self, Address address, std::uint8_t value) = nullptr;
    /// SBI and CBI: `value` is the register's (data) with the bit changed; `bit` is a mask. Without it they
    /// read and write.
    void (*write_bit)(void* self, Address address, std::uint8_t value, std::uint8_t bit) = nullptr;
    /// Without it, a register with `read` has none.
    Outlook (*outlook)(void* self, Address address, std::uint8_t bits) = nullptr;
    bool is_steady = false;
    void* read_self = nullptr;
    void* outlook_self = nullptr;
    void* write_self = nullptr;
    void* write_bit_self = nullptr;
  };
  /// Outlook Owner::Method(Address, uint8_t bits): what reads will give, of which only these bits are looked
  /// at. Asked with all done that was due before.
  template <auto Method, typename Owner>
  void on_outlook(Address address, Owner* owner) {
    Hook& hook = hooks_[address];
    hook.outlook = [](void* self, Address at, std::uint8_t bits) {
      return (static_cast<Owner*>(self)->*Method)(at, bits);
    };
    hook.outlook_self = owner;
  }
  /// Reading the register changes nothing, and between events and writes it gives the same.
  void is_steady(Address address) { hooks_[address].is_steady = true; }
  Outlook outlook(Address address, std::uint8_t bits) const;
  /// Which bits of a register of I/O the instruction at `pc`, which reads it, looks at: it, or the one behind
  /// it, may drop the others at once. kAllBits: that is not known.
  std::uint8_t bits_read(std::uint32_t pc) const;
  static constexpr std::uint8_t kAllBits = 0xFF;

  /// uint8_t Owner::Method(Address)
  template <auto Method, typename Owner>
  void on_read(Address address, Owner* owner) {
    Hook& hook = hooks_[address];
    hook.read = [](void* self, Address at) { return (static_cast<Owner*>(self)->*Method)(at); };
    hook.read_self = owner;
    plain_[address] &= static_cast<std::uint8_t>(~kPlainRead);
  }
  /// void Owner::Method(Address, uint8_t value)
  template <auto Method, typename Owner>
  void on_write(Address address, Owner* owner) {
    Hook& hook = hooks_[address];
    hook.write = [](void* self, Address at, std::uint8_t value) {
      (static_cast<Owner*>(self)->*Method)(at, value);
    };
    hook.write_self = owner;
    plain_[address] &= static_cast<std::uint8_t>(~kPlainWrite);
  }
  /// The same for a register that has an owner already: `owner` is called behind it. Both keep the register
  /// as the first has left it, but for bits of their own.
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
  /// void Owner::Method(Address): told before each write to the register, if somebody owns it by now.
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
  /// void Owner::Method(Address, uint8_t value, uint8_t bit)
  template <auto Method, typename Owner>
  void on_write_bit(Address address, Owner* owner) {
    Hook& hook = hooks_[address];
    hook.write_bit = [](void* self, Address at, std::uint8_t value, std::uint8_t bit) {
      (static_cast<Owner*>(self)->*Method)(at, value, bit);
    };
    hook.write_bit_self = owner;
  }
  /// Called before a hook, where something may be due by this cycle: that is to be done first.
  Call on_time;

  /// As firmware reads and writes, with all that follows.
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
  /// Time passes without instructions: in sleep.
  void skip_to(Cycle cycle) { state.cycle = cycle; }
  /// Of the instruction that runs or ran last, in words.
  std::uint32_t last_pc() const { return state.last_pc; }
  /// Where the last jump out of the flash led to, in words.
  std::uint32_t outside_pc() const { return state.outside_pc; }
  Address bad_address() const { return state.bad_address; }
  Address last_ram() const { return last_ram_; }

  const ChipSpec& chip() const { return chip_; }
  std::span<const std::uint8_t> flash() const { return flash_; }
  const Instruction& instruction(std::uint32_t pc) const { return original_[pc]; }

  /// The registers, I/O and RAM. SREG and SP are not kept here.
  std::vector<std::uint8_t> data;

  /// Whether it is the end of a loop that counts down, which run() runs through at once.
  bool is_count(std::uint32_t pc) const;

  // --- marks: run() stops before an instruction
  void set_mark(std::uint32_t pc, bool set);
  bool has_mark(std::uint32_t pc) const { return marks_[pc] & kMark; }
  /// Those of loops, which are told in the same way.
  void set_head(std::uint32_t pc, bool set);
  bool is_head(std::uint32_t pc) const { return marks_[pc] & kHead; }
  /// bool Owner::Method() is asked at a mark that is no head, with all of `state` as it is there: whether
  /// run() runs on.
  template <auto Method, typename Owner>
  void on_mark(Owner* owner) {
    may_pass_ = [](void* self) { return (static_cast<Owner*>(self)->*Method)(); };
    may_pass_self_ = owner;
  }

  // --- the stack
  /// When the stack pointer goes below `sp_watch` by a push, a call or an interrupt, and whenever firmware
  /// writes SPL or SPH (on_sp_written), these are called.
  Call on_sp_low;
  Call on_sp_written;
  /// The last calls, returns and interrupts, the last first: addresses in words.
  std::vector<std::uint32_t> last_jumps() const;
  /// Interrupt handlers that are open.
  int open_handlers() const { return state.open_handlers; }
  /// The processor enters a handler, but has not put the return address on the stack yet; and RETI has
  /// returned from one, but has not enabled interrupts yet.
  Call on_entered, on_left;
  /// Another task goes on, on a stack of its own: it was in so many handlers.
  void set_open_handlers(int count);
  Cycle handler_cycles() const {
    return state.handler_cycles + (state.open_handlers > 0 ? state.cycle - state.handler_began : 0);
  }

  /// All of the processor that changes while it runs, but for `data`.
  struct State {
    Cycle cycle = 0;
    std::uint32_t pc = 0;
    std::uint32_t last_pc = 0;
    std::uint16_t sp = 0;
    std::uint16_t sp_watch = 0;
    std::uint16_t sp_before = 0;  ///< before the last write to SPL or SPH
    std::uint8_t sreg = 0;
    Cycle held_at = kNoCycle;  ///< one more instruction runs before an interrupt: none has since then
    Address bad_address = 0;
    std::uint32_t outside_pc = 0;
    std::uint32_t passing = ~0u;   ///< where the mark has been told
    bool reads_signature = false;  ///< LPM reads the signature row in the place of flash
    int open_handlers = 0;
    Cycle handler_began = 0, handler_cycles = 0;
    std::uint32_t interrupted_pc = 0;  ///< where the open handler, or the last one, interrupted the firmware
    std::uint8_t vector = 0;           ///< of that handler
    Cycle last_io = 0;                 ///< last access to a register of I/O outside of handlers
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
  /// Whether an OUT to SREG stands between the halves of the stack pointer: it is a function's that makes
  /// room for its variables.
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
  /// Where the program counter goes on: behind the flash, if `pc` is.
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
  std::uint32_t words_ = 0;                   ///< of flash; a power of two
  std::vector<Instruction> original_, code_;  ///< code_: as run() has it
  std::vector<Op> unmarked_;                  ///< by word: what code_ would have without marks in front of it
  std::vector<std::uint8_t> marks_;           ///< by word: kMark, kHead
  std::optional<TimeCount> time_count_;
  std::uint32_t time_count_pc_ = 0;
  Address ram_begin_, last_ram_;
  std::vector<Hook> hooks_;          ///< by address
  std::vector<std::uint8_t> plain_;  ///< by address: which accesses are those of memory
  struct Shared {
    void (*first)(void* self, Address address, std::uint8_t value) = nullptr;
    void* first_self = nullptr;
    void (*second)(void* self, Address address, std::uint8_t value) = nullptr;
    void* second_self = nullptr;
  };
  std::deque<Shared> shared_;  ///< by who has two owners
  struct Early {
    Hook hook;  ///< as it was
    void (*tell)(void* self, Address address);
    void* self;
  };
  std::deque<Early> early_;  ///< by whom somebody is told first
  bool (*may_pass_)(void* self) = [](void*) { return false; };
  void* may_pass_self_ = nullptr;
  Cycle horizon_ = 0;
  Stop stop_ = Stop::reached;
};

}  // namespace robosim::avr
