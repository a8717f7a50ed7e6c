#include "sim/record/kept_stream.h"

#include "sim/wire/json_reader.h"

namespace robosim::record {

void KeptStream::add(const wire::Rows& rows) {
  if (specs_.empty()) {
    specs_ = rows.columns;
    bytes_.resize(specs_.size());
  }
  if (rows.bytes.size() != specs_.size() || specs_.empty())
    throw wire::BadValue("bytes", "must be as many as the columns of " + rows.stream);
  if (thinned_) return add_thinned(rows.bytes, rows.count);
  for (std::size_t i = 0; i < bytes_.size(); ++i) bytes_[i] += rows.bytes[i];
  count_ += rows.count;
}

void KeptStream::thin(std::int64_t span_ns) {
  if (thinned_ || specs_.empty()) return;
  thinned_.emplace(Thinned{span_ns, {}, wire::Stream("", specs_), {}});
  for (const wire::ColumnSpec& spec : specs_) thinned_->readers.emplace_back(spec.order);
  add_thinned(bytes_, count_);
  bytes_.clear();
}

void KeptStream::add_thinned(const std::vector<std::string>& bytes, std::int64_t count) {
  std::vector<std::vector<std::int64_t>> columns;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    auto values = thinned_->readers[i].read(bytes[i], static_cast<std::size_t>(count));
    if (!values) throw wire::BadValue("bytes", "must hold as many numbers as there are rows");
    columns.push_back(std::move(*values));
  }
  auto& pending = thinned_->pending;
  for (std::size_t row = 0; row < static_cast<std::size_t>(count); ++row) {
    const auto span = [&](std::int64_t t_ns) { return t_ns / thinned_->span_ns; };
    if (!pending.empty() && span(columns[0][row]) != span(static_cast<std::int64_t>(pending[0])))
      thinned_->few.add(pending.data());
    pending.clear();
    for (std::size_t i = 0; i < columns.size(); ++i)
      pending.push_back(static_cast<double>(columns[i][row]) / specs_[i].scale);
  }
}

std::size_t KeptStream::bytes() const {
  std::size_t bytes = 0;
  for (const std::string& column : bytes_) bytes += column.size();
  return bytes;
}

std::vector<double> KeptStream::column(const std::string& name) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < specs_.size() && !thinned_; ++i) {
    if (specs_[i].name != name) continue;
    const auto steps = wire::ColumnReader(specs_[i].order).read(bytes_[i], static_cast<std::size_t>(count_));
    if (!steps) return {};
    for (const std::int64_t step : *steps) values.push_back(static_cast<double>(step) / specs_[i].scale);
  }
  return values;
}

StreamInfo KeptStream::write(const std::string& name, std::string& body) {
  if (thinned_ && !thinned_->pending.empty()) {
    thinned_->few.add(thinned_->pending.data());
    thinned_->pending.clear();
  }
  StreamInfo info{name, thinned_ ? thinned_->few.count() : count_, {}};
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    const std::string_view bytes = thinned_ ? thinned_->few.columns()[i].bytes() : bytes_[i];
    info.columns.push_back(
        {specs_[i].name, specs_[i].scale, specs_[i].order, static_cast<std::int64_t>(bytes.size())});
    body += bytes;
  }
  return info;
}

}  // namespace robosim::record
