#include "sim/record/kept_stream.h"

#include "sim/wire/json_reader.h"

namespace robosim::record {

void KeptStream::add(const wire::Rows& rows) {
  if (specs_.empty()) {
    specs_ = rows.columns;
    all_ = KeptRows(specs_.size(), packer_);
  }
  if (rows.bytes.size() != specs_.size() || specs_.empty())
    throw wire::BadValue("bytes", "expected as many as the columns of " + rows.stream);
  if (is_thin_) return thinner_->add(rows.bytes, rows.count);
  all_.add(rows);
  // Twice as fast as rows arrive: it has caught up when they have doubled.
  constexpr std::size_t kFaster = 2;
  if (thinner_) thinner_->follow(all_, kFaster * static_cast<std::size_t>(rows.count));
}

void KeptStream::prepare_to_thin(std::int64_t span_ns) {
  if (!thinner_ && !specs_.empty()) thinner_.emplace(specs_, span_ns, packer_);
}

void KeptStream::thin(std::int64_t span_ns) {
  prepare_to_thin(span_ns);
  if (is_thin_ || !thinner_) return;
  thinner_->catch_up(all_);
  all_ = KeptRows(0, packer_);
  is_thin_ = true;
}

std::size_t KeptStream::bytes() const {
  std::size_t bytes = 0;
  for (const KeptBytes& column : kept().columns) bytes += column.size();
  return bytes;
}

StreamInfo KeptStream::finish(const std::string& name, std::vector<const KeptBytes*>& body) {
  if (is_thin_) thinner_->finish();
  StreamInfo info{name, kept().count, {}};
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    const KeptBytes& column = kept().columns[i];
    info.columns.push_back(
        {specs_[i].name, specs_[i].scale, specs_[i].order, static_cast<std::int64_t>(column.size())});
    body.push_back(&column);
  }
  return info;
}

}  // namespace robosim::record
