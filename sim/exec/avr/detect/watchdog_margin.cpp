#include "sim/exec/avr/detect/watchdog_margin.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace robosim::exec::avr {
namespace {

constexpr std::uint8_t kWdie = 0x40, kWdp3 = 0x20, kWde = 0x08;
constexpr double kShare = 0.8;
constexpr double kShortest_s = 2048 / 128e3;
constexpr const char* kNames[] = {"WDTO_15MS",  "WDTO_30MS", "WDTO_60MS", "WDTO_120MS", "WDTO_250MS",
                                  "WDTO_500MS", "WDTO_1S",   "WDTO_2S",   "WDTO_4S",    "WDTO_8S"};
constexpr std::uint32_t kLongestPower = std::size(kNames) - 1;

double seconds_of(std::uint32_t power) { return kShortest_s * static_cast<double>(1u << power); }

}  // namespace

WatchdogMargin::WatchdogMargin(Machine& machine, WhereNow where)
    : machine_(machine),
      where_(std::move(where)),
      cpu_(machine.chip().chip().cpu()),
      watchdog_(std::exchange(cpu_.on_wdr, robosim::avr::Cpu::call<&WatchdogMargin::fed>(this))) {}

WatchdogMargin::~WatchdogMargin() { cpu_.on_wdr = watchdog_; }

void WatchdogMargin::fed() {
  const std::uint8_t control = cpu_.data[cpu_.chip().at.watchdog];
  const Cycle now = cpu_.cycle(), passed = now - last_;
  last_ = now;
  watchdog_();
  if (!(control & kWde) || control & kWdie) return;
  const std::uint32_t power =
      std::min<std::uint32_t>((control & kWdp3 ? 8 : 0) | (control & 7), kLongestPower);
  const double passed_s = static_cast<double>(passed) / machine_.chip().clock_hz();
  if (passed_s < kShare * seconds_of(power) || passed_s > seconds_of(power) || passed <= longest_) return;
  longest_ = passed;
  longest_power_ = power;
  seen_.where = where_();
  seen_.first_s = 1e-9 * static_cast<double>(machine_.now());
}

std::vector<Detected> WatchdogMargin::found() const {
  if (longest_ == 0) return {};
  Detected seen = seen_;
  const double passed_s = static_cast<double>(longest_) / machine_.chip().clock_hz();
  const double waits_s = seconds_of(longest_power_);
  seen.detector = "watchdog_margin";
  seen.what = fmt::format(
      "the watchdog, which waits {:.0f} ms, was fed {:.0f} ms after the time before, {:.0f} % of that; its "
      "own "
      "clock is some 10 % off, so that another chip, or a warm one, resets there",
      1e3 * waits_s, 1e3 * passed_s, 100.0 * passed_s / waits_s);
  seen.mend = longest_power_ < kLongestPower
                  ? fmt::format(
                        "Take the next longer time, wdt_enable({}), or call wdt_reset() within what takes "
                        "so long.",
                        kNames[longest_power_ + 1])
                  : "Call wdt_reset() within what takes so long.";
  return {seen};
}

}  // namespace robosim::exec::avr
