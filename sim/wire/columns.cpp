#include "sim/wire/columns.h"

#include <algorithm>
#include <cmath>

namespace robosim::wire {

void Column::add(const double* first, std::size_t step, std::size_t count) {
  spec_.order == 2 ? pack<true>(first, step, count) : pack<false>(first, step, count);
}

template <bool kIsSecond>
void Column::pack(const double* first, std::size_t step, std::size_t count) {
  constexpr auto kMost = static_cast<double>(kMostSteps);
  constexpr std::size_t kLongest = 10;  // bytes for 64 bits, seven bits in each
  buffer_.resize(std::max(buffer_.size(), used_ + kLongest * count));
  const double scale = spec_.scale;
  std::int64_t last = last_, expected = kIsSecond ? change_ : 0;
  char* to = buffer_.data() + used_;
  for (const double* value = first; count > 0; --count, value += step) {
    const double scaled = *value * scale;
    std::int64_t steps = 0;  // for NaN
    if (std::fabs(scaled) < kMost)
      steps = static_cast<std::int64_t>(scaled + std::copysign(0.5, scaled));
    else if (!std::isnan(scaled))
      steps = scaled < 0.0 ? -kMostSteps : kMostSteps;
    const std::int64_t change = steps - last, d = change - expected;
    last = steps;
    if constexpr (kIsSecond) expected = change;
    auto z = (static_cast<std::uint64_t>(d) << 1) ^ static_cast<std::uint64_t>(d >> 63);
    for (; z >= 0x80; z >>= 7) *to++ = static_cast<char>(z | 0x80);
    *to++ = static_cast<char>(z);
  }
  used_ = static_cast<std::size_t>(to - buffer_.data());
  last_ = last;
  change_ = expected;
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

std::vector<Column>& Stream::columns() {
  if (waiting_ == 0) return columns_;
  for (std::size_t i = 0; i < columns_.size(); ++i)
    columns_[i].add(rows_.data() + i, columns_.size(), waiting_ / columns_.size());
  waiting_ = 0;
  return columns_;
}

Rows Stream::take() {
  Rows rows{name_, count_, {}, {}};
  for (Column& column : columns()) {
    if (!told_) rows.columns.push_back(column.spec());
    rows.bytes.emplace_back(column.bytes());
    column.clear();
  }
  told_ = true;
  count_ = 0;
  return rows;
}

}  // namespace robosim::wire
