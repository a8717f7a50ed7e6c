#include "sim/campaign/wiring/pin_facts.h"

#include <algorithm>
#include <cmath>

namespace robosim::wiring {
namespace {

constexpr std::int64_t kLongestPulse_ns = 3'000'000;
constexpr std::size_t kMostChanges = 1'000'000;

}  // namespace

void PinHistory::begin() {
  changes_.clear();
  raised_.clear();
  lowered_.clear();
  end_ns_ = 0;
}

void PinHistory::add(const wire::Event& event) {
  const auto pin_of = [&](const std::string& name) {
    const Pin pin = find_pin(board_, name.c_str());
    return pin == kNoPin ? kNoPin : first_number(board_, pin);
  };
  if (const auto* change = std::get_if<wire::PinChange>(&event)) {
    const Pin pin = pin_of(change->pin);
    if (pin == kNoPin) return;
    PinFacts& facts = facts_[pin];
    const bool output = change->mode == "output";
    const double duty = !output ? 0.0 : change->pwm ? change->duty : change->level ? 1.0 : 0.0;
    facts.driven |= output;
    facts.pwm |= output && change->pwm;
    facts.toned |= change->tone_hz > 0;
    facts.pulled_up |= change->mode == "input_pullup";
    if (output && !change->pwm && change->level) raised_[pin] = change->t_ns;
    if (output && !change->pwm && !change->level && raised_.count(pin) != 0 &&
        change->t_ns - raised_[pin] < kLongestPulse_ns)
      facts.pulses = true;
    if (!output && raised_.count(pin) != 0) lowered_[pin] = change->t_ns;
    if (changes_.size() < kMostChanges) changes_.push_back({change->t_ns, pin, duty});
    end_ns_ = std::max(end_ns_, change->t_ns);
  } else if (const auto* level = std::get_if<wire::LevelSeen>(&event)) {
    const Pin pin = pin_of(level->pin);
    if (pin == kNoPin) return;
    if (level->t_ns != read_ns_) settle_reads();
    read_ns_ = level->t_ns;
    read_together_.push_back(pin);
    const auto lowered = lowered_.find(pin);
    if (lowered != lowered_.end() && level->t_ns - lowered->second < kLongestPulse_ns)
      facts_[pin].discharged = true;
  } else if (const auto* volts = std::get_if<wire::VoltsSeen>(&event)) {
    const Pin pin = pin_of(volts->pin);
    if (pin != kNoPin) facts_[pin].measured = true;
  }
}

void PinHistory::end(std::int64_t t_ns) {
  settle_reads();
  end_ns_ = std::max(end_ns_, t_ns);
}

void PinHistory::settle_reads() {
  for (const Pin pin : read_together_)
    (read_together_.size() == 1 ? facts_[pin].looked : facts_[pin].looked_along) = true;
  read_together_.clear();
}

double PinHistory::mean(Pin enable, Pin high, Pin low, bool absolute) const {
  double enabled = enable == kNoPin ? 1.0 : 0.0, up = 0.0, down = low == kNoPin ? 0.5 : 0.0, sum = 0.0;
  std::int64_t since = 0;
  const auto pass = [&](std::int64_t until) {
    const double drive = enabled * (up - down);
    sum += static_cast<double>(until - since) * (absolute ? std::abs(drive) : drive);
    since = until;
  };
  for (const Change& change : changes_) {
    if (change.pin != enable && change.pin != high && change.pin != low) continue;
    pass(change.t_ns);
    if (change.pin == enable) enabled = change.duty;
    if (change.pin == high) up = change.duty;
    if (change.pin == low) down = change.duty;
  }
  pass(end_ns_);
  return end_ns_ > 0 ? sum / static_cast<double>(end_ns_) : 0.0;
}

}  // namespace robosim::wiring
