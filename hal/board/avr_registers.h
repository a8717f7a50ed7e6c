// Addresses of the ATmega328P's registers in data memory (data sheet DS40002061B, chapter 36), for the host
// target and for the emulated chip.
#pragma once

#include <stdint.h>

namespace robosim {
namespace avr {
namespace reg {

using Address = uint16_t;

constexpr Address kPinB = 0x23, kDdrB = 0x24, kPortB = 0x25;  // C and D follow, three registers each
constexpr Address kPortD = 0x2B;
constexpr Address kTifr0 = 0x35, kTifr2 = 0x37, kPcifr = 0x3B, kEifr = 0x3C, kEimsk = 0x3D;
constexpr Address kEecr = 0x3F, kEearL = 0x41, kEearH = 0x42;
constexpr Address kTccr0a = 0x44, kTccr0b = 0x45, kTcnt0 = 0x46, kOcr0a = 0x47, kOcr0b = 0x48;
constexpr Address kSmcr = 0x53, kMcusr = 0x54, kSpmcsr = 0x57;
constexpr Address kSpL = 0x5D, kSpH = 0x5E, kSreg = 0x5F;
constexpr Address kWdtcsr = 0x60, kPrr = 0x64, kPcicr = 0x68, kEicra = 0x69;
constexpr Address kPcmsk0 = 0x6B, kPcmsk1 = 0x6C, kPcmsk2 = 0x6D;
constexpr Address kTimsk0 = 0x6E, kTimsk1 = 0x6F, kTimsk2 = 0x70;
constexpr Address kAdcL = 0x78, kAdcH = 0x79, kAdcsra = 0x7A, kAdcsrb = 0x7B, kAdmux = 0x7C;
constexpr Address kTccr1a = 0x80, kTccr1b = 0x81, kTcnt1L = 0x84, kIcr1L = 0x86, kOcr1aL = 0x88,
                  kOcr1bL = 0x8A;
constexpr Address kTccr2a = 0xB0, kTccr2b = 0xB1, kTcnt2 = 0xB2, kOcr2a = 0xB3, kOcr2b = 0xB4;
constexpr Address kUcsra = 0xC0, kUcsrb = 0xC1, kUcsrc = 0xC2, kUbrrL = 0xC4, kUbrrH = 0xC5, kUdr = 0xC6;

constexpr Address kFirstIo = 0x20;  ///< below are the 32 registers of the processor
constexpr Address kFirstRam = 0x100;
constexpr Address kLastRam = 0x8FF;

}  // namespace reg
}  // namespace avr
}  // namespace robosim
