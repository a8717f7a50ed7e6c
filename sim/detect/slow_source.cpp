#include "sim/detect/slow_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hal/board/board_spec.h"

namespace robosim::detect {
namespace {

constexpr double kNoticed = 8.0 / 1024.0;  // error of a finding, as a share of the supply voltage
constexpr std::int64_t kManyTimes = 3;

}  // namespace

SlowSource::SlowSource(exec::Executor& executor, SnapshotRegistry& snapshots) : executor_(executor) {
  executor.board().watch_adc(*this);
  snapshots.add(state_);
}

SlowSource::Found& SlowSource::of(const Reading& reading) {
  const auto known = std::find_if(state_.found.begin(), state_.found.end(),
                                  [&](const Found& other) { return other.worst.pin == reading.pin; });
  if (known != state_.found.end()) return *known;
  return state_.found.emplace_back(Found{reading, reading.at, 0, executor_.sketch_source()});
}

void SlowSource::converted(Pin pin, double volts, SimTime t) {
  Reading& last = state_.last;
  if (last.pin != kNoPin && last.pin != pin) {
    Found& here = of(last);
    if (here.times++ == 0) here.first = last.at;
    if (std::abs(last.volts) > std::abs(here.worst.volts)) here.worst = last;
  }
  last = {std::abs(volts) >= kNoticed * executor_.board().spec().supply_volts ? pin : kNoPin, volts, t};
  if (last.pin != kNoPin) of(last);  // stores the source line of the reading
}

std::vector<exec::Detected> SlowSource::found(SimTime) const {
  std::vector<exec::Detected> all;
  for (const Found& here : state_.found) {
    if (here.times < kManyTimes) continue;
    exec::Detected told;
    told.detector = result::detector("slow_source");
    const int number = here.worst.pin - executor_.board().spec().analog_pin_0;
    told.what = fmt::format(
        "A{} was read up to {:.2f} V too {}: the source wired to it does not charge the converter's "
        "capacitor in time; the capacitor still has the voltage of the previously read pin",
        number, std::abs(here.worst.volts), here.worst.volts > 0.0 ? "high" : "low");
    told.mend = fmt::format(
        "Read A{} twice and discard the first reading, put 100 nF between it and ground, or connect a source "
        "of 10 kOhm or less.",
        number);
    told.where = here.where;
    told.first_s = 1e-9 * static_cast<double>(here.first);
    told.times = here.times;
    all.push_back(told);
  }
  return all;
}

}  // namespace robosim::detect
