#include "hal/host/comparator.h"

#include "hal/board/board_spec.h"
#include "hal/host/adc.h"
#include "hal/host/interrupts.h"
#include "hal/host/ports.h"
#include "hal/host/timers.h"

namespace robosim {
namespace host {

Comparator comparator;

namespace {

constexpr uint8_t kAnyEdge = 0, kFallingEdge = 2, kRisingEdge = 3;
constexpr int kLookEvery_cycles = 64;

}  // namespace

double Comparator::negative_volts() const {
  const bool selected = adc.control_b() & kAcme && !adc.on();
  if (!selected) return board->read_volts(pin_of_comparator(1), state.now);
  const int pin = board->spec().analog_pin_0 + (adc.multiplexer() & (kChip.comparator.channels - 1));
  return pin < board->spec().pin_count ? board->read_volts(places[pin].wired, state.now) : 0.0;
}

void Comparator::look() {
  if (control_ & kAcd) return;
  const double positive =
      control_ & kAcbg ? kChip.adc.bandgap_volts : board->read_volts(pin_of_comparator(0), state.now);
  const bool output = positive > negative_volts();
  if (output == output_) return;
  output_ = output;
  timer1.comparator_changed(output);
  const int sense = control_ & kAcis;
  if (sense == kAnyEdge || sense == (output ? kRisingEdge : kFallingEdge)) control_ |= kAci;
}

void Comparator::look_again() {
  look();
  due_ = state.now + cycles(kLookEvery_cycles);
}

uint8_t Comparator::control() {
  look();
  return static_cast<uint8_t>(control_ | (output_ ? kAco : 0));
}

void Comparator::set_control(uint8_t value) {
  rare_used = true;
  look();
  control_ = static_cast<uint8_t>((value & ~(kAco | kAci)) | (control_ & kAci & ~value));
  timer1.capture_comparator(value & kAcic, output_);
  look();
  const bool watches = !(value & kAcd) && value & (kAcie | kAcic);
  due_ = watches ? state.now + cycles(kLookEvery_cycles) : kNever;
}

bool Comparator::may_interrupt() const { return (control_ & (kAcd | kAcie)) == kAcie; }
bool Comparator::pending() const { return (control_ & (kAci | kAcie)) == (kAci | kAcie); }
void Comparator::acknowledge() { control_ &= static_cast<uint8_t>(~kAci); }

}  // namespace host
}  // namespace robosim
