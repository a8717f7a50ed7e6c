#include "sim/map/png_rows.h"

#include <fmt/format.h>
#include <png.h>

#include <csetjmp>
#include <cstring>
#include <vector>

#include "sim/base/error.h"
#include "sim/map/floor_image.h"

namespace robosim::map {
namespace {

constexpr png_uint_32 kMostSide_pixels = 100'000;
constexpr png_alloc_size_t kMostChunk_bytes = 1 << 20;  // for chunks that libpng stores; not for the picture

// libpng reports errors by longjmp(). No object between setjmp() and longjmp() may have a destructor.
struct Decoder {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string_view left;
  char problem[120] = "";

  ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  auto* decoder = static_cast<Decoder*>(png_get_error_ptr(png));
  std::strncpy(decoder->problem, message, sizeof decoder->problem - 1);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void take_bytes(png_structp png, png_bytep to, std::size_t count) {
  auto* decoder = static_cast<Decoder*>(png_get_io_ptr(png));
  if (decoder->left.size() < count) png_error(png, "the file is truncated");
  std::memcpy(to, decoder->left.data(), count);
  decoder->left.remove_prefix(count);
}

bool begin_reading(Decoder& decoder) {
  if (setjmp(png_jmpbuf(decoder.png))) return false;
  png_set_crc_action(decoder.png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  png_set_user_limits(decoder.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_chunk_malloc_max(decoder.png, kMostChunk_bytes);
  png_set_read_fn(decoder.png, &decoder, take_bytes);
  png_read_info(decoder.png, decoder.info);
  return true;
}

bool begin_rows(Decoder& decoder) {
  if (setjmp(png_jmpbuf(decoder.png))) return false;
  png_set_expand(decoder.png);
  png_set_scale_16(decoder.png);
  png_read_update_info(decoder.png, decoder.info);
  return true;
}

bool read_row(Decoder& decoder, png_bytep row) {
  if (setjmp(png_jmpbuf(decoder.png))) return false;
  png_read_row(decoder.png, row, nullptr);
  return true;
}

bool end_reading(Decoder& decoder) {
  if (setjmp(png_jmpbuf(decoder.png))) return false;
  png_read_end(decoder.png, nullptr);
  return true;
}

// Returns the grey value of a pixel, blended over white.
unsigned char value_of(const unsigned char* pixel, int channels) {
  unsigned value = pixel[0];
  if (channels >= 3) value = (2126u * pixel[0] + 7152u * pixel[1] + 722u * pixel[2] + 5000u) / 10000u;
  if (channels % 2 == 0) {
    const unsigned alpha = pixel[channels - 1];
    value = (value * alpha + 255u * (255u - alpha) + 127u) / 255u;
  }
  return static_cast<unsigned char>(value);
}

}  // namespace

void read_png(std::string_view bytes, const std::string& file, const std::function<void(int, int)>& begin,
              const std::function<void(std::span<const unsigned char>)>& row) {
  if (!bytes.starts_with("\x89PNG\r\n\x1a\n")) throw InputError({file}, "this is not a PNG file");
  Decoder decoder;
  decoder.left = bytes;
  decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, on_error, on_warning);
  decoder.info = decoder.png ? png_create_info_struct(decoder.png) : nullptr;
  if (!decoder.info) throw std::bad_alloc();
  const auto require = [&](bool good) {
    if (!good) throw InputError({file}, fmt::format("the PNG is damaged: {}", decoder.problem));
  };
  require(begin_reading(decoder));
  const png_uint_32 width = png_get_image_width(decoder.png, decoder.info);
  const png_uint_32 height = png_get_image_height(decoder.png, decoder.info);
  if (width > kMostSide_pixels || height > kMostSide_pixels ||
      std::size_t{width} * height > FloorImage::kMostPixels)
    throw InputError(
        {file},
        fmt::format("the picture is too large: expected at most {} pixels a side and {} million in all, got "
                    "{} x {}",
                    kMostSide_pixels, FloorImage::kMostPixels / 1'000'000, width, height));
  if (png_get_interlace_type(decoder.png, decoder.info) != PNG_INTERLACE_NONE)
    throw InputError({file}, "the PNG is interlaced; save it without interlacing");
  require(begin_rows(decoder));
  const int channels = png_get_channels(decoder.png, decoder.info);
  std::vector<unsigned char> pixels(png_get_rowbytes(decoder.png, decoder.info)), values(width);
  begin(static_cast<int>(width), static_cast<int>(height));
  for (png_uint_32 y = 0; y < height; ++y) {
    require(read_row(decoder, pixels.data()));
    for (std::size_t x = 0; x < width; ++x)
      values[x] = value_of(&pixels[x * static_cast<std::size_t>(channels)], channels);
    row(values);
  }
  require(end_reading(decoder));
}

}  // namespace robosim::map
