// What every call of the Arduino API costs on an ATmega328P at 16 MHz, in CPU cycles (62.5 ns). The one table
// of it.
#pragma once

#include <stdint.h>

#include "hal/board/sim_time.h"

namespace robosim {
namespace host {

constexpr int64_t kClockHz = 16000000;

/// Nanoseconds of so many CPU cycles.
constexpr SimTime cycles(int64_t count) { return count * 125 / 2; }

namespace cost {

constexpr int kBlock = 10;
constexpr int kLoop = 10;
constexpr int kInit = 60;
constexpr int kPinMode = 70;
constexpr int kDigitalWrite = 58;
constexpr int kDigitalRead = 54;
constexpr int kAnalogWrite = 110;
constexpr int kAnalogRead = 40;
constexpr int kMillis = 26;
constexpr int kMicros = 50;
constexpr int kDelayEnd = 50;
constexpr int kDelayPoll = 20;
constexpr int kInterrupt = 40;
constexpr int kTimer0Overflow = 90;
constexpr int kAttachInterrupt = 40;
constexpr int kTone = 2000;
constexpr int kNoTone = 80;
constexpr int kRandom = 1400;
constexpr int kDivide = 600;
constexpr int kMap = 700;
constexpr int kSerialBegin = 1200;
constexpr int kSerialWrite = 120;
constexpr int kSerialTransmitHandler = 80;
constexpr int kSerialReceiveHandler = 90;
constexpr int kSerialRead = 40;
constexpr int kSerialAvailable = 30;
constexpr int kShiftOutBit = 150;
constexpr int kShiftInBit = 100;
constexpr int kPulseLoop = 16;
constexpr int kRegister = 2;
constexpr int kEepromAccess = 20;
constexpr int kAllocate = 100;

}  // namespace cost
}  // namespace host
}  // namespace robosim
