#include "sim/exec/stm32/i2c.h"

#include <algorithm>

#include "sim/exec/stm32/remap.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

// RM0008 26.6
constexpr Address kI2cCr1 = 0x00, kI2cCr2 = 0x04, kI2cOar1 = 0x08, kI2cOar2 = 0x0C, kI2cDr = 0x10,
                  kI2cSr1 = 0x14, kI2cSr2 = 0x18, kI2cCcr = 0x1C, kI2cTrise = 0x20;
constexpr std::uint32_t kPe = 1u << 0, kSmBus = 1u << 1, kStart = 1u << 8, kStop = 1u << 9,
                        kSwRst = 1u << 15;                                // I2C_CR1
constexpr std::uint32_t kIterrEn = 1u << 8, kItevtEn = 1u << 9;           // I2C_CR2
constexpr std::uint32_t kSb = 1u << 0, kAf = 1u << 10, kErrors = 0xDF00;  // I2C_SR1
constexpr std::uint32_t kMsl = 1u << 0, kBusy = 1u << 1;                  // I2C_SR2

}  // namespace

I2c::I2c(Link& link, const Clocks& clocks, int number)
    : link_(link), clocks_(clocks), number_(number), base_(number == 1 ? kI2c1 : kI2c2) {}

// Both lines are open drains, and released.
bool I2c::drives(ChipPin pin, PinDrive& drive) const {
  const I2cPins pins = i2c_pins(number_, link_.map);
  if (!(control_ & kPe) || (pin != pins.clock && pin != pins.data)) return false;
  drive.level = true;
  return true;
}

Cycle I2c::bit_cycles() const {
  const Cycle ccr = std::max<Cycle>(clock_ & 0xFFF, 1);
  const Cycle parts = !(clock_ & 1u << 15) ? 2 : clock_ & 1u << 14 ? 25 : 3;
  return parts * ccr * clocks_.apb1_divider();
}

void I2c::begin(Phase phase, Cycle bits) {
  phase_ = phase;
  done_at_ = link_.clock.now + bits * bit_cycles();
}

void I2c::refresh_lines() {
  link_.nvic.set_line(number_ == 1 ? kIrqI2c1Event : kIrqI2c2Event, status_ & kSb && control2_ & kItevtEn);
  link_.nvic.set_line(number_ == 1 ? kIrqI2c1Error : kIrqI2c2Error,
                      status_ & kErrors && control2_ & kIterrEn);
}

// What CR1 asks for, when nothing else is on the bus.
void I2c::go_on() {
  if (done_at_ != kNoCycle || !(control_ & kPe)) return;
  if (control_ & kStop && masters())
    begin(Phase::stop, 1);
  else if (control_ & kStart && (phase_ == Phase::idle || phase_ == Phase::refused))
    begin(Phase::start, 1);
}

void I2c::update() {
  while (link_.clock.now >= done_at_) {
    done_at_ = kNoCycle;
    if (phase_ == Phase::start) {
      phase_ = Phase::waits_for_address;
      control_ &= ~kStart;
      status_ |= kSb;
    } else if (phase_ == Phase::address) {
      phase_ = Phase::refused;
      status_ |= kAf;
    } else {
      phase_ = Phase::idle;
      control_ &= ~kStop;
      status_ &= ~kSb;
    }
    go_on();
    refresh_lines();
  }
}

void I2c::reset(Address) {
  static_cast<I2cRegisters&>(*this) = {};
  refresh_lines();
}

std::uint32_t I2c::read(Address address) {
  update();
  switch (address - base_) {
    case kI2cCr1:
      return control_;
    case kI2cCr2:
      return control2_;
    case kI2cOar1:
      return own_;
    case kI2cOar2:
      return own2_;
    case kI2cDr:
      return data_;
    case kI2cSr1:
      return status_;
    case kI2cSr2:
      return masters() ? kMsl | kBusy : phase_ == Phase::start ? kBusy : 0;
    case kI2cCcr:
      return clock_;
    case kI2cTrise:
      return rise_;
    default:
      return 0;
  }
}

bool I2c::write(Address address, std::uint32_t value) {
  update();
  bool modelled = true;
  switch (address - base_) {
    case kI2cCr1:
      if (value & kSwRst) {
        reset(base_);
        control_ = kSwRst;
        return true;
      }
      control_ = value;
      if (!(value & kPe)) {
        phase_ = Phase::idle;
        done_at_ = kNoCycle;
        status_ = 0;
      }
      modelled = !(value & kSmBus);
      for (const ChipPin pin : {i2c_pins(number_, link_.map).clock, i2c_pins(number_, link_.map).data})
        link_.pin_changed(pin);
      go_on();
      break;
    case kI2cCr2:
      control2_ = value;
      break;
    case kI2cOar1:
      own_ = value;
      break;
    case kI2cOar2:
      own2_ = value;
      break;
    case kI2cDr:
      data_ = value & 0xFF;
      if (phase_ == Phase::waits_for_address && done_at_ == kNoCycle) {
        status_ &= ~kSb;
        begin(Phase::address, 9);
      }
      break;
    case kI2cSr1:
      status_ &= value | ~kErrors;
      break;
    case kI2cCcr:
      clock_ = value;
      break;
    case kI2cTrise:
      rise_ = value;
      break;
    default:
      break;
  }
  refresh_lines();
  return modelled;
}

}  // namespace robosim::exec::stm32
