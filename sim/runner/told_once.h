// Between a run that goes back in time and who listens to it: what is told again is left out. Equal runs tell
// the same in the same order, so it is enough to count.
#pragma once

#include <cstdint>

#include "sim/run/simulation.h"

namespace robosim::runner {

class ToldOnce final : public run::Listener {
 public:
  explicit ToldOnce(run::Listener& listener) : listener_(listener) {}

  /// What the run has told since it began, as it would be without going back.
  std::uint64_t count() const { return count_; }
  /// The run is again where it had told so much.
  void go_back(std::uint64_t count) { count_ = count; }
  /// Whether nothing that has been told lies ahead.
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
  void happened(const wire::RunEvent& event) override {
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
