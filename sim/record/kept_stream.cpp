#include "sim/record/kept_stream.h"

#include <utility>

#include "sim/wire/json_reader.h"

namespace robosim::record {

void KeptStream::add(const wire::Rows& rows) {
  if (specs_.empty()) {
    specs_ = rows.columns;
    columns_.assign(specs_.size(), KeptBytes(packer_));
  }
  if (rows.bytes.size() != specs_.size() || specs_.empty())
    throw wire::BadValue("bytes", "must be as many as the columns of " + rows.stream);
  thinned_ ? add_thinned(rows.bytes, rows.count) : keep(rows);
}

void KeptStream::keep(const wire::Rows& rows) {
  for (std::size_t i = 0; i < rows.bytes.size(); ++i) columns_[i].add(rows.bytes[i]);
  count_ += rows.count;
}

void KeptStream::thin(std::int64_t span_ns) {
  if (thinned_ || specs_.empty()) return;
  thinned_.emplace(Thinned{span_ns, {}, wire::Stream("", specs_), {}});
  for (const wire::ColumnSpec& spec : specs_) thinned_->readers.emplace_back(spec.order);
  std::vector<std::string> bytes;
  for (KeptBytes& column : columns_) {
    bytes.push_back(column.all());
    column = KeptBytes(packer_);
  }
  add_thinned(bytes, std::exchange(count_, 0));
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
  keep(thinned_->few.take());
}

std::size_t KeptStream::bytes() const {
  std::size_t bytes = 0;
  for (const KeptBytes& column : columns_) bytes += column.size();
  return bytes;
}

StreamInfo KeptStream::finish(const std::string& name, std::vector<const KeptBytes*>& body) {
  if (thinned_ && !thinned_->pending.empty()) {
    thinned_->few.add(thinned_->pending.data());
    thinned_->pending.clear();
    keep(thinned_->few.take());
  }
  StreamInfo info{name, count_, {}};
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    info.columns.push_back(
        {specs_[i].name, specs_[i].scale, specs_[i].order, static_cast<std::int64_t>(columns_[i].size())});
    body.push_back(&columns_[i]);
  }
  return info;
}

}  // namespace robosim::record
