// Detects events that were lost while interrupts were off, or while another handler ran.
//
// The chip stores whether an interrupt was requested, but not how many times. If a second request arrives
// before the handler has started, the second request is lost:
//
//   an edge at a pin of attachInterrupt()   the encoder's count is too low, and the robot turns too far
//   a fourth unread byte                    the middle of a message is missing
//   an overflow of timer 0                  millis() loses 1.024 ms: delay() and timeouts take longer
//
// The detector counts the events that were lost. It reports the code that delayed the handler: a section
// between noInterrupts() and interrupts(), or another slow handler. Slow handlers print, wait, or compute
// with floats. For an encoder with 1200 edges per second, the handler must start within 0.8 ms. For bytes at
// 115200 baud, the handler must start within 0.26 ms.
//
// Not detected: edges at pin change interrupts, which several pins share; matches of other timers; bytes that
// did not fit in Serial's buffer of 64 bytes. Overflows of timer 0 are not examined while the chip sleeps or
// the sketch changes the mode of timer 0.
//
// To fix the sketch, disable interrupts only while a number is copied. A handler should only record its event
// and return, and leave the work to loop().
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "sim/detect/avr/chip_detector.h"

namespace robosim::detect::avr {

class MissedInterrupts final : public ChipDetector {
 public:
  /// `counted` lists the board's pins whose edges are all relevant, such as those of an encoder.
  MissedInterrupts(const RunningProgram& program, const std::vector<Pin>& counted);
  ~MissedInterrupts() override;
  MissedInterrupts(const MissedInterrupts&) = delete;
  MissedInterrupts& operator=(const MissedInterrupts&) = delete;

  void entered(int vector, Cycle at) override;
  std::vector<Detected> found(SimTime) const override { return seen_.all(); }

 private:
  void lost(int vector);
  void ticks_lost(std::int64_t ticks, Cycle at);
  void see(const char* detector, const std::string& what, const SourceLine& where, std::int64_t times);
  std::string held_off() const;
  Cycle tick() const;

  const RunningProgram program_;
  Machine& machine_;
  const robosim::avr::Cpu& cpu_;
  const TimerSpec& timer_;
  std::map<int, Pin> pins_;                                     ///< by interrupt vector
  std::map<std::pair<int, std::uint32_t>, SourceLine> places_;  ///< by interrupt vector and flash address
  Cycle flagged_ = 0;  ///< estimated cycle of timer 0's last overflow, slightly late; 0 = unknown
  Cycle period_ = 0, slept_ = 0, bitten_ = 0;
  Sightings seen_;
};

}  // namespace robosim::detect::avr
