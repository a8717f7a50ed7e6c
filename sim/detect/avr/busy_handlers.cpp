#include "sim/detect/avr/busy_handlers.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace robosim::detect::avr {
namespace {

constexpr double kBusyShare = 0.7;

/// Returns the line without the name of its function, such as "__vector_7".
SourceLine handler(SourceLine line) {
  line.function.clear();
  return line;
}

}  // namespace

BusyHandlers::BusyHandlers(const RunningProgram& program)
    : program_(program),
      window_(program.machine.chip().clock_hz() / 2),
      taken_(program.machine.chip().spec().vectors) {
  program.machine.chip().show_handlers(*this);
}

void BusyHandlers::entered(int vector, Cycle at) {
  if (program_.machine.chip().open_handlers() > 1) return;
  vector_ = vector;
  entered_ = at;
}

void BusyHandlers::left() {
  const WatchedChip& chip = program_.machine.chip();
  if (chip.open_handlers() > 1 || vector_ >= static_cast<int>(taken_.size())) return;
  const Cycle now = chip.cycle();
  taken_[static_cast<std::size_t>(vector_)] += now - entered_;
  if (now - began_ >= window_) end_window(now);
}

void BusyHandlers::end_window(Cycle at) {
  const Cycle all = std::accumulate(taken_.begin(), taken_.end(), Cycle{0}), passed = at - began_;
  const auto most = std::max_element(taken_.begin(), taken_.end());
  if (static_cast<double>(all) >= kBusyShare * static_cast<double>(passed)) {
    if (!found_) {
      const auto percent = [&](Cycle of) {
        return 100.0 * static_cast<double>(of) / static_cast<double>(passed);
      };
      const auto begin = program_.firmware.find(fmt::format("__vector_{}", most - taken_.begin()));
      found_ = {
          result::detector("busy_handlers"),
          fmt::format(
              "interrupt handlers took {:.0f} % of the processor's time, so that the sketch hardly ran, "
              "and millis() may have stood still: {:.0f} % in one handler",
              percent(all), percent(*most)),
          "Make the interrupt less frequent, for example by a longer period of its timer, or shorten its "
          "handler.",
          begin ? handler(program_.debug.place(*begin)) : SourceLine{},
          static_cast<double>(began_) / program_.machine.chip().clock_hz(),
          0};
    }
    ++found_->times;
  }
  std::fill(taken_.begin(), taken_.end(), 0);
  began_ = at;
}

std::vector<Detected> BusyHandlers::found(SimTime) const {
  return found_ ? std::vector<Detected>{*found_} : std::vector<Detected>{};
}

}  // namespace robosim::detect::avr
