#include "hal/host/clock.h"

#include <string.h>

#include "hal/host/interrupts.h"
#include "hal/host/polling.h"
#include "hal/host/register_memory.h"
#include "hal/host/timers.h"
#include "hal/host/tone.h"
#include "hal/host/watchdog.h"

namespace robosim {
namespace host {

ROBOSIM_CLOCKWORK FirmwareState state;
FirmwarePort* board;
const BoardSpec* board_spec;
const double* supply_volts;
Host* executor;
ROBOSIM_CLOCKWORK SimTime deadline, watched_deadline;
SimTime sooner;
void (*unsettled)();

namespace {

constexpr size_t kFrames = 256;  // stack bytes of hand_registers(), hand_stack() and functions between them

void yield_to_executor(SimTime wake) {
  state.wake = wake;
  executor->yield();
}

/// Returns the time of the next event that occurs even with interrupts disabled.
SimTime next_event() { return watchdog.due() < tone_end ? watchdog.due() : tone_end; }

/// Returns the time of the next event. `pending` means that an interrupt is ready to be served.
SimTime next_due(bool pending) {
  const SimTime event = next_event();
  if (!interrupts_enabled()) return event;
  const SimTime next = pending ? state.now : next_interrupt(true);
  return next < event ? next : event;
}

void set_deadline(SimTime due) {
  deadline = polling.again ? state.now : state.limit < due ? state.limit : due;
}

// Handles the most frequent case: only Timer 0's overflow is due, and the core's own handler serves it. The
// result equals that of reach_deadline(), which checks all peripherals. In any other case, returns false and
// changes nothing.
bool serve_overflow_alone() {
  if (state.now >= state.limit || !interrupts_enabled() || !timer0.overflows_next()) return false;
  const SimTime next = next_alone();
  if (next <= state.now) return false;
  timer0.take_overflows();
  ++handlers_run;
  __vector_16();
  set_deadline(next < timer0.due() ? next : timer0.due());
  return true;
}

// Idles if Timer 0's overflow, served by the core's own handler, is the only event before `time`. The result
// equals that of idle_until(), which checks all peripherals. In any other case, returns false and changes
// nothing, and idle_until() must continue.
bool sleep_alone(SimTime time) {
  while (interrupts_enabled()) {
    const SimTime next = next_alone();
    if (next <= time) return false;
    if (time >= state.limit) {
      yield_to_executor(time);
      continue;
    }
    if (time > state.now) state.now = time;
    state.touched = true;
    timer0_catch_up();
    set_deadline(next < timer0.due() ? next : timer0.due());
    return true;
  }
  return false;
}

}  // namespace

SimTime next_due() {
  if (!interrupts_enabled()) return next_event();
  if (const SimTime next = next_alone()) return next < timer0.due() ? next : timer0.due();
  return next_due(pending_interrupts());
}

void refresh_deadline() {
  settle_registers();
  set_deadline(next_due());
}

void reach_deadline() {
  settle_registers();
  polling.again = false;
  int served = 0;
  if (serve_overflow_alone()) {
    if (state.now < deadline) return;
    ++served;
  }
  // Limits the number of handlers: a low level raises its interrupt repeatedly, but the sketch must progress.
  while (served < kVectors) {
    if (state.now >= state.limit) {
      yield_to_executor(state.now);
      continue;
    }
    sync_peripherals();
    if (!serve_interrupt()) return set_deadline(next_due(false));
    ++served;
    refresh_deadline();
    if (state.now < deadline) return;
  }
  while (state.now >= state.limit) yield_to_executor(state.now);
  refresh_deadline();
}

namespace {

// Clears the remains of earlier calls from the stack, because they would count as firmware state.
__attribute__((noinline)) void wipe_stack() {
  uint8_t frame[kFrames];
  memset(frame, 0, sizeof frame);
  __asm__ volatile("" : : "r"(frame) : "memory");
}

__attribute__((noinline)) void hand_stack() {
  const auto* const stack = static_cast<const uint8_t*>(__builtin_frame_address(0));
  if (!polling.on) {
    executor->block_begins(stack);
  } else if (polling.take) {
    executor->take_state(stack);
  } else {
    polling.same = executor->has_state(stack);
  }
  __asm__ volatile("" ::: "memory");  // prevents a tail call, so that the frame stays
}

// Saves callee-saved registers, which contain values of the callers, in the stack frame of this function.
__attribute__((noinline)) void hand_registers() {
  __builtin_unwind_init();
  hand_stack();
  __asm__ volatile("" ::: "memory");
}

__attribute__((noinline)) void block_is_due() {
  if (unsettled) {
    unsettled();
    watched_deadline = deadline;
    if (!state.watched && state.now < deadline) return;
  }
  if (state.watched && !in_handler()) {
    wipe_stack();
    hand_registers();
    if (!state.watched) deadline = watched_deadline;
    if (state.now < watched_deadline) return;
  }
  reach_deadline();
  watched_deadline = deadline;
  if (state.watched && !in_handler()) deadline = state.now;
  begin_look();
}

// Comparisons of the firmware's state include the stack frame of this function. The frame must therefore
// contain only a frame pointer, and no variables or gaps.
__attribute__((noinline)) void block_in_look() {
  __asm__ volatile("" : : "r"(__builtin_frame_address(0)));
  if (look_wants_state()) {
    wipe_stack();
    hand_registers();
  }
  if (!look_at_block()) block_is_due();
}

}  // namespace

void block_at_deadline() {
  if (polling.on) return block_in_look();
  block_is_due();
}

void work(SimTime duration) {
  while (duration > 0) {
    const SimTime free = deadline - state.now;
    const SimTime step = free < 0 ? 0 : free < duration ? free : duration;
    state.now += step;
    duration -= step;
    if (state.now >= deadline) reach_deadline();
  }
}

void be_late() {
  while (state.now >= state.late_from) {
    const SimTime by = state.lateness->by;
    ++state.lateness;
    state.late_from = state.lateness->from;
    if (by < 0) sooner -= by;
    work(by);
  }
}

void idle_until(SimTime time) {
  settle_registers();
  if (sleep_alone(time)) return;
  // Only the following code raises flags during the wait.
  bool pending = interrupts_enabled() && pending_interrupts();
  while (state.now < time) {
    SimTime next = time < next_event() ? time : next_event();
    if (interrupts_enabled()) {
      const SimTime due = pending ? state.now : next_interrupt(false);
      if (due < next) next = due;
    }
    if (next >= state.limit) {
      yield_to_executor(next);
      continue;
    }
    if (next > state.now) state.now = next;
    timer0_catch_up();
    sync_peripherals();
    bool served = serve_interrupt();
    while (served && state.now < time) {
      sync_peripherals();
      served = serve_interrupt();
    }
    pending = served && interrupts_enabled() && pending_interrupts();
  }
  set_deadline(next_due(pending));
}

void wait_long(SimTime time) {
  const bool outer = state.waiting;
  state.waiting = !in_handler();
  idle_until(time);
  state.waiting = outer;
}

void wait_for_interrupt(bool timer0_counts) {
  settle_registers();
  const bool outer = state.waiting;
  state.waiting = !in_handler();
  const uint32_t before = handlers_run;
  while (handlers_run == before) {
    const SimTime next = next_interrupt(timer0_counts);
    if (next >= state.limit) {
      yield_to_executor(next);
      continue;
    }
    if (next > state.now) state.now = next;
    if (!timer0_counts) timer0_catch_up();
    sync_peripherals();
    serve_interrupt();
  }
  state.waiting = outer;
  refresh_deadline();
}

void stop_for_ever(const char* how) {
  status_register &= static_cast<uint8_t>(~kI);
  while (watchdog.may_bite()) idle_until(watchdog.due());
  state.stopped_by = how;
  for (;;) yield_to_executor(kNever);
}

}  // namespace host
}  // namespace robosim

/// Advances time in an endless loop without a body, `for (;;);`. gcc does not instrument such a loop.
/// Therefore, sim/build replaces the loop's jump with a call of this function.
#if defined(__x86_64__) || defined(__i386__)
#define ROBOSIM_ALIGN_STACK __attribute__((force_align_arg_pointer))
#else
#define ROBOSIM_ALIGN_STACK
#endif
extern "C" ROBOSIM_ALIGN_STACK void robosim_endless_loop() {
  robosim::host::state.place = __builtin_return_address(0);
  robosim::host::state.endless = true;
  for (;;) robosim::host::idle_until(robosim::kNever);
}

extern "C" void __sanitizer_cov_trace_pc() {
  using namespace robosim::host;
  state.place = __builtin_return_address(0);
  spend_in_block(cost::kBlock);
}
