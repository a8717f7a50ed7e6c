#include "sim/exec/stm32/i2c.h"

#include <algorithm>

#include "sim/exec/stm32/remap.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

// Registers and bits (RM0008 26.6).
constexpr Address kI2cCr1 = 0x00, kI2cCr2 = 0x04, kI2cOar1 = 0x08, kI2cOar2 = 0x0C, kI2cDr = 0x10,
                  kI2cSr1 = 0x14, kI2cSr2 = 0x18, kI2cCcr = 0x1C, kI2cTrise = 0x20;
constexpr std::uint32_t kPe = 1u << 0, kSmBus = 1u << 1, kStart = 1u << 8, kStop = 1u << 9,
                        kSwRst = 1u << 15;                                // I2C_CR1
constexpr std::uint32_t kIterrEn = 1u << 8, kItevtEn = 1u << 9;           // I2C_CR2
constexpr std::uint32_t kSb = 1u << 0, kAf = 1u << 10, kErrors = 0xDF00;  // I2C_SR1
constexpr std::uint32_t kMsl = 1u << 0, kBusy = 1u << 1;                  // I2C_SR2

}  // namespace

I2c::I2c(Link& link, const Clocks& clocks, int number)
    : link_(link), clocks_(clocks), number_(number), base_(number == 1 ? kI2c1 : kI2c2) {
  link.snapshots.add(state_);
}

// Reports the two open-drain lines SCL and SDA as released.
bool I2c::drives(ChipPin pin, PinDrive& drive) const {
  const I2cPins pins = i2c_pins(number_, link_.map);
  if (!(state_.control & kPe) || (pin != pins.clock && pin != pins.data)) return false;
  drive.level = true;
  return true;
}

Cycle I2c::bit_cycles() const {
  const Cycle ccr = std::max<Cycle>(state_.clock & 0xFFF, 1);
  const Cycle parts = !(state_.clock & 1u << 15) ? 2 : state_.clock & 1u << 14 ? 25 : 3;
  return parts * ccr * clocks_.apb1_divider();
}

void I2c::begin(Phase phase, Cycle bits) {
  state_.phase = phase;
  state_.done_at = link_.clock.now + bits * bit_cycles();
}

void I2c::refresh_lines() {
  link_.nvic.set_line(number_ == 1 ? kIrqI2c1Event : kIrqI2c2Event,
                      state_.status & kSb && state_.control2 & kItevtEn);
  link_.nvic.set_line(number_ == 1 ? kIrqI2c1Error : kIrqI2c2Error,
                      state_.status & kErrors && state_.control2 & kIterrEn);
}

// Starts the action that CR1 requests, unless another action is in progress.
void I2c::go_on() {
  if (state_.done_at != kNoCycle || !(state_.control & kPe)) return;
  if (state_.control & kStop && masters())
    begin(Phase::stop, 1);
  else if (state_.control & kStart && (state_.phase == Phase::idle || state_.phase == Phase::refused))
    begin(Phase::start, 1);
}

void I2c::update() {
  while (link_.clock.now >= state_.done_at) {
    state_.done_at = kNoCycle;
    if (state_.phase == Phase::start) {
      state_.phase = Phase::waits_for_address;
      state_.control &= ~kStart;
      state_.status |= kSb;
    } else if (state_.phase == Phase::address) {
      state_.phase = Phase::refused;
      state_.status |= kAf;
    } else {
      state_.phase = Phase::idle;
      state_.control &= ~kStop;
      state_.status &= ~kSb;
    }
    go_on();
    refresh_lines();
  }
}

void I2c::reset(Address) {
  state_ = {};
  refresh_lines();
}

std::uint32_t I2c::read(Address address) {
  update();
  switch (address - base_) {
    case kI2cCr1:
      return state_.control;
    case kI2cCr2:
      return state_.control2;
    case kI2cOar1:
      return state_.own;
    case kI2cOar2:
      return state_.own2;
    case kI2cDr:
      return state_.data;
    case kI2cSr1:
      return state_.status;
    case kI2cSr2:
      return masters() ? kMsl | kBusy : state_.phase == Phase::start ? kBusy : 0;
    case kI2cCcr:
      return state_.clock;
    case kI2cTrise:
      return state_.rise;
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
        state_.control = kSwRst;
        return true;
      }
      state_.control = value;
      if (!(value & kPe)) {
        state_.phase = Phase::idle;
        state_.done_at = kNoCycle;
        state_.status = 0;
      }
      modelled = !(value & kSmBus);
      for (const ChipPin pin : {i2c_pins(number_, link_.map).clock, i2c_pins(number_, link_.map).data})
        link_.pin_changed(pin);
      go_on();
      break;
    case kI2cCr2:
      state_.control2 = value;
      break;
    case kI2cOar1:
      state_.own = value;
      break;
    case kI2cOar2:
      state_.own2 = value;
      break;
    case kI2cDr:
      state_.data = value & 0xFF;
      if (state_.phase == Phase::waits_for_address && state_.done_at == kNoCycle) {
        state_.status &= ~kSb;
        begin(Phase::address, 9);
      }
      break;
    case kI2cSr1:
      state_.status &= value | ~kErrors;
      break;
    case kI2cCcr:
      state_.clock = value;
      break;
    case kI2cTrise:
      state_.rise = value;
      break;
    default:
      break;
  }
  refresh_lines();
  return modelled;
}

}  // namespace robosim::exec::stm32
