#include "sim/campaign/rerun/clock_wrap_detector.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "sim/campaign/rerun/line_counts.h"
#include "sim/launch/client/interrupts.h"
#include "sim/result/detector_names.h"

namespace robosim::campaign {
namespace fs = std::filesystem;

namespace {

constexpr std::int64_t kMillisecond = 1'000'000, kSecond = 1'000 * kMillisecond;
constexpr std::int64_t kMillisWrap = (std::int64_t{1} << 32) * kMillisecond;
constexpr std::int64_t kMicrosWrap = (std::int64_t{1} << 32) * 1'000;
// If the clock is lower by this amount, neither millis() nor micros() wraps during the run, and
// millis() % 1000 is unchanged.
constexpr std::int64_t kLower = 2000 * kSecond;
// Clock values at which the clock's number becomes longer without a wrap. It becomes longer by a decimal
// digit (of milliseconds and seconds), or by a bit.
struct Step {
  std::int64_t to, beside;  ///< a clock that differs by `beside` passes no such value
};
constexpr Step kSteps[] = {{10'000 * kSecond, 1000 * kSecond}, {16'777'216 * kMillisecond, -1000 * kSecond}};
// The number of further clocks that are tried. Their numbers do not become longer during the run. If the
// robot's path depends on a microsecond, each clock usually changes the path.
constexpr int kOtherClocks = 6;
constexpr std::int64_t kApart = 1000 * kSecond;
constexpr std::size_t kMostMoments = 6;
constexpr std::int64_t kBehindChange = 30 * kMillisecond;
constexpr std::int64_t kSettled = kSecond, kShortest = 3 * kSecond, kLongest = 600 * kSecond;
constexpr std::int64_t kSamplesEvery = 10 * kMillisecond, kBehind = 2 * kSecond, kCounted = kSecond;
constexpr double kSameWay_mm = 30.0, kSameDistance = 0.25;
// A pin counts as driven differently if it changes at least kFewChanges times in one run. This must be more
// than kManyTimes times as often as in the other run.
constexpr int kFewChanges = 8, kManyTimes = 8;
constexpr const char* kLibraries = "libraries/";
constexpr std::size_t kMostChanges = 100'000;

/// The observations of a run.
struct Look {
  result::RunResult result;
  std::vector<wire::Sample> samples;
  std::map<std::string, std::vector<std::int64_t>> changes;  ///< times, by pin
};

Look run(client::Runner& runner, wire::RunRequest request, std::int64_t clock) {
  request.clock_ns = clock;
  request.pins = true;
  request.samples_every_ns = kSamplesEvery;
  Look look;
  look.result = runner.run(request, [&](const wire::Event& event) {
    if (const auto* sample = std::get_if<wire::Sample>(&event)) look.samples.push_back(*sample);
    if (const auto* pin = std::get_if<wire::PinChange>(&event))
      if (auto& times = look.changes[pin->pin]; times.size() < kMostChanges) times.push_back(pin->t_ns);
  });
  return look;
}

bool drives_otherwise(const Look& a, const Look& b, std::int64_t until) {
  for (std::size_t i = 0; i < std::min(a.samples.size(), b.samples.size()); ++i) {
    if (a.samples[i].t_us * 1000 > until) return false;
    if (std::hypot(a.samples[i].x_mm - b.samples[i].x_mm, a.samples[i].y_mm - b.samples[i].y_mm) >
        kSameWay_mm)
      return true;
  }
  return false;
}

int changes_behind(const Look& look, const std::string& pin, std::int64_t moment) {
  const auto found = look.changes.find(pin);
  if (found == look.changes.end()) return 0;
  const auto& times = found->second;
  return static_cast<int>(times.end() - std::upper_bound(times.begin(), times.end(), moment));
}

bool changes_more(const Look& a, const Look& b, std::int64_t moment) {
  return std::any_of(a.changes.begin(), a.changes.end(), [&](const auto& pin) {
    const int count = changes_behind(a, pin.first, moment);
    return count >= kFewChanges && count > kManyTimes * changes_behind(b, pin.first, moment);
  });
}

bool differ(const Look& a, const Look& b, std::int64_t moment) {
  if (a.result.trace_hash == b.result.trace_hash) return false;
  return a.result.verdict != b.result.verdict || drives_otherwise(a, b, moment + kBehind) ||
         changes_more(a, b, moment) || changes_more(b, a, moment);
}

/// Returns whether two results are so similar that the sketch apparently ignores the time since power-on.
bool is_alike(const result::RunResult& a, const result::RunResult& b) {
  const double far = a.metrics.distance_m, other = b.metrics.distance_m;
  return a.verdict == b.verdict && std::abs(far - other) <= kSameDistance * std::max(far, other);
}

/// Returns whether the sketch has sent its clock, in microseconds, milliseconds, hundredths, tenths, seconds
/// or minutes. Returns false if the output is too short to make the sketch wait for the serial port. After
/// the wrap, sending the clock takes less time, because it has fewer digits.
bool prints_clock(const Look& look, std::int64_t clock) {
  constexpr std::int64_t kUnits[] = {1000,    kMillisecond, 10 * kMillisecond, 100 * kMillisecond,
                                     kSecond, 60 * kSecond};
  constexpr std::size_t kFewest = 5, kMostDigits = 10;
  constexpr double kBuffer = 64.0;  // bytes
  if (static_cast<double>(look.result.serial.size()) < kBuffer * look.result.time_s) return false;
  const auto lasted = static_cast<std::int64_t>(look.result.time_s * 1e9);
  const auto is_of = [&](std::uint64_t number, std::int64_t unit) {
    const auto since = static_cast<std::uint32_t>(number) - static_cast<std::uint32_t>(clock / unit);
    return static_cast<std::int64_t>(since) * unit <= lasted + unit;
  };
  const std::string& text = look.result.serial;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    if (end - at >= kFewest && end - at <= kMostDigits) {
      const std::uint64_t number = std::strtoull(text.substr(at, end - at).c_str(), nullptr, 10);
      if (std::any_of(std::begin(kUnits), std::end(kUnits), [&](auto unit) { return is_of(number, unit); }))
        return true;
    }
    at = std::max(end, at + 1);
  }
  return false;
}

/// Returns whether the behaviour also changes without a wrap: with another clock, or with a clock that gains
/// a digit or bit. A difference of one microsecond can cause such a change. A change after a wrap then proves
/// nothing. `usual` is the run with `clock`, which neither wraps nor gains a digit or bit.
bool is_touchy(client::Runner& runner, const wire::RunRequest& request, const Look& usual, std::int64_t clock,
               std::int64_t moment) {
  for (int i = 1; i <= kOtherClocks; ++i)
    if (differ(run(runner, request, clock - i * kApart), usual, moment)) return true;
  return std::any_of(std::begin(kSteps), std::end(kSteps), [&](const Step& step) {
    const std::int64_t passing = step.to - moment;
    return differ(run(runner, request, passing), run(runner, request, passing + step.beside), moment);
  });
}

/// Returns the middle of the run, and moments shortly after the sketch has driven a pin. A long pause, in
/// which the sketch may wait, follows each of these moments.
std::vector<std::int64_t> moments_in(const Look& usual) {
  std::vector<std::int64_t> changes;
  for (const auto& [pin, times] : usual.changes) changes.insert(changes.end(), times.begin(), times.end());
  std::sort(changes.begin(), changes.end());
  std::vector<std::pair<std::int64_t, std::int64_t>> quiet;  // duration and start
  for (std::size_t i = 0; i + 1 < changes.size(); ++i)
    quiet.emplace_back(changes[i + 1] - changes[i], changes[i]);
  std::sort(quiet.rbegin(), quiet.rend());
  const auto end = static_cast<std::int64_t>(usual.result.time_s * 1e9);
  std::vector<std::int64_t> moments = {end / 2 / kMillisecond * kMillisecond};
  for (const auto& [length, from] : quiet) {
    const std::int64_t moment = (from + kBehindChange) / kMillisecond * kMillisecond;
    if (moments.size() >= kMostMoments || length < 2 * kBehindChange) break;
    if (from > kSettled && moment < end - kSettled) moments.push_back(moment);
  }
  return moments;
}

/// Returns how often each line ran, until shortly after the moment.
std::map<std::pair<std::string, int>, double> lines(client::Runner& runner, wire::RunRequest request,
                                                    std::int64_t clock, std::int64_t moment) {
  const fs::path file = fs::temp_directory_path() / fmt::format("robosim-lines-{}", ::getpid());
  request.clock_ns = clock;
  request.for_ns = std::min(request.for_ns, moment + kCounted);
  request.counters = file.string();
  runner.run(request);
  return take_line_counts(file);
}

/// The line whose count differs most between the run with the wrap and the run without a wrap.
struct Other {
  result::SourceLine where;
  double wrapped = 0.0, other = 0.0;
};
std::optional<Other> line_that_differs(client::Runner& runner, const wire::RunRequest& request,
                                       std::int64_t clock, std::int64_t moment) {
  const auto wrapped = lines(runner, request, clock, moment);
  auto other = lines(runner, request, clock - kLower, moment);
  std::optional<Other> most;
  double least = 0.0;
  for (const auto& [place, count] : wrapped) {
    const double difference = std::abs(count - other[place]);
    if (difference <= least || place.first.starts_with(kLibraries)) continue;
    least = difference;
    most = Other{{"", place.first, place.second}, count, other[place]};
  }
  return most;
}

}  // namespace

std::vector<result::Detected> detect_clock_wrap(client::Runner& runner, wire::RunRequest request,
                                                const result::RunResult& first) {
  const auto lasted = static_cast<std::int64_t>(first.time_s * 1e3) * kMillisecond;
  if (request.clock_ns != 0 || lasted < kShortest || lasted > kLongest) return {};
  request.detect = false;
  const Look some = run(runner, request, kMillisWrap - kLower);
  if (!is_alike(some.result, first) || prints_clock(some, kMillisWrap - kLower)) return {};
  for (const std::int64_t moment : moments_in(some)) {
    const std::int64_t clock = kMillisWrap - moment;
    const Look wrapped = run(runner, request, clock);
    if (client::Interrupts::count() > 0) return {};
    if (!differ(wrapped, some, moment)) continue;
    const Look usual = run(runner, request, clock - kLower);
    if (!differ(wrapped, usual, moment)) continue;
    if (is_touchy(runner, request, usual, clock - kLower, moment)) return {};
    const Look micros = run(runner, request, kMicrosWrap - moment);
    const bool by_micros = differ(micros, run(runner, request, kMicrosWrap - moment - kLower), moment);
    if (client::Interrupts::count() > 0) return {};
    const auto place = line_that_differs(runner, request, clock, moment);
    result::Detected seen;
    seen.detector = result::detector("clock_wrap");
    const bool ends_otherwise = wrapped.result.verdict != usual.result.verdict;
    seen.what = fmt::format(
        "the robot behaves differently when {} goes back to 0 (after {}; in this run at {:.2f} s){}",
        by_micros ? "micros()" : "millis()", by_micros ? "71.6 minutes" : "49.7 days",
        1e-9 * static_cast<double>(moment),
        ends_otherwise ? fmt::format(": {} instead of {}", wrapped.result.verdict, usual.result.verdict)
                       : "");
    if (place)
      seen.what += fmt::format("; in the next second, this line runs {:.0f} times {}",
                               std::abs(place->wrapped - place->other),
                               place->wrapped > place->other ? "more" : "less");
    seen.mend =
        "Compare durations, not moments: millis() - start >= N, with unsigned long start, instead of "
        "millis() >= start + N.";
    if (place) seen.where = place->where;
    seen.first_s = 1e-9 * static_cast<double>(moment);
    return {seen};
  }
  return {};
}

}  // namespace robosim::campaign
