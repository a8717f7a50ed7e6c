#include "sim/exec/elf/line_counts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace robosim::exec {
namespace {

bool lies_before(const LineCounts::Begin& begin, std::uint32_t address) { return begin.address < address; }

}  // namespace

LineCounts::LineCounts(const DebugInfo& debug) : lines_(debug.lines()) {
  for (const DebugInfo::CodeLine& line : lines_) begins_.push_back({line.address, 0});
  std::sort(begins_.begin(), begins_.end(),
            [](const Begin& a, const Begin& b) { return a.address < b.address; });
  const auto twice = std::unique(begins_.begin(), begins_.end(),
                                 [](const Begin& a, const Begin& b) { return a.address == b.address; });
  begins_.erase(twice, begins_.end());
}

void LineCounts::ran(std::uint32_t address, std::uint64_t times) {
  const auto at = std::lower_bound(begins_.begin(), begins_.end(), address, lies_before);
  if (at != begins_.end() && at->address == address) at->count += times;
}

std::string LineCounts::text() const {
  std::map<std::pair<std::string, int>, std::uint64_t> counts;
  for (const DebugInfo::CodeLine& line : lines_) {
    const auto at = std::lower_bound(begins_.begin(), begins_.end(), line.address, lies_before);
    std::uint64_t& count = counts[{line.file, line.line}];
    count = std::max(count, at->count);
  }
  std::string text;
  for (const auto& [place, count] : counts)
    text += fmt::format("{} {} {}\n", place.second, count, place.first);
  return text;
}

}  // namespace robosim::exec
