// Makes PNGs of all kinds for tests, with libpng.
#pragma once

#include <png.h>

#include <string>
#include <vector>

namespace robosim::test {

struct PngKind {
  int depth = 8, colours = PNG_COLOR_TYPE_GRAY, interlace = PNG_INTERLACE_NONE;
};

/// Makes a picture from the bytes of its rows, in the format that `kind` describes. If the picture has a
/// palette, entry 0 is white, 1 is black, and 2 is pure green.
inline std::string png_of(int width, int height, std::vector<std::string> rows, PngKind kind = {}) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp from, png_bytep data, std::size_t size) {
        static_cast<std::string*>(png_get_io_ptr(from))->append(reinterpret_cast<char*>(data), size);
      },
      nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), kind.depth,
               kind.colours, kind.interlace, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  const png_color palette[] = {{255, 255, 255}, {0, 0, 0}, {0, 255, 0}};
  if (kind.colours == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 3);
  png_write_info(png, info);
  std::vector<png_bytep> pointers;
  for (std::string& row : rows) pointers.push_back(reinterpret_cast<png_bytep>(row.data()));
  png_write_image(png, pointers.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

/// Makes a grey picture with 8 bits per pixel: 0 black .. 255 white.
template <class Value>
std::string grey_png(int width, int height, Value value) {
  std::vector<std::string> rows(static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) rows[static_cast<std::size_t>(y)] += static_cast<char>(value(x, y));
  return png_of(width, height, std::move(rows));
}

}  // namespace robosim::test
