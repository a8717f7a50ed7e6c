// Selects the chip whose registers, timers and interrupts the target host simulates. Other headers in
// hal/host use the chip only by the name kChip.
//
// The host's Arduino core is compiled for one board. sim/build/compile.cpp defines:
//   ROBOSIM_CLOCK_HZ       the chip's clock
//   ROBOSIM_PINS           the number of Arduino pins, including analog inputs
//   ROBOSIM_ANALOG_INPUTS  the number of analog inputs, from A0 on
#pragma once

#include "hal/board/atmega168.h"
#include "hal/board/atmega328p.h"
#include "hal/board/avr_registers.h"
#include "hal/board/board.h"

/// Marks a namespace as private to the image, so gcc accesses its variables without the global offset table.
/// The option -fvisibility=hidden is not enough, because it applies only to definitions.
#define ROBOSIM_WITHIN __attribute__((visibility("hidden")))

namespace robosim {
namespace host {

using namespace avr::bits;

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
