#include "sim/exec/avr/chip.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace robosim::exec::avr {
namespace {

// All addresses that a 16-bit pointer reaches: libsimavr reports an access behind the RAM, and then does it.
constexpr std::size_t kAddressSpace = 0x10000;
// How often the stack is looked at; a sixth of a percent of the time.
constexpr Cycle kLookEvery = 1000;
constexpr std::uint8_t kIntervalsToRepeat = 3;
constexpr Cycle kRepeatWithin_s = 10;

constexpr std::uint8_t kSleepModeMask = 0x0E, kIdle = 0x00, kNoiseReduction = 0x02;

constexpr std::uint8_t kTimerInterrupts = 0x07, kCaptureInterrupt = 0x20, kUartInterrupts = 0xE0,
                       kAdcInterrupt = 0x08;

Chip* chip_of(avr_t* avr) { return static_cast<Chip*>(avr->custom.data); }

/// Where the jump at the reset vector leads.
std::uint32_t reset_target(const std::uint8_t* flash, std::uint32_t flash_bytes) {
  const unsigned first = flash[0] | flash[1] << 8;
  if ((first & 0xFE0E) == 0x940C) return static_cast<std::uint32_t>(flash[2] | flash[3] << 8) * 2;
  if ((first & 0xF000) == 0xC000) {
    const int offset = static_cast<int>(first & 0xFFF) - (first & 0x800 ? 0x1000 : 0);
    return static_cast<std::uint32_t>(2 + 2 * offset) & (flash_bytes - 1);
  }
  return 0;
}

}  // namespace

Chip::Chip(const Firmware& firmware, const BoardSpec& board, Peripherals& peripherals)
    : spec_(*board.chip),
      peripherals_(peripherals),
      hooks_(board.chip->ram_address),
      lowest_sp_(firmware.last_ram) {
  avr_global_logger_set(&Chip::on_log);
  avr_ = avr_make_mcu_by_name(spec_.emulator_name);
  if (!avr_) throw std::runtime_error(std::string("libsimavr knows no ") + spec_.name);
  avr_->custom.data = this;
  avr_init(avr_);
  avr_->log = LOG_ERROR;
  avr_->frequency = board.clock_hz;
  avr_->vcc = avr_->avcc = avr_->aref = static_cast<std::uint32_t>(1000.0 * board.supply_volts);
  avr_->sleep = &Chip::on_sleep;
  run_ = avr_->run;

  avr_->flash = static_cast<std::uint8_t*>(std::realloc(avr_->flash, kAddressSpace + 4));
  avr_->data = static_cast<std::uint8_t*>(std::realloc(avr_->data, kAddressSpace));
  if (!avr_->flash || !avr_->data) throw std::bad_alloc();
  std::memset(avr_->data + avr_->ramend + 1, 0, kAddressSpace - avr_->ramend - 1u);
  if (firmware.needs_larger_chip()) {
    avr_->ramend = firmware.last_ram;
    avr_->flashend = kAddressSpace - 1;
  }
  for (std::uint32_t pc = 0; pc < kAddressSpace; pc += 2) set_word(pc, kTrapOpcode);
  std::memcpy(avr_->flash, firmware.flash.data(), firmware.flash.size());
  avr_->codeend = firmware.code_end;
  avr_->reset_pc = avr_->pc = reset_target(avr_->flash, spec_.flash_bytes);
  if (avr_->reset_pc != 0) set_word(0, kTrapOpcode);

  for (int i = 0; i < spec_.timer_count; ++i) {
    const TimerSpec& timer = spec_.timers[i];
    const std::uint8_t capture = timer.capture ? kCaptureInterrupt : 0;
    clocked_.push_back({timer.enables, static_cast<std::uint8_t>(kTimerInterrupts | capture), 0});
  }
  for (int i = 0; i < spec_.uart_count; ++i)
    clocked_.push_back({static_cast<reg::Address>(spec_.uarts[i].address + 1), kUartInterrupts, 0});
  clocked_.push_back({reg::kAdcsra, kAdcInterrupt, 0});

  patch_timers();
  hook_registers();
  after_reset();
}

Chip::~Chip() {
  avr_terminate(avr_);
  std::free(avr_);
}

void Chip::set_word(std::uint32_t pc, std::uint16_t value) {
  avr_->flash[pc] = static_cast<std::uint8_t>(value);
  avr_->flash[pc + 1] = static_cast<std::uint8_t>(value >> 8);
}

avr_io_t* Chip::module(const char* kind, int number) {
  // The list is in reverse order of their initialisation.
  avr_io_t* found[8] = {};
  int count = 0;
  for (avr_io_t* io = avr_->io_port; io && count < 8; io = io->next)
    if (std::strcmp(io->kind, kind) == 0) found[count++] = io;
  return number < count ? found[count - 1 - number] : nullptr;
}

void Chip::patch_timers() {
  const auto set = [](avr_timer_wgm_t& mode, unsigned kind, unsigned size, unsigned top) {
    mode = {};
    mode.kind = kind & 0xFF;
    mode.size = size & 0xFF;
    mode.top = top & 0xFF;
  };
  for (int number = 0; number < spec_.timer_count; ++number) {
    auto* timer = find_module<avr_timer_t>("timer", number);
    if (spec_.timers[number].bits == 8) {
      set(timer->wgm_op[1], avr_timer_wgm_fc_pwm, 8, avr_timer_wgm_reg_constant);
      set(timer->wgm_op[5], avr_timer_wgm_pwm, 0, avr_timer_wgm_reg_ocra);
      continue;
    }
    for (unsigned mode = 1; mode <= 3; ++mode)
      set(timer->wgm_op[mode], avr_timer_wgm_fc_pwm, 7 + mode, avr_timer_wgm_reg_constant);
    set(timer->wgm_op[10], avr_timer_wgm_pwm, 0, avr_timer_wgm_reg_icr);
    set(timer->wgm_op[11], avr_timer_wgm_pwm, 0, avr_timer_wgm_reg_ocra);
  }
}

void Chip::hook_registers() {
  for (reg::Address address = reg::kFirstIo; address < spec_.ram_address; ++address) {
    auto& io = avr_->io[AVR_DATA_TO_IO(address)];
    Hook& hook = hooks_[address];
    hook = {io.r.c, io.r.param, io.w.c, io.w.param};
    const bool stack = address == reg::kSpL || address == reg::kSpH;
    io.w.c = stack ? &Chip::on_stack_write : address == reg::kSreg ? &Chip::on_status_write : &Chip::on_write;
    io.w.param = this;
    if (stack || address == reg::kSreg) continue;
    io.r.c = &Chip::on_read;
    io.r.param = this;
  }
  avr_irq_register_notify(avr_get_interrupt_irq(avr_, AVR_INT_ANY) + AVR_INT_IRQ_RUNNING, &Chip::on_handler,
                          this);
  if (avr_io_t* flash = module("flash", 0)) {
    flash_ioctl_ = flash->ioctl;
    flash->ioctl = &Chip::on_flash;
  }
}

void Chip::after_reset() {
  for (std::uint8_t number = 0; number < spec_.external_count; ++number)
    avr_extint_set_strict_lvl_trig(avr_, number, 0);
  // The analog comparator listens to these, by calls at every bit that is written.
  for (const reg::Address address : {reg::kAdcsra, reg::kAdcsrb, reg::kAdmux, reg::kPrr})
    avr_->io[AVR_DATA_TO_IO(address)].irq = nullptr;
}

void Chip::write_through(reg::Address address, std::uint8_t value) {
  const Hook& hook = hooks_[address];
  if (hook.write) {
    hook.write(avr_, address, value, hook.write_param);
  } else {
    avr_->data[address] = value;
  }
}

std::uint8_t Chip::read_through(reg::Address address) {
  const Hook& hook = hooks_[address];
  return hook.read ? hook.read(avr_, address, hook.read_param) : avr_->data[address];
}

void Chip::on_write(avr_t*, avr_io_addr_t address, std::uint8_t value, void* self) {
  auto& chip = *static_cast<Chip*>(self);
  chip.touch();
  chip.peripherals_.io_write(address, value);
}

std::uint8_t Chip::on_read(avr_t*, avr_io_addr_t address, void* self) {
  auto& chip = *static_cast<Chip*>(self);
  chip.touch();
  return chip.peripherals_.io_read(address);
}

void Chip::on_status_write(avr_t* avr, avr_io_addr_t, std::uint8_t, void* self) {
  // Functions with a stack frame write SREG too, right after SPH (out 0x3e): that is no access of the
  // sketch's.
  auto& chip = *static_cast<Chip*>(self);
  if (avr->pc >= 2 && (chip.word(avr->pc - 2) & 0xFE0F) == 0xBE0E) return;
  chip.touch();
}

void Chip::on_stack_write(avr_t* avr, avr_io_addr_t address, std::uint8_t value, void* self) {
  avr->data[address] = value;
  // Functions write SPH, then SPL, by `out`; calls, returns, push and pop write SPL, then SPH. Only then is
  // it whole.
  const unsigned opcode = avr->flash[avr->pc] | avr->flash[avr->pc + 1] << 8;
  const bool by_out = (opcode & 0xFE0E) == 0xBE0C;
  if (by_out != (address == reg::kSpL)) return;
  auto& chip = *static_cast<Chip*>(self);
  const bool push_or_pop = (opcode & 0xFC0F) == 0x900F;
  if (!by_out && !push_or_pop) chip.jumps_[chip.jump_count_++ % chip.jumps_.size()] = avr->pc;
  chip.stack_moved();
}

void Chip::stack_moved() {
  const std::uint16_t now = sp();
  if (now >= lowest_sp_) return;
  lowest_sp_ = now;
  if (now < stack_limit_) fail(Fault::Kind::stack, avr_->pc, 0);
}

std::vector<std::uint32_t> Chip::last_jumps() const {
  std::vector<std::uint32_t> jumps;
  for (std::uint32_t i = jump_count_; i-- > 0 && jumps.size() < jumps_.size();)
    jumps.push_back(jumps_[i % jumps_.size()]);
  return jumps;
}

void Chip::on_handler(avr_irq_t*, std::uint32_t value, void* self) {
  auto& chip = *static_cast<Chip*>(self);
  const bool handling = value != 0;
  if (handling == chip.handling_) return;
  chip.handling_ = handling;
  if (handling) {
    chip.handler_began_ = chip.avr_->cycle;
    chip.interrupted_pc_ = chip.return_address(static_cast<reg::Address>(chip.sp() + 1));
  } else {
    chip.handler_cycles_ += chip.avr_->cycle - chip.handler_began_;
  }
}

Cycle Chip::handler_cycles() const {
  return handler_cycles_ + (handling_ ? avr_->cycle - handler_began_ : 0);
}

avr_cycle_count_t Chip::on_stop(avr_t*, avr_cycle_count_t, void*) { return 0; }

void Chip::on_sleep(avr_t* avr, avr_cycle_count_t cycles) { chip_of(avr)->sleep_cycles_ += cycles + 1; }

int Chip::on_flash(avr_io_t* module, std::uint32_t control, void* parameter) {
  Chip& chip = *chip_of(module->avr);
  if (control != AVR_IOCTL_FLASH_SPM) return chip.flash_ioctl_(module, control, parameter);
  if (chip.data(reg::kSpmcsr) & 1) {
    chip.fail(Fault::Kind::flash_write, chip.pc(),
              static_cast<std::uint32_t>(chip.data(30) | chip.data(31) << 8));
  }
  return 0;
}

void Chip::on_log(avr_t* avr, int level, const char* format, va_list arguments) {
  if (!avr || level != LOG_ERROR || !avr->custom.data) return;
  Chip& chip = *chip_of(avr);
  const bool write = std::strstr(format, "Invalid write address") != nullptr;
  if (write || std::strstr(format, "Invalid read address")) {
    va_list copy;
    va_copy(copy, arguments);
    const unsigned pc = va_arg(copy, unsigned);
    va_arg(copy, unsigned);  // SP
    va_arg(copy, unsigned);  // opcode
    const unsigned address = va_arg(copy, unsigned);
    va_end(copy);
    chip.fail(write ? Fault::Kind::bad_write : Fault::Kind::bad_read, pc, address);
  } else if (std::strstr(format, "Invalid Opcode")) {
    chip.invalid_opcode();
  } else if (std::strcmp(format, "%s\n") == 0) {  // avr_sadly_crashed
    chip.fail(Fault::Kind::bad_jump, avr->pc, 0);
  }
}

void Chip::fail(Fault::Kind kind, std::uint32_t pc, std::uint32_t address) {
  if (fault_) return;
  fault_ = Fault{kind, pc, address};
  avr_->state = cpu_Crashed;
}

std::uint8_t Chip::status() const {
  std::uint8_t value = 0;
  READ_SREG_INTO(avr_, value);
  return value;
}

void Chip::set_pc(std::uint32_t pc) {
  avr_->pc = pc;
  passing_.reset();
}

void Chip::set_status(std::uint8_t value) { SET_SREG_FROM(avr_, value); }

void Chip::run_to(Cycle cycle) {
  if (fault_ || off_) return;
  stop_ = cycle;
  if (cycle > avr_->cycle) avr_cycle_timer_register(avr_, cycle - avr_->cycle, &Chip::on_stop, this);
  while (avr_->cycle < stop_ && !fault_ && !off_ && !trapped_) {
    step();
    if (singly_) break;
  }
}

void Chip::stop_at(Cycle cycle) {
  if (cycle >= stop_) return;
  stop_ = cycle;
  const Cycle now = avr_->cycle;
  avr_cycle_timer_register(avr_, cycle > now ? cycle - now : 1, &Chip::on_stop, this);
}

void Chip::step() {
  avr_->run_cycle_limit = kLookEvery;
  if (avr_->run != run_) return watchdog_bites();
  const bool was_asleep = is_asleep();
  const std::uint32_t pc = avr_->pc;
  if (passing_ == pc) {
    pass_trap();
  } else {
    if (singly_) avr_->run_cycle_count = 0;
    avr_run(avr_);
  }
  if (trapped_) {
    avr_->pc -= 2;
    avr_->state = cpu_Running;
    passing_ = avr_->pc;
    return;
  }
  if (is_asleep()) {
    last_io_ = avr_->cycle;
    last_io_pc_ = avr_->pc;
    if (!was_asleep) enter_sleep();
    return;
  }
  if (deep_) leave_sleep();
  if (avr_->state == cpu_Done) off_ = true;
  if (avr_->state == cpu_Running) peripherals_.look();
}

void Chip::enter_sleep() {
  const int mode = data(reg::kSmcr) & kSleepModeMask;
  if (mode == kIdle || mode == kNoiseReduction) return;
  deep_ = true;
  for (Clocked& clocked : clocked_) {
    clocked.held = data(clocked.enables) & clocked.mask;
    avr_->data[clocked.enables] = static_cast<std::uint8_t>(data(clocked.enables) & ~clocked.mask);
  }
}

void Chip::leave_sleep() {
  deep_ = false;
  for (const Clocked& clocked : clocked_) {
    const auto value = static_cast<std::uint8_t>(data(clocked.enables) | clocked.held);
    if (clocked.mask == kUartInterrupts) {
      // A transmitter that has become free meanwhile must say so.
      peripherals_.io_write(clocked.enables, value);
    } else {
      avr_->data[clocked.enables] = value;
    }
  }
}

void Chip::watchdog_bites() {
  reset_pc_ = avr_->pc;
  passing_.reset();
  const Cycle now = avr_->cycle;
  watchdog_resets_ =
      watchdog_resets_ > 0 && now - last_bite_ < kRepeatWithin_s * clock_hz() ? watchdog_resets_ + 1 : 1;
  last_bite_ = now;
  avr_->run(avr_);
  avr_->cycle = now + 1;
  deep_ = false;
  after_reset();
  // As optiboot does: the flags of the reset are cleared, and the watchdog is off when the sketch starts.
  avr_->data[reg::kMcusr] = 0;
  write_through(reg::kWdtcsr, 0x18);
  write_through(reg::kWdtcsr, 0x00);
  peripherals_.was_reset();
  if (handling_) handler_cycles_ += now - handler_began_;
  handling_ = false;
  // The reset has taken away all timers, the one that ends this run too.
  if (stop_ > avr_->cycle) avr_cycle_timer_register(avr_, stop_ - avr_->cycle, &Chip::on_stop, this);
  if (watchdog_resets_ >= kIntervalsToRepeat) fail(Fault::Kind::watchdog, reset_pc_, 0);
}

}  // namespace robosim::exec::avr
