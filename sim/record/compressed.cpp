#include "sim/record/compressed.h"

#include <libdeflate.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>

#include "sim/base/error.h"

namespace robosim::record {
namespace {

constexpr int kFastest = 1;
constexpr std::size_t kPiece = std::size_t{1} << 16;

Bytef* bytes_of(const char* text) { return reinterpret_cast<Bytef*>(const_cast<char*>(text)); }

}  // namespace

std::string deflated(std::string_view bytes) {
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(kFastest), &libdeflate_free_compressor);
  if (!compressor) throw std::runtime_error("libdeflate cannot begin");
  std::string out(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
  out.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), out.data(), out.size()));
  return out;
}

std::string inflated(std::string_view bytes, std::size_t most_bytes) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) throw std::runtime_error("zlib cannot begin");
  stream.next_in = bytes_of(bytes.data());
  stream.avail_in = static_cast<uInt>(std::min<std::size_t>(bytes.size(), UINT32_MAX));
  std::string out;
  int status = Z_OK;
  while (status == Z_OK && out.size() <= most_bytes) {
    const std::size_t begin = out.size();
    out.resize(begin + std::max(kPiece, begin));
    stream.next_out = bytes_of(out.data() + begin);
    stream.avail_out = static_cast<uInt>(std::min<std::size_t>(out.size() - begin, UINT32_MAX));
    status = inflate(&stream, Z_NO_FLUSH);
    out.resize(stream.total_out);
  }
  inflateEnd(&stream);
  if (status != Z_STREAM_END) throw InputError("its data are damaged or cut off");
  if (out.size() > most_bytes) throw InputError("it holds too much");
  return out;
}

}  // namespace robosim::record
