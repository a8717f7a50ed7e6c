#include "sim/base/snapshot_registry.h"

#include <cstring>

namespace robosim {

void SnapshotRegistry::add_bytes(void* begin, std::size_t size) {
  bytes_.push_back({static_cast<std::byte*>(begin), size});
  size_ += size;
}

SnapshotRegistry::Snapshot SnapshotRegistry::save() const {
  Snapshot copy;
  copy.bytes.resize(size_);
  std::byte* to = copy.bytes.data();
  for (const Bytes& piece : bytes_) {
    std::memcpy(to, piece.begin, piece.size);
    to += piece.size;
  }
  copy.values.reserve(values_.size());
  for (const Value& piece : values_) copy.values.push_back(piece.copy(piece.at));
  return copy;
}

void SnapshotRegistry::restore(const Snapshot& copy) {
  const std::byte* from = copy.bytes.data();
  for (const Bytes& piece : bytes_) {
    std::memcpy(piece.begin, from, piece.size);
    from += piece.size;
  }
  for (std::size_t i = 0; i < values_.size(); ++i) values_[i].restore(values_[i].at, copy.values[i]);
}

}  // namespace robosim
