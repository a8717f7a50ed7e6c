// Implements an array that grows without copies. Elements stay at their addresses, in chunks of equal size,
// so the array never needs memory for two copies.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace robosim::cells {

template <class T>
class Chunks {
 public:
  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const { return chunks_[i / kChunk][i % kChunk]; }
  T& operator[](std::size_t i) { return chunks_[i / kChunk][i % kChunk]; }
  void push_back(const T& element) {
    if (size_ == chunks_.size() * kChunk) chunks_.push_back(std::make_unique_for_overwrite<T[]>(kChunk));
    (*this)[size_++] = element;
  }
  void clear() {
    chunks_.clear();
    size_ = 0;
  }

 private:
  static constexpr std::size_t kChunk = 512;
  std::vector<std::unique_ptr<T[]>> chunks_;
  std::size_t size_ = 0;
};

}  // namespace robosim::cells
