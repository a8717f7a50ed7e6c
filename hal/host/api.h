// Records calls of the Arduino API, so that a verdict can name the call in which firmware waits. API
// functions for pins, time and interfaces call note_call() or note_question() first.
#pragma once

#include "hal/host/clock.h"
#include "hal/host/interrupts.h"
#include "hal/host/polling.h"
#include "hal/host/register_memory.h"

namespace robosim {
namespace host {

__attribute__((always_inline)) inline void note_arguments(const char* name, Pin pin, int8_t arguments,
                                                          int32_t first, int32_t second) {
  state.last_call = state.now;
  state.call.name = name;
  state.call.argument[0] = first;
  state.call.argument[1] = second;
  state.call.arguments = arguments;
  state.call.pin = pin;
}

/// Records a call. This function is inlined, so it sees the return address of the API function: a place in
/// the sketch.
__attribute__((always_inline)) inline void note_call(const char* name, Pin pin, int8_t arguments,
                                                     int32_t first = 0, int32_t second = 0) {
  if (__builtin_expect(unsettled != nullptr, 0)) unsettled();
  state.touched = true;
  state.place = __builtin_return_address(0);
  if (!in_handler()) note_arguments(name, pin, arguments, first, second);
}

/// Records a query: a call that has no effect except its time, which spend_asking() spends. Its result may
/// depend only on firmware's memory, on Timer 0's counts (note_clock()), and on levels passed to
/// note_level() (both in polling.h).
__attribute__((always_inline)) inline void note_question(const char* name, Pin pin, int8_t arguments,
                                                         int32_t first = 0) {
  if (__builtin_expect(unsettled != nullptr, 0) && !polling.on) unsettled();
  polling.calls = true;
  state.place = __builtin_return_address(0);
  if (!in_handler()) note_arguments(name, pin, arguments, first, 0);
}

/// Records the start of a conversion of an analog input.
inline void note_conversion() {
  if (!in_handler()) state.reads.add(InputReads::kAnalog);
}

/// Records the digital read of a pin, and the time.
inline void note_read(Pin pin) {
  if (in_handler()) return;
  state.reads.add(pin);
  state.read_at = state.now;
}

}  // namespace host
}  // namespace robosim
