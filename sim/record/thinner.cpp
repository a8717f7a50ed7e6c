#include "sim/record/thinner.h"

#include <algorithm>
#include <utility>

#include "sim/wire/json_reader.h"

namespace robosim::record {
namespace {

constexpr std::size_t kRowsAtOnce = 4096;

bool ends_number(char c) { return (c & 0x80) == 0; }

}  // namespace

Thinner::Thinner(const std::vector<wire::ColumnSpec>& specs, std::int64_t span_ns, Packer* packer)
    : span_ns_(static_cast<std::uint64_t>(span_ns)),
      specs_(specs),
      ahead_(specs.size()),
      last_(specs.size()),
      few_("", specs),
      kept_(specs.size(), packer) {
  for (const wire::ColumnSpec& spec : specs) readers_.emplace_back(spec.order);
}

void Thinner::unpack(Ahead& ahead, std::string_view bytes) {
  ahead.bytes += bytes;
  ahead.numbers += static_cast<std::size_t>(std::count_if(bytes.begin(), bytes.end(), ends_number));
}

std::string Thinner::take(Ahead& ahead, std::size_t count) {
  ahead.numbers -= count;
  if (ahead.numbers == 0) return std::exchange(ahead.bytes, "");
  auto end = ahead.bytes.begin();
  for (; count > 0; ++end) count -= ends_number(*end) ? 1 : 0;
  std::string taken(ahead.bytes.begin(), end);
  ahead.bytes.erase(ahead.bytes.begin(), end);
  return taken;
}

bool Thinner::read_some(const CompressedRows& all, std::size_t most_rows) {
  std::size_t count = most_rows;
  for (std::size_t i = 0; i < ahead_.size(); ++i) {
    Ahead& ahead = ahead_[i];
    const CompressedBytes& column = all.columns[i];
    while (ahead.numbers < count && ahead.pieces < column.pieces())
      unpack(ahead, column.piece(ahead.pieces++));
    count = std::min(count, ahead.numbers);
  }
  if (count == 0) return false;
  std::vector<std::string> bytes;
  for (Ahead& ahead : ahead_) bytes.push_back(take(ahead, count));
  add(bytes, static_cast<std::int64_t>(count));
  read_ += static_cast<std::int64_t>(count);
  return true;
}

void Thinner::follow(const CompressedRows& all, std::size_t most_rows) { read_some(all, most_rows); }

void Thinner::catch_up(const CompressedRows& all) {
  while (read_some(all, kRowsAtOnce)) {
  }
  std::vector<std::string> bytes;
  for (std::size_t i = 0; i < ahead_.size(); ++i) {
    while (ahead_[i].pieces < all.columns[i].pieces())
      unpack(ahead_[i], all.columns[i].piece(ahead_[i].pieces++));
    bytes.push_back(std::move(ahead_[i].bytes.append(all.columns[i].rest())));
  }
  add(bytes, all.count - std::exchange(read_, all.count));
  ahead_.clear();
}

void Thinner::add(const std::vector<std::string>& bytes, std::int64_t count) {
  std::vector<std::vector<std::int64_t>> columns;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    auto values = readers_[i].read(bytes[i], static_cast<std::size_t>(count));
    if (!values) throw wire::BadValue("bytes", "expected as many numbers as rows");
    columns.push_back(std::move(*values));
  }
  if (count == 0) return;
  const auto set_last = [&](std::size_t row) {
    for (std::size_t i = 0; i < columns.size(); ++i) last_[i] = columns[i][row];
  };
  const std::vector<std::int64_t>& times = columns[0];
  for (std::size_t row = 0; row < times.size(); ++row) {
    const auto t_ns = static_cast<std::uint64_t>(times[row]);
    const bool is_first = row == 0 && !has_last_;
    if (!is_first && t_ns - begin_ns_ < span_ns_) continue;
    begin_ns_ = t_ns / span_ns_ * span_ns_;
    if (row > 0) set_last(row - 1);
    if (!is_first) keep_last();
  }
  set_last(times.size() - 1);
  has_last_ = true;
  kept_.add(few_.take());
}

void Thinner::keep_last() {
  double* row = few_.add();
  for (std::size_t i = 0; i < last_.size(); ++i) row[i] = static_cast<double>(last_[i]) / specs_[i].scale;
}

void Thinner::finish() {
  if (!std::exchange(has_last_, false)) return;
  keep_last();
  kept_.add(few_.take());
}

}  // namespace robosim::record
