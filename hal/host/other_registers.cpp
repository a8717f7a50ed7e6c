#include "hal/host/other_registers.h"

#include "hal/board/avr_registers.h"
#include "hal/host/clock.h"
#include "hal/host/comparator.h"
#include "hal/host/eeprom.h"
#include "hal/host/ports.h"
#include "hal/host/timers.h"

namespace robosim {
namespace host {
namespace {

using namespace avr::reg;

constexpr Address kOsccal = 0x66, kTccr1c = 0x82, kAssr = 0xB6, kTwamr = 0xBD;

uint8_t plain[256];

/// Bits of a register that have an effect on the chip, but not on the host.
struct Lack {
  Address address;
  uint8_t bits;
  bool by_reading;  ///< reads are affected, too
  const char* name;
};
constexpr Lack kLacks[] = {
    {kGtccr, kTsm, false, "TSM in GTCCR"},
    {kSpmcsr, 0xFF, true, "SPMCSR"},
    {kSpL, 0xFF, true, "SP"},
    {kSpH, 0xFF, true, "SP"},
    {kClkpr, 0x0F, false, "CLKPR"},
    {kOsccal, 0xFF, true, "OSCCAL"},
    {kAssr, 0x7F, false, "ASSR"},
    {kTwamr, 0xFE, false, "TWAMR"},
};

const Lack* lack_at(uint8_t address) {
  for (const Lack& lack : kLacks)
    if (lack.address == address) return &lack;
  return nullptr;
}

/// Returns whether the timer has an enabled interrupt, or runs with other settings than those of init().
bool is_in_use(const Timer& timer, uint8_t divisor_of_init) {
  const bool is_left = timer.control_a() == 1 && timer.control_b() == divisor_of_init;
  return timer.enabled() || (timer.control_b() & 7 && !is_left);
}

/// Returns the bits of PRR that stop a timer in use. Ignores bits of the converter, the serial lines and the
/// two-wire interface. These modules act only when the sketch uses them, and a sketch must not use a module
/// that is off.
uint8_t stopped_by(uint8_t reduction) {
  const int in_use = (is_in_use(timer1, 3) ? 0x08 : 0) | (is_in_use(timer0, 3) ? 0x20 : 0) |
                     (is_in_use(timer2, 4) ? 0x40 : 0);
  return static_cast<uint8_t>(reduction & in_use);
}

}  // namespace

void note_lack(const char* what) { executor->lacks(what, state.place); }

uint8_t sleep_control() { return plain[kSmcr]; }

uint8_t read_other(uint8_t address) {
  switch (address) {
    case kEecr:
      return eeprom.control();
    case kEedr:
      return eeprom.data();
    case kEearL:
      return static_cast<uint8_t>(eeprom.address());
    case kEearH:
      return static_cast<uint8_t>(eeprom.address() >> 8);
    case kChip.comparator.address:
      return comparator.control();
  }
  const Lack* const lack = lack_at(address);
  if (lack && lack->by_reading) note_lack(lack->name);
  return plain[address];
}

void write_other(uint8_t address, uint8_t value) {
  switch (address) {
    case kEecr:
      return eeprom.set_control(value);
    case kEedr:
      return eeprom.set_data(value);
    case kEearL:
      return eeprom.set_address(static_cast<uint16_t>((eeprom.address() & 0xFF00) | value));
    case kEearH:
      return eeprom.set_address(static_cast<uint16_t>((eeprom.address() & 0xFF) | value << 8));
    case kChip.comparator.address:
      return comparator.set_control(value);
    case kTccr1c:
      return timer1.force_compare(value);
    case kMcucr:
      set_pull_ups_off(value & kPud);
      break;
    case kGtccr:
      if (value & kPsrasy) timer2.reset_prescaler();
      if (value & kPsrsync) timer0.reset_prescaler(), timer1.reset_prescaler();
      if (!(value & kTsm)) value &= ~(kPsrasy | kPsrsync);
      break;
  }
  const Lack* const lack = lack_at(address);
  if (lack && value & lack->bits) note_lack(lack->name);
  if (address == kPrr && stopped_by(value)) note_lack("PRR");
  plain[address] = value;
  if (address == kDidr0 || address == kDidr1)
    inputs_off = static_cast<uint16_t>(plain[kDidr0] | plain[kDidr1] << 8);
}

}  // namespace host
}  // namespace robosim
