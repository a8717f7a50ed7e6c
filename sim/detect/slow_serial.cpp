#include "sim/detect/slow_serial.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim::detect {
namespace {

constexpr SimTime kLongWait = 15 * kMillisecond;
constexpr int kMostAsked = 200;  // limit, because Executor::activity() is slow
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
  if (state_.asked >= kMostAsked) return;
  const bool drives = now.left != 0.0 || now.right != 0.0;
  if (now.asks_floor || !drives || !now.on_its_own) {
    if (now.asks_floor && now.on_its_own) end(now);
    state_.began = now.t;
    state_.from_m = now.distance_m;
    state_.waits = false;
  } else if (const SimTime since = now.t - state_.began; since >= kLongWait && since < kLongWait + kTick) {
    ++state_.asked;
    const exec::Activity busy = executor_.activity();
    state_.waits = now.sent_at >= 0 && now.t - now.sent_at < kSendingNow && is_of_serial(busy.call);
    if (state_.waits && state_.first.call.empty()) state_.first = busy, state_.first_at = now.t;
  }
  if (drives && now.on_its_own) state_.driven += kTick;
}

void SlowSerial::end(const Steering& now) {
  if (!state_.waits) return;
  ++state_.times;
  state_.waited += now.t - state_.began;
  state_.longest_s = std::max(state_.longest_s, 1e-9 * static_cast<double>(now.t - state_.began));
  state_.furthest_m = std::max(state_.furthest_m, now.distance_m - state_.from_m);
}

std::vector<exec::Detected> SlowSerial::found(SimTime) const {
  if (state_.times < kFewWaits ||
      static_cast<double>(state_.waited) < kOfItsTime * static_cast<double>(state_.driven))
    return {};
  exec::Detected told;
  told.detector = result::detector("slow_serial");
  told.what = fmt::format(
      "Serial's buffer was full, and {} waited for room: for up to {:.0f} ms ({:.0f} mm) the driving robot "
      "did not read its line sensors, {:.0f} % of its driving time in total",
      state_.first.call, 1e3 * state_.longest_s, 1e3 * state_.furthest_m,
      100.0 * static_cast<double>(state_.waited) / static_cast<double>(state_.driven));
  told.mend = kPrintLess;
  told.where = state_.first.where;
  told.first_s = 1e-9 * static_cast<double>(state_.first_at);
  told.times = state_.times;
  return {told};
}

}  // namespace robosim::detect
