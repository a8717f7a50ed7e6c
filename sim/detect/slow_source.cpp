#include "sim/detect/slow_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/result/detector_names.h"

namespace robosim::detect {
namespace {

constexpr double kNoticed = 8.0 / 1024.0;  // minimum error of a finding, as a share of the supply
constexpr std::int64_t kManyTimes = 3;

}  // namespace

SlowSource::Found& SlowSource::of(const Reading& reading, const Where& where) {
  const auto known = std::find_if(found_.begin(), found_.end(),
                                  [&](const Found& other) { return other.worst.pin == reading.pin; });
  if (known != found_.end()) return *known;
  return found_.emplace_back(Found{reading, reading.at, 0, where()});
}

void SlowSource::converted(Pin pin, double volts, SimTime t, const Where& where) {
  if (last_.pin != kNoPin && last_.pin != pin) {
    Found& here = of(last_, where);
    if (here.times++ == 0) here.first = last_.at;
    if (std::abs(last_.volts) > std::abs(here.worst.volts)) here.worst = last_;
  }
  last_ = {std::abs(volts) >= kNoticed * board_->supply_volts ? pin : kNoPin, volts, t};
  if (last_.pin != kNoPin) of(last_, where);  // stores the source line of the reading
}

std::vector<result::Detected> SlowSource::found() const {
  std::vector<result::Detected> all;
  for (const Found& here : found_) {
    if (here.times < kManyTimes) continue;
    result::Detected told;
    told.detector = result::detector("slow_source");
    const int number = here.worst.pin - board_->analog_pin_0;
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
