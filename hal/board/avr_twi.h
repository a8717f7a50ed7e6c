// Models an AVR's two-wire interface as bus master (ATmega328P, data sheet DS40002061B, chapter 21), for the
// target host and for the emulated chip.
//
//   step     takes   TWSR afterwards
//   START    T       0x08; 0x10 if repeated
//   byte     9 T     address to write: 0x18, not acknowledged 0x20
//                    address to read: 0x40, not acknowledged 0x48
//                    data sent: 0x28, not acknowledged 0x30
//                    data received: 0x50, or 0x58 if the master does not acknowledge it (TWEA)
//   STOP     T       TWINT stays 0; TWSTO reads 0 again
//
// T = 16 + 2 TWBR 4^TWPS cycles, the duration of one bit (21.5.2). Writing 1 to TWINT clears TWINT and starts
// a step. During the step, TWSR reads 0xF8. At its end, TWINT is set, except after STOP. While TWINT is not
// set, writes to TWDR are ignored (TWWC). TWINT requests the interrupt as long as it is set.
//
// Not modelled: other masters, and devices that hold the clock low.
#pragma once

#include "hal/board/avr_registers.h"

namespace robosim {
namespace avr {

constexpr uint8_t kNoTwiStatus = 0xF8;
constexpr uint8_t kTwdrAtReset = 0xFF, kTwarAtReset = 0xFE;

/// Returns the duration of a bit, in processor cycles, for the registers TWBR and TWSR.
constexpr int64_t twi_bit(uint8_t rate, uint8_t status) {
  return 16 + 2 * (static_cast<int64_t>(rate) << 2 * (status & kTwps));
}

/// The caller stores TWCR and TWDR as `control` and `data`.
class TwiMaster {
 public:
  uint8_t status() const { return status_; }
  /// Returns whether a step is in progress.
  bool runs() const { return step_ != Step::none; }
  /// Returns the duration of the present step, in bits.
  int bits() const { return step_ == Step::byte ? 9 : 1; }

  static void write_data(uint8_t& control, uint8_t& data, uint8_t value) {
    if (control & kTwint) data = value;
    control = static_cast<uint8_t>(control & kTwint ? control & ~kTwwc : control | kTwwc);
  }
  /// Writes TWCR. Returns whether a step begins.
  bool write_control(uint8_t& control, uint8_t value) {
    const int kept = control & (kTwwc | (value & kTwint ? 0 : kTwint));
    control = static_cast<uint8_t>((value & (kTwea | kTwsta | kTwsto | kTwen | kTwie)) | kept);
    if (!(value & kTwen)) *this = TwiMaster();
    if (!(value & kTwen) || control & kTwint || runs()) return false;
    step_ = next(control);
    return runs();
  }
  /// Completes the step, and sets TWINT, except after STOP. Returns whether a START follows the STOP at once.
  /// `bus` has the functions two_wire_address(), two_wire_write(), two_wire_read() and two_wire_stop() of
  /// FirmwarePort.
  template <typename Bus, typename Time>
  bool end(Bus& bus, uint8_t& control, uint8_t& data, Time at) {
    const Step done = step_;
    step_ = Step::none;
    if (done == Step::stop || done == Step::stop_and_start) {
      owns_bus_ = false;
      control &= static_cast<uint8_t>(~kTwsto);
      bus.two_wire_stop(at);
      if (control & kTwsta) step_ = Step::start;
      return runs();
    }
    control |= kTwint;
    if (done == Step::start) {
      status_ = owns_bus_ ? kStartedAgain : kStarted;
      owns_bus_ = true;
    } else if (before_ == kStarted || before_ == kStartedAgain) {
      const bool answered = bus.two_wire_address(data, at);
      status_ = data & 1 ? (answered ? kReadAck : kReadNack) : (answered ? kWriteAck : kWriteNack);
    } else if (before_ == kReadAck || before_ == kReceived) {
      data = bus.two_wire_read(at);
      status_ = control & kTwea ? kReceived : kReceivedLast;
    } else {
      status_ = bus.two_wire_write(data, at) ? kDataAck : kDataNack;
    }
    return false;
  }

 private:
  enum class Step : uint8_t { none, start, byte, stop, stop_and_start };
  // Values of TWSR.
  enum : uint8_t {
    kStarted = 0x08,
    kStartedAgain = 0x10,
    kWriteAck = 0x18,
    kWriteNack = 0x20,
    kDataAck = 0x28,
    kDataNack = 0x30,
    kReadAck = 0x40,
    kReadNack = 0x48,
    kReceived = 0x50,
    kReceivedLast = 0x58
  };

  /// Returns the step that TWCR selects.
  Step next(uint8_t control) {
    before_ = status_;
    status_ = kNoTwiStatus;
    if (control & kTwsto) return control & kTwsta ? Step::stop_and_start : Step::stop;
    if (control & kTwsta) return Step::start;
    const bool transfers = before_ != kNoTwiStatus && before_ != kReadNack && before_ != kReceivedLast;
    return transfers ? Step::byte : Step::none;
  }

  uint8_t status_ = kNoTwiStatus, before_ = kNoTwiStatus;
  Step step_ = Step::none;
  bool owns_bus_ = false;  ///< a START was sent, and no STOP after it
};

}  // namespace avr
}  // namespace robosim
