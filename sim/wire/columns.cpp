#include "sim/wire/columns.h"

#include <algorithm>
#include <cmath>

#include "sim/base/base64.h"

namespace robosim::wire {

void Column::add(double value) {
  constexpr auto kMost = static_cast<double>(kMostSteps);
  const double scaled = value * spec_.scale;
  std::int64_t steps = 0;  // of what is no number
  if (std::fabs(scaled) < kMost)
    steps = static_cast<std::int64_t>(scaled + (scaled < 0.0 ? -0.5 : 0.5));
  else if (!std::isnan(scaled))
    steps = scaled < 0.0 ? -kMostSteps : kMostSteps;
  const std::int64_t change = steps - last_;
  const std::int64_t d = spec_.order == 2 ? change - change_ : change;
  last_ = steps;
  change_ = change;
  auto z = (static_cast<std::uint64_t>(d) << 1) ^ static_cast<std::uint64_t>(d >> 63);
  for (; z >= 0x80; z >>= 7) bytes_.push_back(static_cast<char>(z | 0x80));
  bytes_.push_back(static_cast<char>(z));
}

std::optional<std::vector<std::int64_t>> ColumnReader::read(std::string_view bytes, std::size_t count) {
  std::vector<std::int64_t> values;
  if (count > bytes.size()) return std::nullopt;
  values.reserve(count);
  std::uint64_t z = 0;
  unsigned shift = 0;
  for (const char c : bytes) {
    if (shift > 56 || values.size() == count) return std::nullopt;
    z |= static_cast<std::uint64_t>(c & 0x7F) << shift;
    shift += 7;
    if (c & 0x80) continue;
    const std::uint64_t d = (z >> 1) ^ (~(z & 1) + 1);
    change_ = order_ == 2 ? change_ + d : d;
    last_ += change_;
    values.push_back(static_cast<std::int64_t>(last_));
    z = 0;
    shift = 0;
  }
  if (values.size() != count || shift != 0) return std::nullopt;
  return values;
}

Stream::Stream(std::string name, const std::vector<ColumnSpec>& columns) : name_(std::move(name)) {
  for (const ColumnSpec& column : columns) columns_.emplace_back(column);
}

void Stream::add(const double* row) {
  for (std::size_t i = 0; i < columns_.size(); ++i) columns_[i].add(row[i]);
  ++count_;
}

std::size_t Stream::bytes() const {
  std::size_t bytes = 0;
  for (const Column& column : columns_) bytes += column.bytes().size();
  return bytes;
}

Rows Stream::take() {
  Rows rows{name_, count_, {}, {}};
  for (Column& column : columns_) {
    if (!told_) rows.columns.push_back(column.spec());
    rows.bytes.push_back(base64(column.bytes()));
    column.clear();
  }
  told_ = true;
  count_ = 0;
  return rows;
}

}  // namespace robosim::wire
