#include "sim/exec/host/divisions.h"

#include <algorithm>

namespace robosim::exec {
namespace {

constexpr std::size_t kMostLines = 8;

}  // namespace

bool Divisions::count(const void* address) {
  const auto known = at_.find(address);
  if (known == at_.end()) return false;
  if (known->second < lines_.size()) ++lines_[known->second].times;
  return true;
}

void Divisions::add(const void* address, const SourceLine& place, SimTime t) {
  const auto known = std::find_if(lines_.begin(), lines_.end(), [&](const DivisionByZero& line) {
    return line.where.file == place.file && line.where.line == place.line;
  });
  const auto index = static_cast<std::size_t>(known - lines_.begin());
  at_[address] = index < kMostLines ? index : kMostLines;
  if (index == kMostLines) return;
  if (known == lines_.end()) lines_.push_back({place, 1e-9 * static_cast<double>(t), 0});
  ++lines_[index].times;
}

}  // namespace robosim::exec
