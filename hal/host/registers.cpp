#include "hal/host/registers.h"

#include "hal/host/adc.h"
#include "hal/host/api.h"
#include "hal/host/external.h"
#include "hal/host/ports.h"
#include "hal/host/timers.h"
#include "hal/host/uart.h"

namespace robosim {
namespace host {
namespace {

// Registers that only keep what is written: SPI, TWI, watchdog, clock and power settings, GPIOR.
uint8_t plain[256];

enum Address : uint8_t {
  kPinB = 0x23,
  kPortD_ = 0x2B,
  kTifr0 = 0x35,
  kTifr2 = 0x37,
  kPcifr = 0x3B,
  kEifr = 0x3C,
  kEimsk = 0x3D,
  kTccr0a = 0x44,
  kTccr0b = 0x45,
  kTcnt0 = 0x46,
  kOcr0a = 0x47,
  kOcr0b = 0x48,
  kSmcr = 0x53,
  kSreg = 0x5F,
  kPcicr = 0x68,
  kEicra = 0x69,
  kPcmsk0 = 0x6B,
  kPcmsk2 = 0x6D,
  kTimsk0 = 0x6E,
  kTimsk2 = 0x70,
  kAdcl = 0x78,
  kAdch = 0x79,
  kAdcsra = 0x7A,
  kAdcsrb = 0x7B,
  kAdmux = 0x7C,
  kTccr1a = 0x80,
  kTccr1b = 0x81,
  kTcnt1 = 0x84,
  kIcr1 = 0x86,
  kOcr1a = 0x88,
  kOcr1b = 0x8A,
  kTccr2a = 0xB0,
  kOcr2b = 0xB4,
  kUcsr0a = 0xC0,
  kUcsr0b = 0xC1,
  kUcsr0c = 0xC2,
  kUbrr0 = 0xC4,
  kUbrr0h = 0xC5,
  kUdr0 = 0xC6,
};

const char* name_of(uint8_t address) {
  switch (address) {
    case 0x23:
      return "PINB";
    case 0x24:
      return "DDRB";
    case 0x25:
      return "PORTB";
    case 0x26:
      return "PINC";
    case 0x27:
      return "DDRC";
    case 0x28:
      return "PORTC";
    case 0x29:
      return "PIND";
    case 0x2A:
      return "DDRD";
    case 0x2B:
      return "PORTD";
    case kAdcl:
      return "ADC";
    case kAdcsra:
      return "ADCSRA";
    case kTcnt0:
      return "TCNT0";
    case kTcnt1:
      return "TCNT1";
    case 0xB2:
      return "TCNT2";
    case kUcsr0a:
      return "UCSR0A";
    case kUdr0:
      return "UDR0";
    default:
      return "a register";
  }
}

bool is_timer8(uint8_t address) {
  return (address >= kTccr0a && address <= kOcr0b) || (address >= kTccr2a && address <= kOcr2b);
}

uint8_t read_timer8(uint8_t address) {
  const Timer& timer = address < kTccr2a ? timer0 : timer2;
  switch (address < kTccr2a ? address : address - kTccr2a + kTccr0a) {
    case kTccr0a:
      return timer.control_a();
    case kTccr0b:
      return timer.control_b();
    case kTcnt0:
      return static_cast<uint8_t>(timer.count());
    case kOcr0a:
      return static_cast<uint8_t>(timer.compare(0));
    default:
      return static_cast<uint8_t>(timer.compare(1));
  }
}

void write_timer8(uint8_t address, uint8_t value) {
  Timer& timer = address < kTccr2a ? timer0 : timer2;
  switch (address < kTccr2a ? address : address - kTccr2a + kTccr0a) {
    case kTccr0a:
      return timer.set_control_a(value);
    case kTccr0b:
      return timer.set_control_b(value);
    case kTcnt0:
      return timer.set_count(value);
    case kOcr0a:
      timer.set_compare(0, value);
      break;
    default:
      timer.set_compare(1, value);
  }
  refresh_timer_pins(address < kTccr2a ? 0 : 2);
}

bool is_word(uint8_t address) {
  return address == kAdcl || address == kTcnt1 || address == kIcr1 || address == kOcr1a ||
         address == kOcr1b || address == kUbrr0;
}

uint16_t read_word(uint8_t address) {
  switch (address) {
    case kAdcl:
      return adc.data();
    case kTcnt1:
      return timer1.count();
    case kIcr1:
      return timer1.capture();
    case kOcr1a:
      return timer1.compare(0);
    case kOcr1b:
      return timer1.compare(1);
    default:
      return uart.divider();
  }
}

void write_word(uint8_t address, uint16_t value) {
  switch (address) {
    case kTcnt1:
      return timer1.set_count(value);
    case kIcr1:
      return timer1.set_capture(value);
    case kOcr1a:
      timer1.set_compare(0, value);
      return refresh_timer_pins(1);
    case kOcr1b:
      timer1.set_compare(1, value);
      return refresh_timer_pins(1);
    case kUbrr0:
      return uart.set_divider(value);
    default:
      return;  // ADC is read-only
  }
}

uint8_t read(uint8_t address) {
  if (address >= kPinB && address <= kPortD_) {
    const auto port = static_cast<Port>((address - kPinB) / 3);
    switch ((address - kPinB) % 3) {
      case 0:
        return read_port(port);
      case 1:
        return ports[port].direction;
      default:
        return ports[port].output;
    }
  }
  if (is_timer8(address)) return read_timer8(address);
  if (is_word(address)) return static_cast<uint8_t>(read_word(address));
  if (is_word(static_cast<uint8_t>(address - 1))) return static_cast<uint8_t>(read_word(address - 1) >> 8);
  if (address >= kTifr0 && address <= kTifr2) return timer(address - kTifr0).flags();
  if (address >= kTimsk0 && address <= kTimsk2) return timer(address - kTimsk0).enabled();
  if (address >= kPcmsk0 && address <= kPcmsk2) return external.change_mask[address - kPcmsk0];
  switch (address) {
    case kSreg:
      return status_register;
    case kPcifr:
      return external.change_flags;
    case kEifr:
      return external.flags;
    case kEimsk:
      return external.mask;
    case kPcicr:
      return external.change_control;
    case kEicra:
      return external.sense;
    case kAdcsra:
      return adc.control();
    case kAdcsrb:
      return adc.control_b();
    case kAdmux:
      return adc.multiplexer();
    case kTccr1a:
      return timer1.control_a();
    case kTccr1b:
      return timer1.control_b();
    case kUcsr0a:
      return uart.status();
    case kUcsr0b:
      return uart.control();
    case kUcsr0c:
      return uart.format();
    case kUdr0:
      return uart.take();
    default:
      return plain[address];
  }
}

void write(uint8_t address, uint8_t value) {
  if (address >= kPinB && address <= kPortD_) {
    const auto port = static_cast<Port>((address - kPinB) / 3);
    switch ((address - kPinB) % 3) {
      case 0:
        return set_output(port, ports[port].output ^ value);  // a one written to PINx toggles
      case 1:
        return set_direction(port, value);
      default:
        return set_output(port, value);
    }
  }
  if (is_timer8(address)) return write_timer8(address, value);
  if (is_word(address))
    return write_word(address, static_cast<uint16_t>((read_word(address) & 0xFF00) | value));
  if (is_word(static_cast<uint8_t>(address - 1)))
    return write_word(address - 1, static_cast<uint16_t>((read_word(address - 1) & 0xFF) | value << 8));
  if (address >= kTifr0 && address <= kTifr2) return timer(address - kTifr0).clear_flags(value);
  if (address >= kTimsk0 && address <= kTimsk2) return timer(address - kTimsk0).set_enabled(value);
  switch (address) {
    case kSreg:
      status_register = value;
      break;
    case kPcifr:
      external.change_flags &= static_cast<uint8_t>(~value);
      break;
    case kEifr:
      external.flags &= static_cast<uint8_t>(~value);
      break;
    case kEimsk:
      external.mask = value;
      return refresh_external();
    case kPcicr:
      external.change_control = value;
      return refresh_external();
    case kEicra:
      external.sense = value;
      return refresh_external();
    case kPcmsk0:
    case kPcmsk0 + 1:
    case kPcmsk2:
      external.change_mask[address - kPcmsk0] = value;
      return refresh_external();
    case kAdcsra:
      return adc.set_control(value);
    case kAdcsrb:
      return adc.set_control_b(value);
    case kAdmux:
      return adc.set_multiplexer(value);
    case kTccr1a:
      return timer1.set_control_a(value);
    case kTccr1b:
      return timer1.set_control_b(value);
    case kUcsr0a:
      return uart.set_status(value);
    case kUcsr0b:
      return uart.set_control(value);
    case kUcsr0c:
      return uart.set_format(value);
    case kUdr0:
      return uart.send(value);
    default:
      plain[address] = value;
  }
}

}  // namespace
}  // namespace host
}  // namespace robosim

namespace host = robosim::host;

extern "C" {

uint8_t robosim_read8(robosim_register address) {
  if (address != host::kSreg) host::note_call(host::name_of(address), robosim::kNoPin, -1);
  host::spend(host::cost::kRegister);
  host::sync_peripherals();
  return host::read(address);
}

void robosim_write8(robosim_register address, uint8_t value) {
  if (address != host::kSreg) host::note_call(host::name_of(address), robosim::kNoPin, -1);
  host::spend(host::cost::kRegister);
  host::sync_peripherals();
  host::write(address, value);
  host::refresh_deadline();
}

uint16_t robosim_read16(robosim_register address) {
  host::note_call(host::name_of(address), robosim::kNoPin, -1);
  host::spend(2 * host::cost::kRegister);
  host::sync_peripherals();
  if (host::is_word(address)) return host::read_word(address);
  return static_cast<uint16_t>(host::read(address) | host::read(static_cast<uint8_t>(address + 1)) << 8);
}

void robosim_write16(robosim_register address, uint16_t value) {
  host::note_call(host::name_of(address), robosim::kNoPin, -1);
  host::spend(2 * host::cost::kRegister);
  host::sync_peripherals();
  if (host::is_word(address)) {
    host::write_word(address, value);
  } else {
    host::write(address, static_cast<uint8_t>(value));
    host::write(static_cast<uint8_t>(address + 1), static_cast<uint8_t>(value >> 8));
  }
  host::refresh_deadline();
}

void robosim_enable_interrupts() {
  host::status_register |= 0x80;
  host::state.now += host::cycles(1);
  host::refresh_deadline();  // what is pending is served after the next block, as after the chip's next
                             // instruction
}

void robosim_disable_interrupts() {
  host::status_register &= 0x7F;
  host::spend(1);
  host::refresh_deadline();
}

void robosim_sleep() {
  constexpr uint8_t kSleepEnable = 1;
  const uint8_t control = host::plain[host::kSmcr];
  if (!(control & kSleepEnable)) return;
  host::note_call("sleep_cpu", robosim::kNoPin, 0);
  if (!host::interrupts_enabled()) host::stop_for_ever("sleep with interrupts off");
  const bool idle = (control & 0xE) == 0;
  host::wait_for_interrupt(idle);
}

void robosim_watchdog_reset() { host::spend(1); }

}  // extern "C"
