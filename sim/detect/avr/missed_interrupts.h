// Detects events that were lost while interrupts were off, or while another handler ran.
//
// The chip stores whether an interrupt was requested, not the number of requests. A second request before the
// handler runs is lost:
//
//   an edge at a pin of attachInterrupt()   the encoder's count is too low, and the robot turns too far
//   a fourth unread byte                    the middle of a message is missing
//   an overflow of timer 0                  millis() loses 1.024 ms: delay() and timeouts take longer
//
// Counts the actual losses. Reports the place that delayed the handler: a section between noInterrupts() and
// interrupts(), or another slow handler. Slow handlers print, wait, or compute with floats. An encoder with
// 1200 edges per second needs its handler within 0.8 ms; bytes at 115200 baud within 0.26 ms.
//
// Not detected: edges at pin change interrupts, which several pins share; matches of other timers; bytes that
// did not fit in Serial's buffer of 64 bytes; ticks in runs that sleep or change timer 0.
//
// To fix the sketch, disable interrupts only to copy a number. Handlers should only record an event and
// return; loop() does the work.
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
  std::map<int, Pin> pins_;                                     ///< by vector
  std::map<std::pair<int, std::uint32_t>, SourceLine> places_;  ///< by vector and place
  Cycle flagged_ = 0;  ///< cycle of the last overflow of timer 0, or slightly earlier; 0 = unknown
  Cycle period_ = 0, slept_ = 0, bitten_ = 0;
  Sightings seen_;
};

}  // namespace robosim::detect::avr
