#include "sim/record/column.h"

#include <algorithm>
#include <cmath>

#include "sim/base/error.h"

namespace robosim::record {

std::int64_t Column::steps(double value) const {
  const double most = static_cast<double>(kMostSteps);
  const double scaled = value * spec_.scale;
  return std::isnan(scaled) ? 0 : std::llround(std::clamp(scaled, -most, most));
}

void Column::add_steps(std::int64_t value) {
  const std::int64_t change = value - last_;
  const std::int64_t d = spec_.order == 2 ? change - change_ : change;
  last_ = value;
  change_ = change;
  auto z = (static_cast<std::uint64_t>(d) << 1) ^ static_cast<std::uint64_t>(d >> 63);
  for (; z >= 0x80; z >>= 7) bytes_ += static_cast<char>(z | 0x80);
  bytes_ += static_cast<char>(z);
}

std::vector<std::int64_t> read_column(std::string_view bytes, std::size_t count, int order,
                                      const std::string& what) {
  std::vector<std::int64_t> values;
  if (count > bytes.size()) throw InputError(what);
  values.reserve(count);
  std::uint64_t last = 0, change = 0, z = 0;
  unsigned shift = 0;
  for (const char c : bytes) {
    if (shift > 56 || values.size() == count) throw InputError(what);
    z |= static_cast<std::uint64_t>(c & 0x7F) << shift;
    shift += 7;
    if (c & 0x80) continue;
    const std::uint64_t d = (z >> 1) ^ (~(z & 1) + 1);
    change = order == 2 ? change + d : d;
    last += change;
    values.push_back(static_cast<std::int64_t>(last));
    z = 0;
    shift = 0;
  }
  if (values.size() != count || shift != 0) throw InputError(what);
  return values;
}

}  // namespace robosim::record
