// Compresses recordings in the zlib format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "sim/record/compressed_bytes.h"

struct z_stream_s;

namespace robosim::record {

/// Compresses each piece with zlib's fastest level. The output of a piece does not refer to earlier pieces,
/// and ends at a byte boundary.
class Deflater final : public Packer {
 public:
  Deflater();
  ~Deflater() override;
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;

  void pack(std::string_view piece, Packed& to) override;
  std::string unpacked(std::string_view packed, std::size_t unpacked_size) override;

 private:
  std::unique_ptr<z_stream_s> stream_, unpacking_;  ///< unpacking_ is null until needed
};

/// A callback that receives the output, piece by piece.
using Put = std::function<void(std::string_view)>;

/// Writes a complete zlib stream from compressed bytes.
class Compressed {
 public:
  explicit Compressed(const Put& put) : put_(put) { put_("\x78\x01"); }  // 32 KB window, fastest level
  void add(const CompressedBytes& bytes);
  void add(std::string_view bytes);
  /// Ends the stream.
  void finish();

 private:
  void add(const Packer::Packed& packed);

  const Put& put_;
  Deflater deflater_;
  std::uint32_t checksum_ = 1;
};

std::string deflated(std::string_view bytes);
/// Unpacks bytes piece by piece. Throws InputError if the bytes are damaged or truncated. If `put` throws,
/// unpacking stops, and the caller receives the exception.
void inflate(std::string_view bytes, const Put& put);
/// Unpacks the result of deflated(). Throws InputError if `bytes` are damaged or truncated, or if the
/// unpacked text is longer than `most_bytes`.
std::string inflated(std::string_view bytes, std::size_t most_bytes);

}  // namespace robosim::record
