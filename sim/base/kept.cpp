#include "sim/base/kept.h"

#include <cstring>

namespace robosim {

void Kept::add_bytes(void* begin, std::size_t size) {
  bytes_.push_back({static_cast<std::byte*>(begin), size});
  size_ += size;
}

Kept::Copy Kept::copy() const {
  Copy copy;
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

void Kept::put_back(const Copy& copy) {
  const std::byte* from = copy.bytes.data();
  for (const Bytes& piece : bytes_) {
    std::memcpy(piece.begin, from, piece.size);
    from += piece.size;
  }
  for (std::size_t i = 0; i < values_.size(); ++i) values_[i].put_back(values_[i].at, copy.values[i]);
}

}  // namespace robosim
