// Implements analogRead() by ADC1 (RM0008 11), and analogWrite() by timers 1, 3 and 4 (14.3.10, 15.3.9).
#include <Arduino.h>

#include "hal/arduino/resolution.h"
#include "hal/stm32/clock.h"
#include "hal/stm32/pins.h"

using namespace robosim::stm32;

namespace {

// The ADC samples for 28.5 cycles (RM0008 11.12.5). A source of 10 kohm is then allowed: the limit at 14 MHz
// is 25 kohm (DS5319, table 47).
constexpr uint32_t kSampleTime = 3;

void start_adc() {
  at(kRccApb2Enr) |= kAdc1En;
  at(kAdcCr2) = kAdOn | kExtSelSw | kExtTrig;  // wakes the ADC up (11.3.1)
  delayMicroseconds(1);                        // tSTAB (DS5319, table 46)
  at(kAdcCr2) |= kRstCal;
  at(kAdcCr2).await(kRstCal, 0);
  at(kAdcCr2) |= kCal;  // 11.4
  at(kAdcCr2).await(kCal, 0);
  uint32_t all = 0;
  for (int channel = 0; channel < 10; ++channel) all |= kSampleTime << (3 * channel);
  at(kAdcSmpr2) = all;
}

Address timer_base(uint8_t timer) { return timer == 1 ? kTim1 : timer == 3 ? kTim3 : kTim4; }

// PWM has 255 steps, as on an Uno, at about 1000 Hz.
constexpr uint32_t kPwmSteps = 255, kPwmHz = 1000;
constexpr uint32_t kPwmPrescaler = F_CPU / (kPwmSteps * kPwmHz);

void start_pwm(const PinMap& pin, Address timer) {
  if (pin.timer == 1) {
    at(kRccApb2Enr) |= kTim1En;
    at(kTim1 + kTimBdtr) = kMoe;
  } else {
    at(kRccApb1Enr) |= pin.timer == 3 ? kTim3En : kTim4En;
  }
  if (!(load(timer + kTimCr1) & kCen)) {
    at(timer + kTimPsc) = kPwmPrescaler - 1;
    at(timer + kTimArr) = kPwmSteps - 1;
    at(timer + kTimEgr) = kUg;
    at(timer + kTimCr1) = kArpe | kCen;
  }
  const uint32_t output = pin.output - 1u;
  const uint32_t shift = 8 * (output % 2);
  at(timer + (output < 2 ? kTimCcmr1 : kTimCcmr2)).set(0xFFu << shift, (kPwmMode1 | kPreload) << shift);
  at(timer + kTimCcer) |= 1u << (4 * output);
}

constexpr int kAdcBits = 12, kPwmBits = 8;

}  // namespace

extern "C" {

/// Does nothing: a Blue Pill's reference is always its supply, 3.3 V.
void analogReference(uint8_t) {}

int analogRead(uint8_t number) {
  if (number < NUM_ANALOG_INPUTS) number = static_cast<uint8_t>(number + PIN_A0);
  const PinMap* pin = pin_at(number);
  if (!pin || pin->channel < 0) return 0;
  if (!(load(kAdcCr2) & kAdOn)) start_adc();
  if (configuration(*pin) != kAnalog) configure(*pin, kAnalog);
  at(kAdcSqr3) = static_cast<uint32_t>(pin->channel);
  at(kAdcCr2) |= kSwStart;
  at(kAdcSr).await(kEoc, kEoc);
  return robosim_hal::with_bits(static_cast<int>(load(kAdcDr)), kAdcBits, robosim_hal::read_bits);
}

void analogWrite(uint8_t number, int given) {
  const PinMap* pin = pin_at(number);
  if (!pin) return;
  const uint32_t value =
      given < 0 ? 0 : static_cast<uint32_t>(robosim_hal::with_bits(given, robosim_hal::write_bits, kPwmBits));
  if (pin->timer == 0) {
    pinMode(number, OUTPUT);
    return digitalWrite(number, value < 128 ? LOW : HIGH);
  }
  const Address timer = timer_base(pin->timer);
  const uint32_t compare = value > kPwmSteps ? kPwmSteps : value;
  const bool runs = configuration(*pin) == kAlternate;
  if (!runs) start_pwm(*pin, timer);  // before the write, which a timer without a clock ignores
  at(timer + kTimCcr1 + 4u * (pin->output - 1u)) = compare;
  if (!runs) configure(*pin, kAlternate);
}

}  // extern "C"
