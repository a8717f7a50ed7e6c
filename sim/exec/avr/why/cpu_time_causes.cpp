#include <algorithm>

#include "sim/exec/avr/why/backward_slice.h"

// Finds the lines of the sketch that used most of the processor's time, and the line that disabled
// interrupts.

namespace robosim::exec::avr {
SourceLine BackwardSlice::busiest(SimTime from, SimTime to) const {
  if (!log_ || frames_.empty()) return {};
  std::map<Line, std::uint64_t> cycles;
  const auto& entries = log_->entries();
  for (std::size_t i = 0; i + 1 < entries.size(); ++i) {
    const SimTime t = time_of(static_cast<Index>(i));
    if (t < from || t >= to) continue;
    const std::vector<Line> lines = lines_of(static_cast<Index>(i));
    if (!lines.empty()) cycles[lines[0]] += entries[i + 1].began - entries[i].began;
  }
  const auto most = std::max_element(cycles.begin(), cycles.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == cycles.end() ? SourceLine{} : *most->first;
}

CauseFinder::Share BackwardSlice::handlers(SimTime from, SimTime to) const {
  if (!log_ || frames_.empty()) return {};
  std::map<Line, std::uint64_t> cycles;
  std::uint64_t all = 0, in_handlers = 0;
  const auto& entries = log_->entries();
  for (std::size_t i = 0; i + 1 < entries.size(); ++i) {
    const SimTime t = time_of(static_cast<Index>(i));
    if (t < from || t >= to) continue;
    const std::uint64_t took = entries[i + 1].began - entries[i].began;
    all += took;
    const std::vector<Line> lines = lines_of(static_cast<Index>(i));
    if (!is_in_handler(static_cast<Index>(i)) || lines.empty()) continue;
    in_handlers += took;
    cycles[lines.back()] += took;
  }
  const auto most = std::max_element(cycles.begin(), cycles.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == cycles.end()) return {};
  return {*most->first, static_cast<double>(in_handlers) / static_cast<double>(all)};
}

bool BackwardSlice::is_in_handler(Index index) const {
  for (; index != kNone; index = frames_[static_cast<std::size_t>(index)])
    if (log_->entries()[static_cast<std::size_t>(index)].interrupts) return true;
  return false;
}

bool BackwardSlice::interrupts_on() const {
  return machine_ && machine_->chip().chip().cpu().interrupts_enabled();
}

std::optional<CauseStep> BackwardSlice::switched_off(bool on) {
  if (!log_) return std::nullopt;
  if (frames_.empty()) find_frames();
  const auto& entries = log_->entries();
  for (std::size_t i = entries.size(); i-- > 0;) {
    if (entries[i].enables || !(i > 0 ? entries[i - 1].enables : on)) continue;
    const std::vector<Line> lines = lines_of(static_cast<Index>(i));
    if (lines.empty()) break;
    return CauseStep{CauseStep::Kind::decides, *lines[0], time_of(static_cast<Index>(i)), 0, kNoPin};
  }
  return std::nullopt;
}

}  // namespace robosim::exec::avr
