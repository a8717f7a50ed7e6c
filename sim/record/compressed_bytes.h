// Compresses the bytes of a recording as they arrive, so that almost no work is left at the end of the run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::record {

/// The interface of a compressor whose pieces can be unpacked independently. Deflater
/// (sim/record/compressed.h) implements it.
class Packer {
 public:
  /// Packed bytes. Further pieces can be appended.
  struct Packed {
    std::string bytes;
    std::size_t unpacked_size = 0;
    std::uint32_t checksum = 1;  ///< Adler-32 of the unpacked bytes
  };

  virtual ~Packer() = default;
  /// Compresses a piece, and appends the result to `to`.
  virtual void pack(std::string_view piece, Packed& to) = 0;
  /// Unpacks one piece, or several consecutive pieces.
  virtual std::string unpacked(std::string_view packed, std::size_t unpacked_size) = 0;
};

class CompressedBytes {
 public:
  /// Without a packer (null), bytes are stored unchanged.
  explicit CompressedBytes(Packer* packer = nullptr) : packer_(packer) {}

  void add(std::string_view bytes) {
    rest_ += bytes;
    if (packer_ && rest_.size() >= kPiece_bytes) pack_rest();
  }
  std::size_t size() const { return packed_.unpacked_size + rest_.size(); }
  std::string all() const {
    return packed_.bytes.empty() ? rest_ : packer_->unpacked(packed_.bytes, packed_.unpacked_size) + rest_;
  }

  const Packer::Packed& packed() const { return packed_; }
  /// Returns the number of packed pieces.
  std::size_t pieces() const { return ends_.size(); }
  /// Unpacks a packed piece.
  std::string piece(std::size_t number) const {
    const End begin = number > 0 ? ends_[number - 1] : End{}, end = ends_[number];
    return packer_->unpacked(std::string_view(packed_.bytes).substr(begin.packed, end.packed - begin.packed),
                             end.unpacked - begin.unpacked);
  }
  /// Returns the bytes that are not packed yet.
  std::string_view rest() const { return rest_; }

 private:
  // Larger pieces compress slightly better, but leave more work for the end of the run: on average, half a
  // piece of each column is not packed before the end.
  static constexpr std::size_t kPiece_bytes = 4096;

  void pack_rest() {
    packer_->pack(rest_, packed_);
    ends_.push_back({packed_.bytes.size(), packed_.unpacked_size});
    rest_.clear();
  }

  Packer* packer_;
  /// The end of a piece, counted from the beginning of the first piece.
  struct End {
    std::size_t packed = 0, unpacked = 0;
  };

  Packer::Packed packed_;
  std::vector<End> ends_;
  std::string rest_;
};

}  // namespace robosim::record
