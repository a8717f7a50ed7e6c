#include "hal/host/interrupts.h"

#include "hal/host/adc.h"
#include "hal/host/clock.h"
#include "hal/host/comparator.h"
#include "hal/host/eeprom.h"
#include "hal/host/external.h"
#include "hal/host/polling.h"
#include "hal/host/register_memory.h"
#include "hal/host/spi.h"
#include "hal/host/timers.h"
#include "hal/host/tone.h"
#include "hal/host/two_wire.h"
#include "hal/host/uart.h"
#include "hal/host/watchdog.h"
#include "hal/host/waves.h"

// Declares a vector that a sketch defines by ISR(…). Unused vectors are null; timers.cpp has `__vector_16`.
#define ROBOSIM_VECTOR(number) __attribute__((weak, visibility("hidden"))) void __vector_##number();
extern "C" {
ROBOSIM_VECTOR(1)
ROBOSIM_VECTOR(2)
ROBOSIM_VECTOR(3)
ROBOSIM_VECTOR(4)
ROBOSIM_VECTOR(5)
ROBOSIM_VECTOR(6)
ROBOSIM_VECTOR(7)
ROBOSIM_VECTOR(8)
ROBOSIM_VECTOR(9)
ROBOSIM_VECTOR(10)
ROBOSIM_VECTOR(11)
ROBOSIM_VECTOR(12)
ROBOSIM_VECTOR(13)
ROBOSIM_VECTOR(14)
ROBOSIM_VECTOR(15)
void __vector_16();
ROBOSIM_VECTOR(17)
ROBOSIM_VECTOR(18)
ROBOSIM_VECTOR(19)
ROBOSIM_VECTOR(20)
ROBOSIM_VECTOR(21)
ROBOSIM_VECTOR(22)
ROBOSIM_VECTOR(23)
ROBOSIM_VECTOR(24)
void robosim_serve_line();  // attach.cpp
}

namespace robosim {
namespace host {

uint8_t status_register;
ROBOSIM_CLOCKWORK uint32_t handlers_run;
bool rare_used;

int handler_depth;

namespace {

// The names of the handlers in this file contain these vector numbers.
static_assert(kChip.vectors == 26 && kExternal0 == 1 && kPinChange0 == 3 && kTimer2 == 7 && kTimer1 == 11 &&
                  kTimer0 == 14 && kUartReceived == 18 && kAdcComplete == 21 && kSpi == 17 &&
                  kEepromReady == 22 && kCompared == 23 && kTwoWire == 24 && kWatchdog == 6,
              "the names in this file are those of another chip");

#define ROBOSIM_NO_HANDLER(name) \
  "the interrupt " name " is enabled, but there is no ISR(" name ") (the chip would restart)"
const char* const kNoHandler[kVectors] = {
    "",
    "",
    "",
    ROBOSIM_NO_HANDLER("PCINT0_vect"),
    ROBOSIM_NO_HANDLER("PCINT1_vect"),
    ROBOSIM_NO_HANDLER("PCINT2_vect"),
    ROBOSIM_NO_HANDLER("WDT_vect"),
    ROBOSIM_NO_HANDLER("TIMER2_COMPA_vect"),
    ROBOSIM_NO_HANDLER("TIMER2_COMPB_vect"),
    ROBOSIM_NO_HANDLER("TIMER2_OVF_vect"),
    ROBOSIM_NO_HANDLER("TIMER1_CAPT_vect"),
    ROBOSIM_NO_HANDLER("TIMER1_COMPA_vect"),
    ROBOSIM_NO_HANDLER("TIMER1_COMPB_vect"),
    ROBOSIM_NO_HANDLER("TIMER1_OVF_vect"),
    ROBOSIM_NO_HANDLER("TIMER0_COMPA_vect"),
    ROBOSIM_NO_HANDLER("TIMER0_COMPB_vect"),
    "",
    ROBOSIM_NO_HANDLER("SPI_STC_vect"),
    "",
    ROBOSIM_NO_HANDLER("USART_UDRE_vect"),
    ROBOSIM_NO_HANDLER("USART_TX_vect"),
    ROBOSIM_NO_HANDLER("ADC_vect"),
    ROBOSIM_NO_HANDLER("EE_READY_vect"),
    ROBOSIM_NO_HANDLER("ANALOG_COMP_vect"),
    ROBOSIM_NO_HANDLER("TWI_vect"),
};

using Handler = void (*)();

Handler handler_of(int vector) {
  switch (vector) {
    case 1:
      return __vector_1;
    case 2:
      return __vector_2;
    case 3:
      return __vector_3;
    case 4:
      return __vector_4;
    case 5:
      return __vector_5;
    case 6:
      return __vector_6;
    case 7:
      return __vector_7;
    case 8:
      return __vector_8;
    case 9:
      return __vector_9;
    case 10:
      return __vector_10;
    case 11:
      return __vector_11;
    case 12:
      return __vector_12;
    case 13:
      return __vector_13;
    case 14:
      return __vector_14;
    case 15:
      return __vector_15;
    case 16:
      return __vector_16;
    case 17:
      return __vector_17;
    case 18:
      return __vector_18;
    case 19:
      return __vector_19;
    case 20:
      return __vector_20;
    case 21:
      return __vector_21;
    case 22:
      return __vector_22;
    case 23:
      return __vector_23;
    case 24:
      return __vector_24;
    case kLines:
      return robosim_serve_line;
    default:
      return nullptr;
  }
}

uint32_t pending_timer(const Timer& timer, int first_vector) {
  const uint32_t raised = timer.pending();
  return ((raised & Timer::compare_a) >> 1 | (raised & Timer::compare_b) >> 1 |
          (raised & Timer::overflow) << 2)
             << first_vector |
         (raised & Timer::captured ? 1u << kTimer1Captured : 0u);
}

void acknowledge_timer(Timer& timer, int offset) {
  timer.acknowledge(offset == 0 ? Timer::compare_a : offset == 1 ? Timer::compare_b : Timer::overflow);
}

void acknowledge(int vector) {
  constexpr int kOfTimer = 3;
  if (vector < kPinChange0 + kChip.change_count) {
    acknowledge_external(vector);
  } else if (vector == kWatchdog) {
    watchdog.acknowledge();
  } else if (vector >= kTimer2 && vector < kTimer2 + kOfTimer) {
    acknowledge_timer(timer2, vector - kTimer2);
  } else if (vector == kTimer1Captured) {
    timer1.acknowledge(Timer::captured);
  } else if (vector >= kTimer1 && vector < kTimer1 + kOfTimer) {
    acknowledge_timer(timer1, vector - kTimer1);
  } else if (vector >= kTimer0 && vector < kTimer0 + kOfTimer) {
    acknowledge_timer(timer0, vector - kTimer0);
  } else if (vector == kUartSent) {
    uart.acknowledge_sent();
  } else if (vector == kAdcComplete) {
    adc.acknowledge();
  } else if (vector == kSpi) {
    spi.acknowledge();
  } else if (vector == kCompared) {
    comparator.acknowledge();
  }
}

SimTime earlier(SimTime a, SimTime b) { return a < b ? a : b; }

__attribute__((noinline)) void sync_rare() {
  comparator.sync();
  spi.sync();
  two_wire.sync();
}

__attribute__((noinline)) uint32_t pending_rare() {
  return (spi.pending() ? 1u << kSpi : 0u) | (eeprom.pending() ? 1u << kEepromReady : 0u) |
         (comparator.pending() ? 1u << kCompared : 0u) | (two_wire.pending() ? 1u << kTwoWire : 0u);
}

__attribute__((noinline)) SimTime next_rare() {
  return earlier(earlier(eeprom.next(), comparator.due()), earlier(spi.next(), two_wire.next()));
}

}  // namespace

void take_inputs() {
  Input input;
  while (state.next_input <= state.now && executor->take_input(state.now, input)) {
    if (input.kind == Input::Kind::edge) {
      external_edge(input.pin, input.value, input.at);
    } else {
      uart.receive(input.value);
    }
  }
}

void sync_peripherals() {
  state.touched = true;
  sync_waves();
  timer0.sync();
  timer1.sync();
  timer2.sync();
  adc.sync();
  if (__builtin_expect(rare_used, 0)) sync_rare();
  watchdog.sync();
  sync_tone();
  take_inputs();
}

uint32_t pending_interrupts() {
  uint32_t pending = pending_external() | uart.pending();
  // Usually no timer has raised a flag.
  if (timer0.pending() | timer1.pending() | timer2.pending())
    pending |=
        pending_timer(timer0, kTimer0) | pending_timer(timer1, kTimer1) | pending_timer(timer2, kTimer2);
  if (adc.pending()) pending |= 1u << kAdcComplete;
  if (watchdog.pending()) pending |= 1u << kWatchdog;
  return __builtin_expect(rare_used, 0) ? pending | pending_rare() : pending;
}

SimTime next_interrupt(bool with_timer0_overflow) {
  SimTime next = earlier(state.next_input, earlier(uart.next(), adc.next()));
  if (__builtin_expect(rare_used, 0)) next = earlier(next, next_rare());
  next = earlier(next, watchdog.due());
  next = earlier(next, with_timer0_overflow ? timer0.due() : timer0.due_to_match());
  return earlier(earlier(next, wave_due), earlier(timer1.due(), timer2.due()));
}

SimTime next_alone() {
  if (rare_used || adc.converts() || uart.sends_by_interrupt()) return 0;
  if (timer0.pending() | timer1.pending() | timer2.pending() | uart.pending() | pending_external()) return 0;
  if (watchdog.pending() || adc.pending()) return 0;
  SimTime next = earlier(earlier(state.next_input, watchdog.due()), earlier(tone_end, wave_due));
  return earlier(next, earlier(timer0.due_to_match(), earlier(timer1.due(), timer2.due())));
}

bool may_interrupt(bool held_back) {
  if (watchdog.may_bite()) return true;
  if (!held_back && !interrupts_enabled()) return false;
  const bool by_timer = timer0.enabled() & ~Timer::overflow || timer1.enabled() || timer2.enabled();
  if (spi.may_interrupt() || two_wire.may_interrupt() || watchdog.may_interrupt()) return true;
  if (eeprom.may_interrupt() || comparator.may_interrupt()) return true;
  return by_timer || uart.may_interrupt() || external_may_interrupt() || adc.may_interrupt() || sounds();
}

bool serve_interrupt() {
  if (!interrupts_enabled()) return false;
  const uint32_t pending = pending_interrupts();
  if (!pending) return false;
  const int vector = __builtin_ctz(pending);
  const Handler handler = handler_of(vector);
  if (!handler) {
    executor->crash(kNoHandler[vector], nullptr, 0, state.place);
    __builtin_unreachable();
  }
  acknowledge(vector);
  status_register &= static_cast<uint8_t>(~kI);
  ++handler_depth;
  ++handlers_run;
  if (vector != kTimer0Overflow) leave_round();
  if (vector != kTimer0Overflow) state.now += cycles(cost::kInterrupt);
  refresh_deadline();
  const void* const place = state.place;  // a verdict names the place of the call that the handler interrupts
  handler();
  state.place = place;
  settle_registers();
  --handler_depth;
  status_register |= kI;
  return true;
}

}  // namespace host
}  // namespace robosim
