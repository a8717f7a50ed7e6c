#include "sim/detect/avr/watchdog_margin.h"

#include <fmt/format.h>

#include <utility>

#include "hal/board/avr_watchdog.h"

namespace robosim::detect::avr {
namespace {

using robosim::avr::kWde, robosim::avr::kWdie, robosim::avr::kWdrf, robosim::avr::watchdog_power;

constexpr std::uint16_t kRjmpToItself = 0xCFFF;
constexpr double kShare = 0.8;
constexpr double kShortest_s = 2048 / 128e3;
constexpr const char* kNames[] = {"WDTO_15MS",  "WDTO_30MS", "WDTO_60MS", "WDTO_120MS", "WDTO_250MS",
                                  "WDTO_500MS", "WDTO_1S",   "WDTO_2S",   "WDTO_4S",    "WDTO_8S"};
constexpr int kLongestPower = std::size(kNames) - 1;

double seconds_of(int power) { return kShortest_s * static_cast<double>(1 << power); }

/// Suggests a fix for a timeout of kShortest_s * 2^power.
std::string advice_for(int power) {
  return power < kLongestPower
             ? fmt::format(
                   "Use the next longer timeout, wdt_enable({}), or call wdt_reset() within "
                   "the code that takes so long.",
                   kNames[power + 1])
             : "Call wdt_reset() within the code that takes so long.";
}

}  // namespace

WatchdogMargin::WatchdogMargin(const RunningProgram& program)
    : program_(program),
      machine_(program.machine),
      cpu_(machine_.chip().chip().cpu()),
      watchdog_(std::exchange(cpu_.on_wdr, robosim::avr::Cpu::call<&WatchdogMargin::fed>(this))),
      reset_(std::exchange(machine_.chip().chip().core().reset,
                           [](void* self, std::uint8_t flags) {
                             static_cast<WatchdogMargin*>(self)->watchdog_resets(flags);
                           })),
      reset_self_(std::exchange(machine_.chip().chip().core().reset_self, this)) {}

WatchdogMargin::~WatchdogMargin() {
  cpu_.on_wdr = watchdog_;
  machine_.chip().chip().core().reset = reset_;
  machine_.chip().chip().core().reset_self = reset_self_;
}

bool WatchdogMargin::waits() const {
  const auto flash = cpu_.flash();
  const std::uint32_t pc =
      machine_.chip().in_handler() ? machine_.chip().interrupted_pc() : machine_.chip().pc();
  return pc + 1 < flash.size() && (flash[pc] | flash[pc + 1] << 8) == kRjmpToItself;
}

void WatchdogMargin::watchdog_resets(std::uint8_t flags) {
  if (flags & kWdrf && !waits()) {
    if (bite_.empty()) {
      const int power = watchdog_power(cpu_.data[cpu_.chip().at.watchdog]);
      Detected& seen = bite_.emplace_back();
      seen.detector = result::detector("watchdog_bite");
      seen.what = fmt::format(
          "the watchdog reset the chip, because wdt_reset() was not called within the timeout "
          "of {:.0f} ms",
          1e3 * seconds_of(power));
      seen.mend = "Use a longer timeout, or call wdt_reset() within the code that takes so long.";
      seen.where = program_.diagnosis().sketch_line();
      seen.first_s = now_s();
    } else {
      ++bite_.front().times;
    }
  }
  reset_(reset_self_, flags);
}

void WatchdogMargin::fed() {
  const std::uint8_t control = cpu_.data[cpu_.chip().at.watchdog];
  const Cycle now = cpu_.cycle(), passed = now - last_;
  last_ = now;
  watchdog_();
  if (!(control & kWde) || control & kWdie) return;
  const int power = watchdog_power(control);
  const double passed_s = static_cast<double>(passed) / machine_.chip().clock_hz();
  if (passed_s < kShare * seconds_of(power) || passed_s > seconds_of(power) || passed <= longest_) return;
  longest_ = passed;
  longest_power_ = power;
  seen_.where = program_.diagnosis().sketch_line();
  seen_.first_s = now_s();
}

std::vector<Detected> WatchdogMargin::found(SimTime) const {
  // Omits the resets if the run has crashed, since the crash may be due to these resets.
  std::vector<Detected> all;
  if (!machine_.chip().fault()) all = bite_;
  if (longest_ == 0) return all;
  Detected& seen = all.emplace_back(seen_);
  const double passed_s = static_cast<double>(longest_) / machine_.chip().clock_hz();
  const double waits_s = seconds_of(longest_power_);
  seen.detector = result::detector("watchdog_margin");
  seen.what = fmt::format(
      "the watchdog, with a timeout of {:.0f} ms, was reset {:.0f} ms after the previous reset, {:.0f} % of "
      "the timeout; its clock may be 10 % faster on another or a warmer chip, so that the watchdog may reset "
      "that chip",
      1e3 * waits_s, 1e3 * passed_s, 100.0 * passed_s / waits_s);
  seen.mend = advice_for(longest_power_);
  return all;
}

}  // namespace robosim::detect::avr
