// One chip in libsimavr: set up as the real one, run to an exact cycle, and watched for what goes
// wrong.
//
// What libsimavr 1.6 does by itself, and what is done about it here:
//   - sleeps in real time when the chip sleeps            -> its sleep function is replaced
//   - polls a low D2 or D3 every cycle                    -> only where the sketch asked for level interrupts
//   - lacks the phase correct modes of timers 1 and 2     -> filled in
//   - goes on after an invalid opcode                     -> caught
//   - writes past its own memory after a wild pointer     -> caught; its memory is enlarged
//   - restarts silently at a jump to address 0            -> a trap is put there
//   - runs on through erased flash                        -> a trap is put there
//   - starts the sketch with a 16 ms watchdog running     -> switched off, as the Uno's boot loader does
//     after the watchdog has reset the chip                  (optiboot)
#pragma once

#include <array>
#include <cstdarg>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/exec/avr/firmware.h"
#include "sim/exec/avr/registers.h"
#include "sim/exec/avr/simavr.h"

namespace robosim::exec::avr {

using Cycle = std::uint64_t;

/// The other end of the chip's I/O registers. Called in the middle of an instruction, at the cycle it began.
class Peripherals {
 public:
  virtual void io_write(reg::Address address, std::uint8_t value) = 0;
  virtual std::uint8_t io_read(reg::Address address) = 0;
  /// After the watchdog has reset the chip.
  virtual void was_reset() = 0;
  /// Every thousand cycles: a look at what cannot be hooked.
  virtual void look() = 0;

 protected:
  ~Peripherals() = default;
};

/// Why the firmware can run no further.
struct Fault {
  enum class Kind { bad_read, bad_write, bad_opcode, bad_jump, restart, stack, watchdog, flash_write };
  Kind kind = Kind::bad_jump;
  std::uint32_t pc = 0;       ///< of the instruction; of a jump, where it led
  std::uint32_t address = 0;  ///< of a read, write or flash write; the opcode of a bad_opcode
};

class Chip {
 public:
  Chip(const Firmware& firmware, const BoardSpec& board, Peripherals& peripherals);
  ~Chip();
  Chip(const Chip&) = delete;
  Chip& operator=(const Chip&) = delete;

  const ChipSpec& spec() const { return spec_; }
  std::uint32_t clock_hz() const { return avr_->frequency; }
  Cycle cycle() const { return avr_->cycle; }
  std::uint32_t pc() const { return avr_->pc; }
  std::uint16_t sp() const { return static_cast<std::uint16_t>(data(reg::kSpL) | data(reg::kSpH) << 8); }
  std::uint8_t data(reg::Address address) const { return avr_->data[address]; }
  std::uint8_t* memory() { return avr_->data; }
  avr_t* simavr() { return avr_; }
  bool in_handler() const { return avr_->interrupts.running_ptr > 0; }
  /// That a call or interrupt has put on the stack, as a flash address; its first byte is at `at`.
  std::uint32_t return_address(reg::Address at) const {
    std::uint32_t words = 0;
    for (int i = 0; i < spec_.return_address_bytes; ++i) words = words << 8 | avr_->data[at + i];
    return 2 * words;
  }

  /// Runs until `cycle` or a few cycles later; returns sooner after a fault, after stop_at(), or when the
  /// firmware has switched itself off.
  void run_to(Cycle cycle);
  /// From within a callback: run_to() shall return at `cycle`, if that is sooner.
  void stop_at(Cycle cycle);

  const std::optional<Fault>& fault() const { return fault_; }
  void fail(Fault::Kind kind, std::uint32_t pc, std::uint32_t address);
  /// The firmware sleeps with interrupts off: nothing will ever wake it.
  bool is_off() const { return off_; }
  bool is_asleep() const { return avr_->state == cpu_Sleeping; }

  /// What libsimavr itself does with a register.
  void write_through(reg::Address address, std::uint8_t value);
  std::uint8_t read_through(reg::Address address);

  /// The module of libsimavr of that kind; timers, in the order of their numbers.
  template <typename Module>
  Module* find_module(const char* kind, int number = 0) {
    return reinterpret_cast<Module*>(module(kind, number));
  }

  // --- traps: the emulator stops before an instruction
  /// Who wants to know that an instruction is about to run.
  enum Trap : unsigned { kLoopTrap = 1, kMainTrap = 2, kBreakpoint = 4, kWriteTrap = 8 };
  void set_trap(Trap trap, std::uint32_t pc);
  void clear_trap(Trap trap, std::uint32_t pc);
  /// The traps, as a sum, that run_to() returned for; they are armed again as the chip runs on.
  unsigned take_traps();

  // --- for debuggers
  /// run_to() returns after every instruction, and after every jump of time while the chip sleeps.
  void step_singly(bool singly) { singly_ = singly; }
  int open_handlers() const { return avr_->interrupts.running_ptr; }
  std::uint8_t status() const;
  void set_status(std::uint8_t value);
  void set_pc(std::uint32_t pc);

  // --- the stack, followed at every change of the stack pointer
  std::uint16_t lowest_sp() const { return lowest_sp_; }
  /// Fails when the stack pointer goes below this.
  void set_stack_limit(std::uint16_t limit) { stack_limit_ = limit; }
  /// Addresses of the calls, returns and interrupted instructions that ran last, the last first.
  std::vector<std::uint32_t> last_jumps() const;

  // --- accounts, in cycles
  Cycle last_io() const { return last_io_; }  ///< last access to an I/O register outside handlers
  std::uint32_t last_io_pc() const { return last_io_pc_; }
  Cycle handler_cycles() const;  ///< spent in interrupt handlers
  Cycle sleep_cycles() const { return sleep_cycles_; }
  int watchdog_resets() const { return watchdog_resets_; }
  /// Where the firmware was when the handler that runs now, or ran last, interrupted it.
  std::uint32_t interrupted_pc() const { return interrupted_pc_; }
  std::uint32_t reset_pc() const { return reset_pc_; }  ///< where it was when the watchdog last bit

 private:
  /// What stands where nothing shall run: no instruction of the chip, nor of libsimavr.
  static constexpr std::uint16_t kTrapOpcode = 0x00FF;
  struct TrapPlace {
    std::uint32_t pc = 0;
    std::uint16_t opcode = 0;  ///< the instruction that belongs there
    unsigned traps = 0;        ///< a sum
  };
  struct Hook {
    avr_io_read_t read = nullptr;
    void* read_param = nullptr;
    avr_io_write_t write = nullptr;
    void* write_param = nullptr;
  };

  static void on_write(avr_t* avr, avr_io_addr_t address, std::uint8_t value, void* self);
  static std::uint8_t on_read(avr_t* avr, avr_io_addr_t address, void* self);
  static void on_status_write(avr_t* avr, avr_io_addr_t address, std::uint8_t value, void* self);
  static void on_stack_write(avr_t* avr, avr_io_addr_t address, std::uint8_t value, void* self);
  static void on_handler(avr_irq_t* irq, std::uint32_t value, void* self);
  static avr_cycle_count_t on_stop(avr_t* avr, avr_cycle_count_t when, void* self);
  static void on_sleep(avr_t* avr, avr_cycle_count_t cycles);
  static int on_flash(avr_io_t* module, std::uint32_t control, void* parameter);
  static void on_log(avr_t* avr, int level, const char* format, va_list arguments);

  avr_io_t* module(const char* kind, int number);
  void hook_registers();
  void patch_timers();
  void after_reset();
  void watchdog_bites();
  void step();
  std::vector<TrapPlace>::iterator trap_place(std::uint32_t pc);
  void pass_trap();
  void invalid_opcode();
  void enter_sleep();
  void leave_sleep();
  void stack_moved();
  void touch() {
    if (in_handler()) return;
    last_io_ = avr_->cycle;
    last_io_pc_ = avr_->pc;
  }
  std::uint16_t word(std::uint32_t pc) const {
    return static_cast<std::uint16_t>(avr_->flash[pc] | avr_->flash[pc + 1] << 8);
  }
  void set_word(std::uint32_t pc, std::uint16_t value);

  const ChipSpec& spec_;
  Peripherals& peripherals_;
  avr_t* avr_ = nullptr;
  avr_run_t run_ = nullptr;
  std::vector<Hook> hooks_;  ///< by address
  std::vector<TrapPlace> traps_;
  unsigned trapped_ = 0;
  std::optional<std::uint32_t> passing_;  ///< the instruction whose trap has been told: it runs next
  bool singly_ = false;
  std::optional<Fault> fault_;
  int (*flash_ioctl_)(avr_io_t*, std::uint32_t, void*) = nullptr;
  std::uint16_t lowest_sp_ = 0;
  std::uint16_t stack_limit_ = 0;
  std::array<std::uint32_t, 32> jumps_{};
  std::uint32_t jump_count_ = 0;
  bool off_ = false;
  bool deep_ = false;  ///< asleep with the timers' clock stopped
  /// Interrupts that need a clock which stands still in deep sleep: the register that enables them, its bits,
  /// and those that were set.
  struct Clocked {
    reg::Address enables = 0;
    std::uint8_t mask = 0;
    std::uint8_t held = 0;
  };
  std::vector<Clocked> clocked_;
  Cycle stop_ = 0;
  Cycle last_io_ = 0;
  std::uint32_t last_io_pc_ = 0;
  Cycle handler_began_ = 0, handler_cycles_ = 0;
  bool handling_ = false;
  Cycle sleep_cycles_ = 0;
  int watchdog_resets_ = 0;
  Cycle last_bite_ = 0;
  std::uint32_t reset_pc_ = 0;
  std::uint32_t interrupted_pc_ = 0;
};

}  // namespace robosim::exec::avr
