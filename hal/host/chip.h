// The chip whose registers, timers and interrupts a sketch finds on the target host: of hal/host this alone
// names it.
//
// A core is compiled for one board (sim/build/compile.cpp):
//   ROBOSIM_CLOCK_HZ   the chip's clock
//   ROBOSIM_PINS       how many numbers Arduino's pins have, analog inputs included
//   ROBOSIM_ANALOG_INPUTS  how many of them are analog inputs, from A0 on
#pragma once

#include "hal/board/atmega168.h"
#include "hal/board/atmega328p.h"
#include "hal/board/board.h"

/// Of a namespace's declarations: nobody outside the image has such a name, so that gcc reaches the variables
/// without a table (-fvisibility=hidden holds for definitions alone).
#define ROBOSIM_WITHIN __attribute__((visibility("hidden")))

namespace robosim {
namespace host {

#if defined(__AVR_ATmega168__)
static constexpr const ChipSpec& kChip = kAtmega168;
#else
static constexpr const ChipSpec& kChip = kAtmega328p;
#endif
constexpr int64_t kClockHz = ROBOSIM_CLOCK_HZ;
constexpr int kPins = ROBOSIM_PINS;
constexpr int kTimers = 3;
static_assert(kTimers == kChip.timer_count, "timers.h has an object for each");

}  // namespace host
}  // namespace robosim
