#include "hal/host/registers.h"

#include "hal/board/avr_registers.h"
#include "hal/host/access.h"
#include "hal/host/adc.h"
#include "hal/host/api.h"
#include "hal/host/external.h"
#include "hal/host/other_registers.h"
#include "hal/host/ports.h"
#include "hal/host/spi.h"
#include "hal/host/timers.h"
#include "hal/host/two_wire.h"
#include "hal/host/uart.h"
#include "hal/host/watchdog.h"

namespace robosim {
namespace host {
namespace {

// The ChipSpec has the addresses of ports, timers, UART, SPI and two-wire interface.
namespace reg {

using namespace avr::reg;

constexpr Address kPinB = kChip.ports[0].address, kDdrB = kPinB + 1, kPortB = kPinB + 2;
constexpr Address kLastPort = kChip.ports[kChip.port_count - 1].address + 2;
constexpr Address kTccr0a = kChip.timers[0].control, kTccr0b = kTccr0a + 1, kTcnt0 = kChip.timers[0].count;
constexpr Address kOcr0a = kChip.timers[0].compare[0], kOcr0b = kChip.timers[0].compare[1];
constexpr Address kTccr1a = kChip.timers[1].control, kTccr1b = kTccr1a + 1, kTcnt1L = kChip.timers[1].count;
constexpr Address kIcr1L = kChip.timers[1].capture;
constexpr Address kOcr1aL = kChip.timers[1].compare[0], kOcr1bL = kChip.timers[1].compare[1];
constexpr Address kTccr2a = kChip.timers[2].control, kTcnt2 = kChip.timers[2].count;
constexpr Address kOcr2b = kChip.timers[2].compare[1];
constexpr Address kTimsk0 = kChip.timers[0].enables, kTimsk2 = kChip.timers[2].enables;
constexpr Address kUcsra = kChip.uarts[0].address, kUcsrb = kUcsra + 1, kUcsrc = kUcsra + 2;
constexpr Address kSpcr = kChip.spi.address, kSpsr = kSpcr + 1, kSpdr = kSpcr + 2;
constexpr Address kTwbr = kChip.twi.address, kTwsr = kTwbr + 1, kTwar = kTwbr + 2, kTwdr = kTwbr + 3,
                  kTwcr = kTwbr + 4;
constexpr Address kUbrrL = kChip.uarts[0].divider, kUdr = kChip.uarts[0].data;

}  // namespace reg

struct Name {
  robosim_register address;
  const char* name;
};
constexpr Name kNames[] = {
    {reg::kPinB, "PINB"},     {reg::kDdrB, "DDRB"},     {reg::kPortB, "PORTB"},
    {reg::kPinB + 3, "PINC"}, {reg::kDdrB + 3, "DDRC"}, {reg::kPortB + 3, "PORTC"},
    {reg::kPinB + 6, "PIND"}, {reg::kDdrB + 6, "DDRD"}, {reg::kPortB + 6, "PORTD"},
    {reg::kAdcL, "ADC"},      {reg::kAdcsra, "ADCSRA"}, {reg::kTcnt0, "TCNT0"},
    {reg::kTcnt1L, "TCNT1"},  {reg::kTcnt2, "TCNT2"},   {reg::kUcsra, "UCSR0A"},
    {reg::kUdr, "UDR0"},      {reg::kSpsr, "SPSR"},     {reg::kTwcr, "TWCR"},
};

const char* name_of(uint8_t address) {
  for (const Name& one : kNames)
    if (one.address == address) return one.name;
  return "a register";
}

bool is_timer8(uint8_t address) {
  return (address >= reg::kTccr0a && address <= reg::kOcr0b) ||
         (address >= reg::kTccr2a && address <= reg::kOcr2b);
}

uint8_t read_timer8(uint8_t address) {
  const Timer& timer = address < reg::kTccr2a ? timer0 : timer2;
  switch (address < reg::kTccr2a ? address : address - reg::kTccr2a + reg::kTccr0a) {
    case reg::kTccr0a:
      return timer.control_a();
    case reg::kTccr0b:
      return timer.control_b();
    case reg::kTcnt0:
      return static_cast<uint8_t>(timer.count());
    case reg::kOcr0a:
      return static_cast<uint8_t>(timer.compare(0));
    default:
      return static_cast<uint8_t>(timer.compare(1));
  }
}

void write_timer8(uint8_t address, uint8_t value) {
  Timer& timer = address < reg::kTccr2a ? timer0 : timer2;
  switch (address < reg::kTccr2a ? address : address - reg::kTccr2a + reg::kTccr0a) {
    case reg::kTccr0a:
      return timer.set_control_a(value);
    case reg::kTccr0b:
      timer.set_control_b(value & ~(kFoca | kFocb));
      if (value & (kFoca | kFocb)) timer.force_compare(value);
      return;
    case reg::kTcnt0:
      return timer.set_count(value);
    case reg::kOcr0a:
      timer.write_compare(0, value);
      break;
    default:
      timer.write_compare(1, value);
  }
  refresh_timer_pins(address < reg::kTccr2a ? 0 : 2);
}

bool is_word(uint8_t address) {
  return address == reg::kAdcL || address == reg::kTcnt1L || address == reg::kIcr1L ||
         address == reg::kOcr1aL || address == reg::kOcr1bL || address == reg::kUbrrL;
}

// The byte TEMP that timer 1's registers share (16.3). A write of the high byte only sets TEMP, and a write
// of the low byte writes both. A read of the low byte of TCNT1 or ICR1 stores the high byte in TEMP.
uint8_t temp;

bool is_read_by_temp(uint8_t address) { return address == reg::kTcnt1L || address == reg::kIcr1L; }
bool is_written_by_temp(uint8_t address) {
  return is_read_by_temp(address) || address == reg::kOcr1aL || address == reg::kOcr1bL;
}

uint16_t word_at(uint8_t address) {
  switch (address) {
    case reg::kAdcL:
      return adc.data();
    case reg::kTcnt1L:
      return timer1.count();
    case reg::kIcr1L:
      return timer1.capture();
    case reg::kOcr1aL:
      return timer1.compare(0);
    case reg::kOcr1bL:
      return timer1.compare(1);
    default:
      return uart.divider();
  }
}

uint16_t read_word(uint8_t address) {
  const uint16_t value = word_at(address);
  if (is_read_by_temp(address)) temp = static_cast<uint8_t>(value >> 8);
  return value;
}

uint8_t read_high(uint8_t address) {
  return is_read_by_temp(address) ? temp : static_cast<uint8_t>(word_at(address) >> 8);
}

void write_word(uint8_t address, uint16_t value) {
  if (is_written_by_temp(address)) temp = static_cast<uint8_t>(value >> 8);
  switch (address) {
    case reg::kTcnt1L:
      return timer1.set_count(value);
    case reg::kIcr1L:
      return timer1.set_capture(value);
    case reg::kOcr1aL:
      timer1.write_compare(0, value);
      return refresh_timer_pins(1);
    case reg::kOcr1bL:
      timer1.write_compare(1, value);
      return refresh_timer_pins(1);
    case reg::kUbrrL:
      return uart.set_divider(value);
    default:
      return;  // ADC is read-only
  }
}

uint8_t read(uint8_t address) {
  if (address >= reg::kPinB && address <= reg::kLastPort) {
    const auto port = static_cast<Port>((address - reg::kPinB) / 3);
    switch ((address - reg::kPinB) % 3) {
      case 0:
        return read_port(port);
      case 1:
        return ports[port].direction;
      default:
        return ports[port].output;
    }
  }
  if (is_timer8(address)) return read_timer8(address);
  if (address == reg::kAdcL) adc.lock();
  if (address == reg::kAdcH) adc.unlock();
  if (is_word(address)) return static_cast<uint8_t>(read_word(address));
  if (is_word(static_cast<uint8_t>(address - 1))) return read_high(address - 1);
  if (address >= reg::kTifr0 && address <= reg::kTifr2) return timer(address - reg::kTifr0).flags();
  if (address >= reg::kTimsk0 && address <= reg::kTimsk2) return timer(address - reg::kTimsk0).enabled();
  if (address >= reg::kPcmsk0 && address <= reg::kPcmsk2) return external.change_mask[address - reg::kPcmsk0];
  switch (address) {
    case reg::kSreg:
      return status_register;
    case reg::kPcifr:
      return external.change_flags;
    case reg::kEifr:
      return external.flags;
    case reg::kEimsk:
      return external.mask;
    case reg::kPcicr:
      return external.change_control;
    case reg::kEicra:
      return external.sense;
    case reg::kAdcsra:
      return adc.control();
    case reg::kAdcsrb:
      return adc.control_b();
    case reg::kAdmux:
      return adc.multiplexer();
    case reg::kTccr1a:
      return timer1.control_a();
    case reg::kTccr1b:
      return timer1.control_b();
    case reg::kUcsra:
      return uart.status();
    case reg::kUcsrb:
      return uart.control();
    case reg::kUcsrc:
      return uart.format();
    case reg::kUdr:
      return uart.take();
    case reg::kSpcr:
      return spi.control();
    case reg::kSpsr:
      return spi.status();
    case reg::kSpdr:
      return spi.take();
    case reg::kTwbr:
      return two_wire.rate();
    case reg::kTwsr:
      return two_wire.status();
    case reg::kTwar:
      return two_wire.address();
    case reg::kTwdr:
      return two_wire.data();
    case reg::kTwcr:
      return two_wire.control();
    case reg::kWdtcsr:
      return watchdog.control();
    default:
      return read_other(address);
  }
}

void write(uint8_t address, uint8_t value) {
  if (address >= reg::kPinB && address <= reg::kLastPort) {
    const auto port = static_cast<Port>((address - reg::kPinB) / 3);
    switch ((address - reg::kPinB) % 3) {
      case 0:
        return set_output(port, ports[port].output ^ value);  // a one written to PINx toggles
      case 1:
        return set_direction(port, value);
      default:
        return set_output(port, value);
    }
  }
  if (is_timer8(address)) return write_timer8(address, value);
  if (is_word(address)) {
    const int high = is_written_by_temp(address) ? temp << 8 : word_at(address) & 0xFF00;
    return write_word(address, static_cast<uint16_t>(high | value));
  }
  if (is_written_by_temp(static_cast<uint8_t>(address - 1))) {
    temp = value;
    return;
  }
  if (is_word(static_cast<uint8_t>(address - 1)))
    return write_word(address - 1, static_cast<uint16_t>((word_at(address - 1) & 0xFF) | value << 8));
  if (address >= reg::kTifr0 && address <= reg::kTifr2)
    return timer(address - reg::kTifr0).clear_flags(value);
  if (address >= reg::kTimsk0 && address <= reg::kTimsk2)
    return timer(address - reg::kTimsk0).set_enabled(value);
  switch (address) {
    case reg::kSreg:
      status_register = value;
      break;
    case reg::kPcifr:
      external.change_flags &= static_cast<uint8_t>(~value);
      break;
    case reg::kEifr:
      external.flags &= static_cast<uint8_t>(~value);
      break;
    case reg::kEimsk:
      external.mask = value;
      return refresh_external();
    case reg::kPcicr:
      external.change_control = value;
      return refresh_external();
    case reg::kEicra:
      external.sense = value;
      return refresh_external();
    case reg::kPcmsk0:
    case reg::kPcmsk1:
    case reg::kPcmsk2:
      external.change_mask[address - reg::kPcmsk0] = value;
      return refresh_external();
    case reg::kAdcsra:
      return adc.set_control(value);
    case reg::kAdcsrb:
      return adc.set_control_b(value);
    case reg::kAdmux:
      return adc.set_multiplexer(value);
    case reg::kTccr1a:
      return timer1.set_control_a(value);
    case reg::kTccr1b:
      return timer1.set_control_b(value);
    case reg::kUcsra:
      return uart.set_status(value);
    case reg::kUcsrb:
      return uart.set_control(value);
    case reg::kUcsrc:
      if (value & kUmsel) note_lack("UMSEL0 in UCSR0C");
      return uart.set_format(value);
    case reg::kUdr:  // 20.6.1: a write is ignored if UDRE is clear
      return uart.sending() <= 1 ? uart.send(value) : void();
    case reg::kSpcr:
      return spi.set_control(value);
    case reg::kSpsr:
      return spi.set_status(value);
    case reg::kSpdr:
      return spi.send(value);
    case reg::kTwbr:
      return two_wire.set_rate(value);
    case reg::kTwsr:
      return two_wire.set_status(value);
    case reg::kTwar:
      return two_wire.set_address(value);
    case reg::kTwdr:
      return two_wire.set_data(value);
    case reg::kTwcr:
      return two_wire.set_control(value);
    case reg::kWdtcsr:
      return watchdog.set_control(value);
    default:
      write_other(address, value);
  }
}

}  // namespace

// Records the place before spend(), because a due event may end the run.
void begin_access(robosim_register address, int bytes, const void* place) {
  settle_registers();
  if (address != reg::kSreg) note_call(name_of(address), kNoPin, -1);
  state.place = place;
  spend(bytes * cost::kRegister);
  sync_peripherals();
}

uint16_t register_value(robosim_register address, int bytes) {
  if (bytes == 1) return read(address);
  if (address == reg::kAdcL) adc.unlock();
  if (is_word(address)) return read_word(address);
  return static_cast<uint16_t>(read(address) | read(static_cast<uint8_t>(address + 1)) << 8);
}

void set_register(robosim_register address, int bytes, uint16_t value) {
  if (bytes == 1) {
    write(address, static_cast<uint8_t>(value));
  } else if (is_word(address)) {
    write_word(address, value);
  } else {
    write(address, static_cast<uint8_t>(value));
    write(static_cast<uint8_t>(address + 1), static_cast<uint8_t>(value >> 8));
  }
  refresh_deadline();
}

}  // namespace host
}  // namespace robosim

namespace host = robosim::host;

extern "C" {

uint8_t robosim_read8(robosim_register address) {
  host::begin_access(address, 1, __builtin_return_address(0));
  return host::read(address);
}

void robosim_write8(robosim_register address, uint8_t value) {
  host::begin_access(address, 1, __builtin_return_address(0));
  host::write(address, value);
  host::refresh_deadline();
  // If the PWM that init() starts has raised the timer's flag, serves the timer's interrupt before the
  // sketch's next statement.
  if (address >= host::reg::kTimsk0 && address <= host::reg::kTimsk2) host::spend(0);
}

uint16_t robosim_read16(robosim_register address) {
  host::begin_access(address, 2, __builtin_return_address(0));
  return host::register_value(address, 2);
}

void robosim_write16(robosim_register address, uint16_t value) {
  host::begin_access(address, 2, __builtin_return_address(0));
  host::set_register(address, 2, value);
}

void robosim_enable_interrupts() {
  host::settle_registers();
  host::status_register |= host::kI;
  host::state.now += host::cycles(1);
  host::refresh_deadline();  // pending interrupts are served after the next block;
                             // on the chip, after the next instruction
}

void robosim_disable_interrupts() {
  host::settle_registers();
  host::status_register &= static_cast<uint8_t>(~host::kI);
  host::spend(1);
  host::refresh_deadline();
}

void robosim_sleep() {
  host::settle_registers();
  const uint8_t control = host::sleep_control();
  if (!(control & host::kSe)) return;
  host::note_call("sleep_cpu", robosim::kNoPin, 0);
  if (!host::interrupts_enabled()) host::stop_for_ever("sleep with interrupts off");
  const bool idle = (control & host::kSm) == 0;
  if (!idle) host::note_lack("sleep modes other than idle");
  host::wait_for_interrupt(idle);
}

void robosim_watchdog_reset() {
  host::spend(1);
  host::watchdog.restart();
}

}  // extern "C"
