#include "sim/judge/slow_serial.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim::judge {
namespace {

constexpr SimTime kLongWait = 15 * kMillisecond;
constexpr int kMostAsked = 200;  // finding a sketch's activity is slow
constexpr int kFewWaits = 10;
constexpr double kOfItsTime = 0.3;

constexpr SimTime kSendingNow = 10 * kMillisecond;  // longer than a byte takes at 1200 baud
constexpr const char* kCallsThatWait[] = {"print", "write", "flush", "Serial.write", "Serial.flush"};

bool is_of_serial(const std::string& call) {
  return std::any_of(std::begin(kCallsThatWait), std::end(kCallsThatWait),
                     [&](const char* name) { return call.starts_with(name); });
}

}  // namespace

void SlowSerial::look(const Steering& now) {
  if (asked_ >= kMostAsked) return;
  const bool drives = now.left != 0.0 || now.right != 0.0;
  if (now.asks_floor || !drives || !now.on_its_own) {
    if (now.asks_floor && now.on_its_own) end(now);
    began_ = now.t;
    from_m_ = now.distance_m;
    waits_ = false;
  } else if (const SimTime since = now.t - began_; since >= kLongWait && since < kLongWait + kTick) {
    ++asked_;
    const exec::Activity busy = executor_->activity();
    waits_ = now.sent_at >= 0 && now.t - now.sent_at < kSendingNow && is_of_serial(busy.call);
    if (waits_ && first_.call.empty()) first_ = busy, first_at_ = now.t;
  }
  if (drives && now.on_its_own) driven_ += kTick;
}

void SlowSerial::end(const Steering& now) {
  if (!waits_) return;
  ++times_;
  waited_ += now.t - began_;
  longest_s_ = std::max(longest_s_, 1e-9 * static_cast<double>(now.t - began_));
  furthest_m_ = std::max(furthest_m_, now.distance_m - from_m_);
}

std::vector<exec::Detected> SlowSerial::found() const {
  if (times_ < kFewWaits || static_cast<double>(waited_) < kOfItsTime * static_cast<double>(driven_))
    return {};
  exec::Detected told;
  told.detector = "slow_serial";
  told.what = fmt::format(
      "Serial's buffer was full, and {} waited for room: for up to {:.0f} ms ({:.0f} mm) the driving robot "
      "did not read its line sensors, {:.0f} % of its driving time in total",
      first_.call, 1e3 * longest_s_, 1e3 * furthest_m_,
      100.0 * static_cast<double>(waited_) / static_cast<double>(driven_));
  told.mend = kPrintLess;
  told.where = first_.where;
  told.first_s = 1e-9 * static_cast<double>(first_at_);
  told.times = times_;
  return {told};
}

}  // namespace robosim::judge
