#include "hal/host/image.h"

#include <Arduino.h>

#include "hal/host/adc.h"
#include "hal/host/addresses.h"
#include "hal/host/clock.h"
#include "hal/host/coverage.h"
#include "hal/host/interrupts.h"
#include "hal/host/polling.h"
#include "hal/host/ports.h"
#include "hal/host/timers.h"
#include "hal/host/uart.h"

// The constructors of static objects, in link order. The loader does not call them; run() does.
extern "C" {
using Constructor = void (*)();
extern const Constructor __start_robosim_init_array[] __attribute__((weak, visibility("hidden")));
extern const Constructor __stop_robosim_init_array[] __attribute__((weak, visibility("hidden")));
// The bounds of the image in memory.
extern const char __ehdr_start[] __attribute__((visibility("hidden")));
extern const char _end[] __attribute__((visibility("hidden")));
// The bounds for Image::clockwork_begin and clockwork_end (image.h).
extern const char __start_robosim_clockwork[] __attribute__((visibility("hidden")));
extern const char __stop_robosim_clockwork[] __attribute__((visibility("hidden")));
// The bounds for Image::settings_begin and settings_end (image.h).
extern const char __start_robosim_settings[] __attribute__((visibility("hidden")));
extern const char __stop_robosim_settings[] __attribute__((visibility("hidden")));
}

/// The core's main(). A main() in the sketch replaces this function.
__attribute__((weak)) int firmware_main() __asm__("main");

namespace robosim {
namespace host {
namespace {

/// Returns the bits ADPS2 to ADPS0 for an ADC clock of 50 to 200 kHz, if possible. The largest value is 7,
/// which divides the chip's clock by 128.
constexpr int adc_prescaler() {
  int bits = 7;
  for (int64_t hz = 16000000; kClockHz < hz && bits > 1; hz /= 2) --bits;
  return bits;
}

void run(FirmwarePort& its_board, Host& its_executor, SimTime now) {
  board = &its_board;
  board_spec = &its_board.spec();
  supply_volts = &its_board.supply_volts();
  executor = &its_executor;
  state.now = now;
  place_pins();
  refresh_deadline();
  for (const Constructor* c = __start_robosim_init_array; c != __stop_robosim_init_array; ++c) (*c)();
  firmware_main();
  stop_for_ever("the end of main()");
}

}  // namespace
}  // namespace host
}  // namespace robosim

namespace host = robosim::host;

extern "C" {

/// Initialises the chip like wiring.c. At 16 MHz, PWM has 976 Hz on pins 5 and 6, and 490 Hz on the others.
/// Timer 0 counts for millis(), the ADC has 125 kHz, and the UART is off. Register bits set by constructors
/// of static objects are preserved, except those of timer 1's prescaler.
void init() {
  const auto with = [](uint8_t value, int bits) { return static_cast<uint8_t>(value | bits); };
  host::status_register |= host::kI;
  host::timer0.set_control_a(with(host::timer0.control_a(), 3));
  host::timer0.set_control_b(with(host::timer0.control_b(), 3));
  host::timer0.set_enabled(with(host::timer0.enabled(), host::Timer::overflow));
  host::timer1.set_control_b(3);
  host::timer1.set_control_a(with(host::timer1.control_a(), 1));
  host::timer1.leave_bottom();
  host::adc.set_control(with(host::adc.control(), host::kAden | host::adc_prescaler()));
  host::adc.enabled_by_init();
  host::uart.set_control(0);
  host::refresh_deadline();
  host::spend(host::cost::kInit);
  // Starts timer 2 last: its first tick, 64 cycles later, comes after the first statements of setup().
  host::timer2.set_control_b(with(host::timer2.control_b(), 4));
  host::timer2.set_control_a(with(host::timer2.control_a(), 1));
  host::refresh_deadline();
}

__attribute__((weak)) void initVariant() {}

const host::Image robosim_image = {host::kImageVersion,
                                   &host::state,
                                   host::run,
                                   host::kShadow,
                                   __ehdr_start,
                                   _end,
                                   __start_robosim_clockwork,
                                   __stop_robosim_clockwork,
                                   __start_robosim_settings,
                                   __stop_robosim_settings,
                                   host::may_interrupt,
                                   host::kCounters};

}  // extern "C"

int firmware_main() {
  init();
  initVariant();
  host::be_late_if_due();
  setup();
  host::state.call = {};  // If loop() calls nothing, a verdict must not name the last call of setup().
  for (;;) {
    loop();
    host::spend_between_loops(host::cost::kLoop);
    host::be_late_if_due();
    if (serialEventRun) serialEventRun();
  }
}
