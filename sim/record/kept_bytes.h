// Bytes of a recording that come in piece by piece and are compressed as they do, so that next to nothing is
// left to do when the run is over.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

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
  /// One piece, or several that follow each other.
  virtual std::string unpacked(std::string_view packed, std::size_t unpacked_size) = 0;
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
  std::string all() const {
    return packed_.bytes.empty() ? rest_ : packer_->unpacked(packed_.bytes, packed_.unpacked_size) + rest_;
  }

  const Packer::Packed& packed() const { return packed_; }
  /// How many pieces were packed.
  std::size_t pieces() const { return ends_.size(); }
  /// One of them, unpacked.
  std::string piece(std::size_t number) const {
    const End begin = number > 0 ? ends_[number - 1] : End{}, end = ends_[number];
    return packer_->unpacked(std::string_view(packed_.bytes).substr(begin.packed, end.packed - begin.packed),
                             end.unpacked - begin.unpacked);
  }
  /// What has not been packed yet.
  std::string_view rest() const { return rest_; }

 private:
  // Larger ones are a little shorter in the end; but of each column half of one is left when the run is over.
  static constexpr std::size_t kPiece_bytes = 4096;

  void pack_rest() {
    packer_->pack(rest_, packed_);
    ends_.push_back({packed_.bytes.size(), packed_.unpacked_size});
    rest_.clear();
  }

  Packer* packer_;
  /// Of a piece, counted from the first one's begin.
  struct End {
    std::size_t packed = 0, unpacked = 0;
  };

  Packer::Packed packed_;
  std::vector<End> ends_;
  std::string rest_;
};

}  // namespace robosim::record
