// Decodes the registers of an AVR's timers: how a timer counts, and how it drives its pins (ATmega328P, data
// sheet DS40002061B: timer 0 in chapter 15, timer 1 in 16, timer 2 in 18). The target host and the emulated
// chip use these functions.
//
//   tick                `prescaler` cycles of the processor
//   period              TOP + 1 ticks, or 2 TOP if the timer counts up and down (phase correct)
//   fast PWM            high for OCR + 1 of TOP + 1 ticks
//   phase correct PWM   high for OCR of TOP ticks
//   COM = 1             toggles at each match, once per period: high half the time. In PWM modes,
//                       only OCnA can toggle, and only if TOP is OCRnA, or ICRn in a mode with a single
//                       slope
#pragma once

#include <stdint.h>

#include "hal/board/board.h"
#include "hal/board/chip_spec.h"

namespace robosim {
namespace avr {

/// Returns the prescaler that TCCRnB selects (tables 15-9, 16-5, 18-9). Returns 0 if the timer is stopped or
/// counts an external clock. For an ATtiny85's timer 1, `control_b` has the bits CS13 to CS10 (2586Q, table
/// 12-5).
constexpr int32_t prescaler(const TimerSpec& timer, uint8_t control_b) {
  return !timer.top ? timer.prescalers[control_b & 7] : (control_b & 0xF) ? 1 << ((control_b & 0xF) - 1) : 0;
}

/// A timer's counting mode.
struct Counting {
  enum class Kind : uint8_t { normal, clear_on_match, pwm };
  enum class Top : uint8_t { fixed, compare_a, capture };  ///< source of TOP

  Kind kind = Kind::normal;
  bool dual_slope = false;  ///< counts up and down: phase correct, phase and frequency correct
  Top top = Top::fixed;
  uint16_t fixed_top = 0xFF;       ///< the value of TOP if `top` is `fixed`
  bool frequency_correct = false;  ///< with dual slope: OCRnx is updated at BOTTOM, not at TOP
  bool short_pulse = false;        ///< fast PWM: high for OCR ticks, not OCR + 1; always high if OCR is TOP
};

/// Returns the mode that WGM in TCCRnA and TCCRnB selects (tables 15-8, 16-4, 18-8). Reserved modes count as
/// normal mode. The comment before each row is the mode's number in these tables. An ATtiny85's timer 1 has
/// other modes (data sheet 2586Q, 12.2 and 12.3): mode 0 is normal. Mode 2 clears on a match with OCR1C. Mode
/// 3 is PWM up to OCR1C.
constexpr Counting counting(const TimerSpec& timer, uint8_t control_a, uint8_t control_b) {
  using Kind = Counting::Kind;
  using Top = Counting::Top;
  constexpr Counting kOfByte[8] = {/*0*/ {Kind::normal, false, Top::fixed, 0xFF},
                                   /*1*/ {Kind::pwm, true, Top::fixed, 0xFF},
                                   /*2*/ {Kind::clear_on_match, false, Top::compare_a, 0xFF},
                                   /*3*/ {Kind::pwm, false, Top::fixed, 0xFF},
                                   /*4*/ {Kind::normal, false, Top::fixed, 0xFF},
                                   /*5*/ {Kind::pwm, true, Top::compare_a, 0xFF},
                                   /*6*/ {Kind::normal, false, Top::fixed, 0xFF},
                                   /*7*/ {Kind::pwm, false, Top::compare_a, 0xFF}};
  constexpr Counting kOfWord[16] = {/*0*/ {Kind::normal, false, Top::fixed, 0xFFFF},
                                    /*1*/ {Kind::pwm, true, Top::fixed, 0xFF},
                                    /*2*/ {Kind::pwm, true, Top::fixed, 0x1FF},
                                    /*3*/ {Kind::pwm, true, Top::fixed, 0x3FF},
                                    /*4*/ {Kind::clear_on_match, false, Top::compare_a, 0xFFFF},
                                    /*5*/ {Kind::pwm, false, Top::fixed, 0xFF},
                                    /*6*/ {Kind::pwm, false, Top::fixed, 0x1FF},
                                    /*7*/ {Kind::pwm, false, Top::fixed, 0x3FF},
                                    /*8*/ {Kind::pwm, true, Top::capture, 0xFFFF, true},
                                    /*9*/ {Kind::pwm, true, Top::compare_a, 0xFFFF, true},
                                    /*10*/ {Kind::pwm, true, Top::capture, 0xFFFF},
                                    /*11*/ {Kind::pwm, true, Top::compare_a, 0xFFFF},
                                    /*12*/ {Kind::clear_on_match, false, Top::capture, 0xFFFF},
                                    /*13*/ {Kind::normal, false, Top::fixed, 0xFFFF},
                                    /*14*/ {Kind::pwm, false, Top::capture, 0xFFFF},
                                    /*15*/ {Kind::pwm, false, Top::compare_a, 0xFFFF}};
  constexpr Counting kWithTop[4] = {/*0*/ {Kind::normal, false, Top::fixed, 0xFF},
                                    /*1*/ {Kind::normal, false, Top::fixed, 0xFF},
                                    /*2*/ {Kind::clear_on_match, false, Top::capture, 0xFF},
                                    /*3*/ {Kind::pwm, false, Top::capture, 0xFF, false, true}};
  if (timer.top) return kWithTop[control_a & 3];
  return timer.bits == 16 ? kOfWord[(control_a & 3) | (control_b >> 1 & 0xC)]
                          : kOfByte[(control_a & 3) | (control_b >> 1 & 4)];
}

/// Returns TOP, given OCRnA and (for a 16-bit timer) ICRn.
constexpr int64_t top_of(const Counting& how, uint16_t compare_a, uint16_t capture) {
  return how.top == Counting::Top::compare_a ? compare_a
         : how.top == Counting::Top::capture ? capture
                                             : how.fixed_top;
}

/// Returns the number of ticks from one overflow to the next.
constexpr int64_t period_of(const Counting& how, int64_t top) {
  return !how.dual_slope ? top + 1 : top > 0 ? 2 * top : 1;
}

/// Returns the bits COM of channel 0 (A), 1 (B) or 2 (C) in TCCRnA. 0 means that the port drives the pin.
constexpr uint8_t connection(uint8_t control_a, int channel) { return control_a >> (6 - 2 * channel) & 3; }

/// Returns whether a timer drives a channel's pin when DDRx makes the pin an output. In PWM modes, COM = 1
/// connects only OCnA, and only in some modes (see the start of this file).
constexpr bool drives_pin(const Counting& how, uint8_t com, int channel) {
  return com != 1 ? com != 0
                  : how.kind != Counting::Kind::pwm ||
                        (channel == 0 && (how.top == Counting::Top::compare_a ||
                                          (how.top == Counting::Top::capture && !how.dual_slope)));
}

/// Returns the level of a pin with PWM (COM is 2 or 3) at a tick of the period, which begins at BOTTOM.
constexpr bool pwm_level(const Counting& how, int64_t top, uint16_t compare, uint8_t com, int64_t tick) {
  const bool low = how.dual_slope && compare == 0;
  const bool high =
      !low && (compare >= top || tick <= compare || (how.dual_slope && tick > 2 * top - compare));
  return high != (com == 3);
}

/// Returns how a timer drives the pin of a channel whose bits COM are `com` (1 to 3). `compare` is the
/// channel's OCRnx. Tables 15-2 to 15-7, 16-1 to 16-3, 18-2 to 18-7.
inline PinDrive timer_drive(const Counting& how, int32_t prescaler, int64_t top, uint16_t compare,
                            uint8_t com, int64_t clock_hz) {
  PinDrive drive = PinDrive::constant(false);
  if (prescaler == 0) return drive;
  if (com == 1) {
    drive.pwm = true;
    drive.duty = 0.5;
    drive.tone_hz = static_cast<uint32_t>(clock_hz / (2 * prescaler * period_of(how, top)));
    return drive;
  }
  if (how.kind != Counting::Kind::pwm) return PinDrive::constant(com == 3);
  const int64_t value = compare < top ? compare : top;
  const bool longer = !how.short_pulse || value == top;
  const double high = how.dual_slope
                          ? (top > 0 ? static_cast<double>(value) / static_cast<double>(top) : 0.0)
                          : static_cast<double>(value + (longer ? 1 : 0)) / static_cast<double>(top + 1);
  drive.pwm = true;
  drive.duty = com == 3 ? 1.0 - high : high;
  drive.period_us = static_cast<uint32_t>(1000000 * prescaler * period_of(how, top) / clock_hz);
  return drive;
}

}  // namespace avr
}  // namespace robosim
