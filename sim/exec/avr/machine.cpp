#include "sim/exec/avr/machine.h"

#include "sim/exec/avr/debug_port.h"

namespace robosim::exec::avr {
namespace {

constexpr int kSerial = 0;  // the UART that the board wires to the outside
constexpr std::uint8_t kEempe = 0x04, kEepe = 0x02, kEere = 0x01;

}  // namespace

Machine::Machine(const Firmware& firmware, std::optional<std::uint32_t> loop, ClockedBoard& board, SimTime t)
    : firmware_(firmware),
      board_(board),
      chip_(firmware, board.spec(), *this),
      link_{chip_, board, CycleTime(board.spec().clock_hz), t},
      stack_(chip_, firmware),
      ports_(link_),
      adc_(link_),
      uart_(link_, kSerial) {
  avr_eeprom_desc_t content{board.eeprom(), 0, board.spec().eeprom_bytes};
  avr_ioctl(chip_.simavr(), AVR_IOCTL_EEPROM_SET, &content);
  if (loop) chip_.set_trap(Chip::kLoopTrap, *loop);
}

Machine::~Machine() = default;

void Machine::io_write(reg::Address address, std::uint8_t value) {
  if (ports_.owns(address)) {
    ports_.write(address, value);
  } else if (uart_.owns(address)) {
    uart_.write(address, value);
  } else if (address == reg::kEecr) {
    write_eeprom_control(value);
  } else {
    chip_.write_through(address, value);
    timer_written(address);
    if (ports_.selects_interrupts(address)) ports_.interrupts_changed();
  }
  const SimTime next = board_.next_input();
  if (next != kNever) chip_.stop_at(link_.cycle_at(next));
}

std::uint8_t Machine::io_read(reg::Address address) {
  if (ports_.owns(address)) return ports_.read(address);
  if (uart_.owns(address)) return uart_.read(address);
  if (address == reg::kAdcL || address == reg::kAdcH) return adc_.read(address);
  return chip_.read_through(address);
}

void Machine::timer_written(reg::Address address) {
  const int timer = ports_.timer_of(address);
  if (timer < 0) return;
  const TimerSpec& spec = chip_.spec().timers[timer];
  if (address == spec.capture) {
    // libsimavr overlooks a new top; stopping and starting the timer makes it look.
    const auto control_b = static_cast<reg::Address>(spec.control + 1);
    const std::uint8_t control = chip_.data(control_b);
    if (control & 0x10 && control & 7) {
      chip_.write_through(control_b, static_cast<std::uint8_t>(control & ~7));
      chip_.write_through(control_b, control);
    }
  }
  ports_.timer_changed(timer);
}

avr_cycle_count_t Machine::on_eeprom_written(avr_t* avr, avr_cycle_count_t, void* self) {
  static_cast<Machine*>(self)->eeprom_busy_ = false;
  avr->data[reg::kEecr] &= static_cast<std::uint8_t>(~kEepe);
  return 0;
}

void Machine::write_eeprom_control(std::uint8_t value) {
  if (eeprom_busy_) return;  // the chip ignores it while it writes
  const bool writes = value & kEepe && chip_.data(reg::kEecr) & kEempe;
  const auto address = static_cast<std::uint16_t>((chip_.data(reg::kEearL) | chip_.data(reg::kEearH) << 8) %
                                                  board_.spec().eeprom_bytes);
  if (value & kEere) {  // libsimavr has a copy; the board's is the one that counts
    avr_eeprom_desc_t byte{board_.eeprom() + address, address, 1};
    avr_ioctl(chip_.simavr(), AVR_IOCTL_EEPROM_SET, &byte);
  }
  chip_.write_through(reg::kEecr, value);
  if (!writes) return;
  std::uint8_t written = 0;
  avr_eeprom_desc_t byte{&written, address, 1};
  avr_ioctl(chip_.simavr(), AVR_IOCTL_EEPROM_GET, &byte);
  board_.write_eeprom(address, written, link_.now());
  // libsimavr is done at once; the chip takes its time.
  eeprom_busy_ = true;
  chip_.memory()[reg::kEecr] |= kEepe;
  avr_cycle_timer_register(chip_.simavr(), static_cast<Cycle>(link_.cycles.whole(kEepromWriteTime)),
                           &Machine::on_eeprom_written, this);
}

void Machine::was_reset() {
  eeprom_busy_ = false;
  looped_ = false;
  ports_.was_reset();
  adc_.was_reset();
  uart_.was_reset();
}

void Machine::take_inputs() {
  BoardInput input;
  while (board_.take_input(link_.time_of(chip_.cycle()), input)) {
    if (input.kind == BoardInput::Kind::edge) {
      ports_.deliver(input);
    } else {
      uart_.receive(input.value);
    }
  }
}

void Machine::loop_began() {
  const Cycle now = chip_.cycle();
  if (looped_) {
    const Cycle took = now - loop_began_;
    ++loop_times_.count;
    loop_times_.total += took;
    if (took > loop_times_.longest) loop_times_.longest = took;
  }
  looped_ = true;
  loop_began_ = now;
}

void Machine::set_debug_port(DebugPort* port) {
  debug_port_ = port;
  if (port) port->plug_into(*this);
}

std::uint8_t Machine::peek(reg::Address address) {
  if (address == reg::kSreg) return chip_.status();
  bool counter = false;
  for (int i = 0; i < chip_.spec().timer_count; ++i) {
    const TimerSpec& timer = chip_.spec().timers[i];
    counter |= address >= timer.count && address < timer.count + timer.bits / 8;
  }
  if (counter) chip_.read_through(address);
  return chip_.data(address);
}

void Machine::poke(reg::Address address, std::uint8_t value) {
  if (address == reg::kSreg) {
    chip_.set_status(value);
  } else if (address == reg::kSpL || address == reg::kSpH || address < reg::kFirstIo ||
             address >= chip_.spec().ram_address) {
    chip_.memory()[address] = value;
  } else {
    io_write(address, value);
  }
}

void Machine::trace_bytes(WrittenBytes& bytes) {
  written_ = &bytes;
  if (const auto write = firmware_.find(WrittenBytes::kFunction)) chip_.set_trap(Chip::kWriteTrap, *write);
}

void Machine::write_called() {
  constexpr reg::Address kByte = 22;  // where avr-gcc passes it, `this` being in 24 and 25
  written_->wrote(chip_.data(kByte), board_.to_world(link_.now()));
}

void Machine::set_clock(SimTime start) {
  clock_start_ = start;
  if (const auto main = firmware_.find("main")) chip_.set_trap(Chip::kMainTrap, *main);
}

void Machine::start_clock() {
  chip_.clear_trap(Chip::kMainTrap, chip_.pc());
  // The core's (wiring.c): milliseconds, and overflows of timer 0.
  constexpr SimTime kOverflowCycles = 64 * 256;
  const auto set = [&](const char* variable, std::uint64_t value) {
    const auto address = firmware_.find_variable(variable);
    for (int i = 0; address && i < 4; ++i)
      chip_.memory()[*address + i] = static_cast<std::uint8_t>(value >> (8 * i));
  };
  set("timer0_millis", static_cast<std::uint64_t>(clock_start_ / kMillisecond));
  set("timer0_overflow_count", static_cast<std::uint64_t>(clock_start_ / link_.cycles.of(kOverflowCycles)));
}

Resources Machine::resources() const {
  const double cycle_us = 1e6 / chip_.clock_hz();
  Resources r;
  r.flash_bytes = static_cast<std::uint32_t>(firmware_.flash.size());
  r.ram_bytes = firmware_.ram_bytes;
  r.stack_bytes_max = stack_.most_bytes();
  r.loops = loop_times_.count;
  const Cycle present = looped_ ? chip_.cycle() - loop_began_ : 0;
  r.loop_us_max = static_cast<double>(std::max(loop_times_.longest, present)) * cycle_us;
  if (r.loops > 0)
    r.loop_us_mean = static_cast<double>(loop_times_.total) * cycle_us / static_cast<double>(r.loops);
  const auto all = static_cast<double>(std::max<Cycle>(chip_.cycle(), 1));
  r.interrupt_share = static_cast<double>(chip_.handler_cycles()) / all;
  r.cpu_load = 1.0 - static_cast<double>(chip_.sleep_cycles()) / all;
  return r;
}

void Machine::run_until(SimTime t) {
  const Cycle end = link_.cycle_at(t);
  if (debug_port_) debug_port_->begin_tick();
  while (chip_.cycle() < end && !chip_.fault() && !chip_.is_off()) {
    take_inputs();
    const SimTime next = board_.next_input();
    const Cycle stop = next < t ? std::max(link_.cycle_at(next), chip_.cycle() + 1) : end;
    chip_.run_to(std::min(stop, end));
    const unsigned traps = chip_.take_traps();
    if (traps & Chip::kLoopTrap) loop_began();
    if (traps & Chip::kMainTrap) start_clock();
    if (traps & Chip::kWriteTrap) write_called();
    if (debug_port_) debug_port_->ran(traps & Chip::kBreakpoint);
  }
}

}  // namespace robosim::exec::avr
