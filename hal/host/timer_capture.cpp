// Implements input capture (datasheet, 16.6). The selected edge of ICP1 sets ICF1 at once. ICR1 receives the
// count that TCNT1 has 3 cycles after the edge. The noise canceler adds 4 cycles, and ignores levels shorter
// than 4 cycles.
#include "hal/host/external.h"
#include "hal/host/ports.h"
#include "hal/host/timers.h"

namespace robosim {
namespace host {
namespace {

constexpr int kEdgeCycles = 3, kCancelerCycles = 4;

}  // namespace

void Timer::listen_to_captures() {
  if (listens_ || !has_capture()) return;
  listens_ = true;
  refresh_external();
}

// Selects the source of edges: comparator or pin. If their levels differ, the selection causes an edge
// (16.6.1).
void Timer::capture_comparator(bool is, bool level) {
  if (is == of_comparator_) return;
  const bool pin = read_pin(pin_of_capture());
  of_comparator_ = listens_ = is;
  comparator_ = level;
  if (!is) listen_to_captures();
  refresh_external();
  if (captures() && pin != level) capture_edge(is ? level : pin, state.now);
}

void Timer::comparator_changed(bool level) {
  if (!of_comparator_) return;
  comparator_ = level;
  if (captures()) capture_edge(level, state.now);
}

void Timer::begin_canceler() {
  passed_ = level_ = of_comparator_ ? comparator_ : read_pin(pin_of_capture());
  changed_at_ = state.now;
  may_take_back_ = false;
}

void Timer::capture_edge(bool level, SimTime at) {
  const bool rising = control_b_ & kIces, cancels = control_b_ & kIcnc;
  if (cancels) {
    if (at - changed_at_ >= cycles(kCancelerCycles)) passed_ = level_;
    level_ = level;
    changed_at_ = at;
    if (level == passed_) {
      if (level == rising || !may_take_back_) return;
      may_take_back_ = false;
      capture_ = had_capture_;
      if (!had_flag_) flags_ &= static_cast<uint8_t>(~captured);
      return;
    }
  }
  may_take_back_ = cancels && level == rising;
  if (level != rising) return;
  had_capture_ = capture_;
  had_flag_ = flags_ & captured;
  capture_ =
      count_at(tick_at((at > base_ ? at : base_) + cycles(kEdgeCycles + (cancels ? kCancelerCycles : 0))));
  flags_ |= captured;
}

}  // namespace host
}  // namespace robosim
