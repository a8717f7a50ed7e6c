#include "sim/record/compressed_stream.h"

#include "sim/wire/json_reader.h"

namespace robosim::record {

void CompressedStream::add(const wire::Rows& rows) {
  if (specs_.empty()) {
    specs_ = rows.columns;
    all_ = CompressedRows(specs_.size(), packer_);
  }
  if (rows.bytes.size() != specs_.size() || specs_.empty())
    throw wire::BadValue("bytes", "expected one text for each column of " + rows.stream);
  if (is_thin_) return thinner_->add(rows.bytes, rows.count);
  all_.add(rows);
  // The thinner reads two earlier rows for each new row. It has therefore caught up when the number of rows
  // has doubled.
  constexpr std::size_t kFaster = 2;
  if (thinner_) thinner_->follow(all_, kFaster * static_cast<std::size_t>(rows.count));
}

void CompressedStream::prepare_to_thin(std::int64_t span_ns) {
  if (!thinner_ && !specs_.empty()) thinner_.emplace(specs_, span_ns, packer_);
}

void CompressedStream::thin(std::int64_t span_ns) {
  prepare_to_thin(span_ns);
  if (is_thin_ || !thinner_) return;
  thinner_->catch_up(all_);
  all_ = CompressedRows(0, packer_);
  is_thin_ = true;
}

std::size_t CompressedStream::bytes() const {
  std::size_t bytes = 0;
  for (const CompressedBytes& column : kept().columns) bytes += column.size();
  return bytes;
}

StreamInfo CompressedStream::finish(const std::string& name, std::vector<const CompressedBytes*>& body) {
  if (is_thin_) thinner_->finish();
  StreamInfo info{name, kept().count, {}};
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    const CompressedBytes& column = kept().columns[i];
    info.columns.push_back(
        {specs_[i].name, specs_[i].scale, specs_[i].order, static_cast<std::int64_t>(column.size())});
    body.push_back(&column);
  }
  return info;
}

}  // namespace robosim::record
