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

/// Packs like zlib's fastest level, into blocks that do not refer to earlier blocks and end with a whole
/// byte.
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

/// Receives output, piece by piece.
using Put = std::function<void(std::string_view)>;

/// Writes a whole stream from packed bytes.
class Compressed {
 public:
  explicit Compressed(const Put& put) : put_(put) { put_("\x78\x01"); }  // window of 32 KB, fastest level
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
/// Unpacks bytes piece by piece. Throws InputError if the bytes are damaged or truncated. An exception of
/// `put` stops the unpacking, and is passed on.
void inflate(std::string_view bytes, const Put& put);
/// Unpacks the result of deflated(). Throws InputError if it is damaged or truncated, or longer than
/// `most_bytes`.
std::string inflated(std::string_view bytes, std::size_t most_bytes);

}  // namespace robosim::record
