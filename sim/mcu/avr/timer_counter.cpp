#include "sim/mcu/avr/timer_counter.h"

#include <algorithm>

namespace robosim::avr {
namespace {

// Number of turns or restarts after which every counter is in its regular period. Until then, a counter may
// run on to MAX, adopt a new TOP, and complete two periods.
constexpr int kTurnsUntilRegular = 8;

}  // namespace

void Counter::count(const Counting& how, std::uint16_t max, std::uint8_t channels) {
  how_ = how;
  max_ = max;
  channels_ = channels;
  if (!how.dual_slope) down_ = false;
  if (how.kind != Counting::Kind::pwm) compare_ = written_;
}

void Counter::write_compare(std::size_t channel, std::uint16_t value) {
  written_[channel] = value;
  if (how_.kind != Counting::Kind::pwm) compare_ = written_;
}

std::uint8_t Counter::take_over() {
  if (!waits()) return 0;
  compare_ = written_;
  return kTakenOver;
}

std::uint8_t Counter::tick() {
  const std::uint16_t left = value_, end = top();
  std::uint8_t hits = 0;
  for (std::size_t channel = 0; channel < channels_ && !hidden_; ++channel)
    if (left == compare_[channel]) hits |= kMatch[channel];
  const bool at_top = left == end && !down_ && !(hidden_ && how_.top != Counting::Top::fixed);
  const bool at_bottom = left == 0 && !(hidden_ && down_);
  hidden_ = false;
  if (at_top && how_.top == Counting::Top::capture) hits |= kTop;

  if (how_.dual_slope) {
    if (at_bottom) {
      hits |= kOverflow;
      down_ = false;
    }
    if (how_.frequency_correct ? at_bottom : at_top) hits |= take_over();
    if (at_top && at_bottom) return hits;
    if (at_top) down_ = true;
    value_ = static_cast<std::uint16_t>(down_ ? left - 1 : left + 1) & max_;
    return hits;
  }
  const bool pwm = how_.kind == Counting::Kind::pwm;
  if (pwm ? at_top : left == max_) hits |= kOverflow;
  if (!at_top && left != max_) {
    value_ = static_cast<std::uint16_t>(left + 1);
    return hits;
  }
  value_ = 0;
  return pwm ? hits | take_over() : hits;
}

// Returns the number of ticks until a value at which the counter turns or restarts.
std::uint16_t Counter::straight() const {
  if (hidden_) return 0;
  if (down_) return value_;
  if (how_.dual_slope && value_ == 0) return 0;
  const std::uint16_t end = top();
  return static_cast<std::uint16_t>((value_ <= end ? end : max_) - value_);
}

Counter::Ran Counter::run(Cycle most, std::uint8_t wanted, int turns) {
  Ran ran;
  while (ran.ticks < most && !(ran.hits & wanted)) {
    Cycle ticks = std::min<Cycle>(straight(), most - ran.ticks);
    if (ticks == 0) {
      if (turns-- == 0) break;
      ran.hits |= tick();
      ran.ticks += 1;
      continue;
    }
    std::array<std::uint16_t, 3> distance;
    for (std::size_t channel = 0; channel < channels_; ++channel) {
      const int ahead = compare_[channel] - value_;
      distance[channel] = static_cast<std::uint16_t>(down_ ? -ahead : ahead);
      if (wanted & kMatch[channel]) ticks = std::min<Cycle>(ticks, distance[channel] + Cycle{1});
    }
    for (std::size_t channel = 0; channel < channels_; ++channel)
      if (distance[channel] < ticks) ran.hits |= kMatch[channel];
    const auto by = static_cast<std::uint16_t>(ticks);
    value_ = static_cast<std::uint16_t>(down_ ? value_ - by : value_ + by);
    ran.ticks += ticks;
  }
  return ran;
}

std::uint8_t Counter::advance_regularly(unsigned ticks) {
  const unsigned from = value_, end = top(), to_end = end - from;
  const bool leaves_end = ticks > to_end;
  std::uint8_t hits = 0;
  for (std::size_t channel = 0; channel < channels_; ++channel) {
    const unsigned match = compare_[channel];
    const bool is_ahead = match >= from && match - from < ticks;
    if (match <= end && (is_ahead || (leaves_end && match < ticks - to_end - 1))) hits |= kMatch[channel];
  }
  if (leaves_end) hits |= hits_at_end();
  value_ = static_cast<std::uint16_t>(leaves_end ? ticks - to_end - 1 : from + ticks);
  return hits;
}

std::uint8_t Counter::next_hits() const {
  if (!is_regular()) {
    Counter ahead = *this;
    return ahead.advance(1);
  }
  std::uint8_t hits = value_ == top() ? hits_at_end() : std::uint8_t{0};
  for (std::size_t channel = 0; channel < channels_; ++channel)
    if (compare_[channel] == value_) hits |= kMatch[channel];
  return hits;
}

std::uint8_t Counter::hits_at_end() const {
  const bool overflows = how_.kind == Counting::Kind::pwm || top() == max_;
  return static_cast<std::uint8_t>((overflows ? kOverflow : 0) |
                                   (how_.top == Counting::Top::capture ? kTop : 0));
}

std::uint8_t Counter::advance(Cycle ticks) {
  if (is_regular() && ticks <= top() + Cycle{1}) return advance_regularly(static_cast<unsigned>(ticks));
  std::uint8_t hits = 0;
  if (hidden_ || waits() || value_ > top()) {
    const Ran ran = run(ticks, 0, kTurnsUntilRegular);
    hits |= ran.hits;
    ticks -= ran.ticks;
  }
  const auto period = static_cast<Cycle>(period_of(how_, top()));
  if (ticks > 2 * period) {
    hits |= run(period, 0, kManyTurns).hits;
    ticks = (ticks - period) % period;
  }
  return hits | run(ticks, 0, kManyTurns).hits;
}

Cycle Counter::matches(std::size_t channel, Cycle ticks) const {
  if (is_regular()) {
    const Cycle period = top() + Cycle{1}, match = compare_[channel];
    if (match >= period) return 0;
    const Cycle ahead = match >= value_ ? match - value_ : period - value_ + match;
    return ticks > ahead ? 1 + (ticks - ahead - 1) / period : 0;
  }
  Counter one = *this;
  Cycle count = 0;
  for (Cycle to = one.ticks_to(kMatch[channel]); to <= ticks; to = one.ticks_to(kMatch[channel])) {
    one.advance(to);
    ticks -= to;
    ++count;
  }
  return count;
}

Cycle Counter::ticks_to(std::uint8_t wanted) const {
  if (is_regular()) {
    const unsigned end = top(), to_end = end - value_;
    Cycle ticks = wanted & hits_at_end() ? to_end + Cycle{1} : kNoCycle;
    for (std::size_t channel = 0; channel < channels_; ++channel) {
      const unsigned match = compare_[channel];
      if (!(wanted & kMatch[channel]) || match > end) continue;
      ticks = std::min<Cycle>(ticks, (match >= value_ ? match - value_ : to_end + 1 + match) + Cycle{1});
    }
    return ticks;
  }
  Counter ahead = *this;
  const Ran ran = ahead.run(kNoCycle, wanted, kTurnsUntilRegular);
  return ran.hits & wanted ? ran.ticks : kNoCycle;
}

}  // namespace robosim::avr
