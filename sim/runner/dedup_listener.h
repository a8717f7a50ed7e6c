// Removes the repeated reports of a run that goes back in time, before they reach the listener. A repeated
// run makes the same reports in the same order, so counting them is enough.
#pragma once

#include <cstdint>

#include "sim/run/simulation.h"

namespace robosim::runner {

class DedupListener final : public run::Listener {
 public:
  explicit DedupListener(run::Listener& listener) : listener_(listener) {}

  /// Returns the number of reports up to the run's present time.
  std::uint64_t count() const { return count_; }
  /// Records that the run is again at the time when it had made `count` reports.
  void go_back(std::uint64_t count) { count_ = count; }
  /// Returns whether the run is at its latest report.
  bool is_at_front() const { return count_ == most_; }

  void began(const run::Beginning& beginning) override {
    if (is_new()) listener_.began(beginning);
  }
  void sampled(const run::Sample& sample) override {
    if (is_new()) listener_.sampled(sample);
  }
  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override {
    if (is_new()) listener_.pin_changed(pin, drive, t);
  }
  void byte_sent(std::uint8_t byte, SimTime t) override {
    if (is_new()) listener_.byte_sent(byte, t);
  }
  bool wants_inputs() const override { return listener_.wants_inputs(); }
  void level_seen(Pin pin, bool level, SimTime t) override {
    if (is_new()) listener_.level_seen(pin, level, t);
  }
  void volts_seen(Pin pin, double volts, SimTime t) override {
    if (is_new()) listener_.volts_seen(pin, volts, t);
  }
  void byte_received(std::uint8_t byte, SimTime t) override {
    if (is_new()) listener_.byte_received(byte, t);
  }
  bool minds_turns() const override { return listener_.minds_turns(); }
  void happened(const result::RunEvent& event) override {
    if (is_new()) listener_.happened(event);
  }

 private:
  bool is_new() {
    if (++count_ <= most_) return false;
    most_ = count_;
    return true;
  }

  run::Listener& listener_;
  std::uint64_t count_ = 0, most_ = 0;
};

}  // namespace robosim::runner
