// Bytes of a recording that come in piece by piece and are compressed as they do, so that next to nothing is
// left to do when the run is over.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace robosim::record {

/// Compresses pieces, each by itself: sim/record/compressed.h.
class Packer {
 public:
  /// Bytes, packed; what was packed further pieces may follow.
  struct Packed {
    std::string bytes;
    std::size_t unpacked_size = 0;
    std::uint32_t checksum = 1;  ///< Adler-32 of what they were
  };

  virtual ~Packer() = default;
  /// Adds a piece.
  virtual void pack(std::string_view piece, Packed& to) = 0;
  virtual std::string unpacked(const Packed& packed) = 0;
};

class KeptBytes {
 public:
  /// Without a packer (null) they are kept as they are.
  explicit KeptBytes(Packer* packer = nullptr) : packer_(packer) {}

  void add(std::string_view bytes) {
    rest_ += bytes;
    if (packer_ && rest_.size() >= kPiece_bytes) pack_rest();
  }
  std::size_t size() const { return packed_.unpacked_size + rest_.size(); }
  std::string all() const { return packed_.bytes.empty() ? rest_ : packer_->unpacked(packed_) + rest_; }

  const Packer::Packed& packed() const { return packed_; }
  /// What has not been packed yet.
  std::string_view rest() const { return rest_; }

 private:
  // Larger ones are a little shorter in the end; but of each column half of one is left when the run is over.
  static constexpr std::size_t kPiece_bytes = 4096;

  void pack_rest() {
    packer_->pack(rest_, packed_);
    rest_.clear();
  }

  Packer* packer_;
  Packer::Packed packed_;
  std::string rest_;
};

}  // namespace robosim::record
