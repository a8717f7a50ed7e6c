// Detects what was lost while interrupts were off, or while another handler ran.
//
// The chip remembers that an interrupt was requested, not how often. A second request before the handler runs
// is lost for good:
//
//   an edge at a pin of attachInterrupt()   the encoder's count is too low, the robot turns too far
//   a received byte, after three others     a message without its middle
//   an overflow of timer 0                  millis() loses 1.024 ms: delay() and timeouts take longer
//
// Counts the actual losses, with the place that delayed the handler. That is a section between noInterrupts()
// and interrupts(), or another slow handler: one that prints, waits, or computes with floats. An encoder with
// 1200 edges per second needs its handler within 0.8 ms; bytes at 115200 within 0.26 ms.
//
// Not detected: edges at pin change interrupts, which several pins share; matches of the other timers. Nor
// bytes that did not fit in Serial's buffer of 64, and ticks in runs that sleep, or change timer 0.
//
// Fix it by disabling interrupts only to copy a number, and by handlers that record and return: loop() does
// the work.
// work is loop()'s.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "sim/exec/avr/detect/detector.h"
#include "sim/exec/avr/machine.h"
#include "sim/exec/elf/debug_info.h"

namespace robosim::exec::avr {

class MissedInterrupts final : public Detector {
 public:
  /// `counted`: pins of the board of which each edge counts, such as an encoder's.
  MissedInterrupts(Machine& machine, const Firmware& firmware, const DebugInfo& debug, WhereNow where,
                   const std::vector<Pin>& counted);
  ~MissedInterrupts() override;
  MissedInterrupts(const MissedInterrupts&) = delete;
  MissedInterrupts& operator=(const MissedInterrupts&) = delete;

  void entered(int vector, Cycle at) override;
  std::vector<Detected> found() const override { return seen_.all(); }

 private:
  void lost(int vector);
  void ticks_lost(std::int64_t ticks, Cycle at);
  void see(const char* detector, const std::string& what, const SourceLine& where, std::int64_t times);
  std::string held_off() const;
  Cycle tick() const;

  Machine& machine_;
  const DebugInfo& debug_;
  const WhereNow where_;
  const robosim::avr::Cpu& cpu_;
  const TimerSpec& timer_;
  std::map<int, Pin> pins_;                                     ///< by vector
  std::map<std::pair<int, std::uint32_t>, SourceLine> places_;  ///< by vector and place in the code
  Cycle flagged_ = 0;  ///< last overflow of timer 0, or a little earlier; 0 = unknown
  Cycle period_ = 0, slept_ = 0, bitten_ = 0;
  Sightings seen_;
};

}  // namespace robosim::exec::avr
