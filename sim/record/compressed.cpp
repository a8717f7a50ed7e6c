#include "sim/record/compressed.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sim/base/error.h"

namespace robosim::record {
namespace {

constexpr int kFastest = 1, kMemory = 7;  // kMemory is small: zlib clears part of its memory for each piece
constexpr int kBare = -15;                // raw deflate without zlib header or checksum; window of 32 KB
constexpr std::size_t kPiece = std::size_t{1} << 16;
constexpr std::string_view kLastBlock("\x03\x00", 2);  // an empty block

Bytef* bytes_of(const char* text) { return reinterpret_cast<Bytef*>(const_cast<char*>(text)); }

[[noreturn]] void cannot_begin() { throw std::runtime_error("zlib cannot begin"); }

}  // namespace

Deflater::Deflater() : stream_(new z_stream{}) {
  if (deflateInit2(stream_.get(), kFastest, Z_DEFLATED, kBare, kMemory, Z_DEFAULT_STRATEGY) != Z_OK)
    cannot_begin();
}

Deflater::~Deflater() {
  deflateEnd(stream_.get());
  if (unpacking_) inflateEnd(unpacking_.get());
}

void Deflater::pack(std::string_view piece, Packed& to) {
  z_stream& stream = *stream_;
  deflateReset(&stream);
  stream.next_in = bytes_of(piece.data());
  stream.avail_in = static_cast<uInt>(piece.size());
  char buffer[4096];
  do {
    stream.next_out = bytes_of(buffer);
    stream.avail_out = sizeof buffer;
    deflate(&stream, Z_SYNC_FLUSH);
    to.bytes.append(buffer, sizeof buffer - stream.avail_out);
  } while (stream.avail_out == 0);
  to.checksum = static_cast<std::uint32_t>(
      adler32(to.checksum, bytes_of(piece.data()), static_cast<uInt>(piece.size())));
  to.unpacked_size += piece.size();
}

std::string Deflater::unpacked(std::string_view packed, std::size_t unpacked_size) {
  if (!unpacking_) {
    auto fresh = std::make_unique<z_stream>();
    if (inflateInit2(fresh.get(), kBare) != Z_OK) cannot_begin();
    unpacking_ = std::move(fresh);
  }
  z_stream& stream = *unpacking_;
  inflateReset(&stream);
  std::string out(unpacked_size, '\0');
  stream.next_in = bytes_of(packed.data());
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = bytes_of(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  ::inflate(&stream, Z_SYNC_FLUSH);
  return out;
}

void Compressed::add(const CompressedBytes& bytes) {
  add(bytes.packed());
  add(bytes.rest());
}

void Compressed::add(std::string_view bytes) {
  if (bytes.empty()) return;
  Packer::Packed packed;
  deflater_.pack(bytes, packed);
  add(packed);
}

void Compressed::add(const Packer::Packed& packed) {
  put_(packed.bytes);
  checksum_ = static_cast<std::uint32_t>(
      adler32_combine(checksum_, packed.checksum, static_cast<z_off_t>(packed.unpacked_size)));
}

void Compressed::finish() {
  std::string end(kLastBlock);
  for (int shift = 24; shift >= 0; shift -= 8) end += static_cast<char>(checksum_ >> shift);
  put_(end);
}

std::string deflated(std::string_view bytes) {
  std::string out;
  const Put put = [&out](std::string_view piece) { out += piece; };
  Compressed compressed(put);
  compressed.add(bytes);
  compressed.finish();
  return out;
}

void inflate(std::string_view bytes, const Put& put) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) cannot_begin();
  const std::unique_ptr<z_stream, void (*)(z_stream*)> ends(&stream, [](z_stream* s) { inflateEnd(s); });
  stream.next_in = bytes_of(bytes.data());
  stream.avail_in = static_cast<uInt>(std::min<std::size_t>(bytes.size(), UINT32_MAX));
  std::vector<char> piece(kPiece);
  int status = Z_OK;
  while (status == Z_OK) {
    stream.next_out = bytes_of(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    status = ::inflate(&stream, Z_NO_FLUSH);
    put({piece.data(), piece.size() - stream.avail_out});
  }
  if (status != Z_STREAM_END) throw InputError("its data are damaged or cut off");
}

std::string inflated(std::string_view bytes, std::size_t most_bytes) {
  std::string out;
  inflate(bytes, [&](std::string_view piece) {
    if (piece.size() > most_bytes - out.size()) throw InputError("its content is too large");
    out += piece;
  });
  return out;
}

}  // namespace robosim::record
