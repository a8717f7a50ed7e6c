#include "sim/map/floor_image.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "sim/base/file.h"
#include "sim/map/map_writer.h"
#include "tests/support/png_file.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace robosim::map::floor_image_test {

using test::grey_png;
using test::png_of;
using ::testing::HasSubstr;

std::uint8_t noise(int x, int y) { return static_cast<std::uint8_t>((x * 7919 + y * 104729 + x * y) % 256); }

std::string text_of(const std::string& more = "", const std::string& pixel = "pixel = \"1 mm\"\n") {
  return "+++\nfloor = \"floor.png\"\n" + pixel + "line = \"10 mm\"\n" + more + "+++\n";
}

const std::string kPath = "[[path]]\nfrom = [\"20 mm\", \"50 mm\"]\nsegments = [{ length = \"100 mm\" }]\n";
const std::string kPicture = grey_png(200, 100, [](int, int y) { return y >= 45 && y < 55 ? 0 : 255; });

struct Folder : test::TemporaryFolder {
  std::filesystem::path operator/(const char* name) const { return path() / name; }
};

template <class Act>
std::string message_of(Act act) {
  return test::refusal([&] { act(); }, "no error");
}

// Compares the mean with a reference that adds up all pixels in floating point.
TEST(FloorImage, ItsMeanOverARectangleIsThatOfThePixelsInIt) {
  constexpr int kWide = 37, kHigh = 23;
  constexpr double kPixel = 0.0005;
  const FloorImage image(grey_png(kWide, kHigh, noise), "floor.png", kPixel);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-3.0, 40.0), side(0.05, 30.0);
  for (int i = 0; i < 300; ++i) {
    const double left = place(random), low = place(random), wide = side(random), high = side(random);
    double dark = 0.0;
    for (int y = 0; y < kHigh; ++y)
      for (int x = 0; x < kWide; ++x) {
        const double over_x = std::max(std::min(left + wide, x + 1.0) - std::max(left, 1.0 * x), 0.0);
        const double over_y = std::max(std::min(low + high, y + 1.0) - std::max(low, 1.0 * y), 0.0);
        dark += over_x * over_y * (255 - noise(x, kHigh - 1 - y)) / 255.0;
      }
    EXPECT_NEAR(image.darkness_in(Vec2{left, low} * kPixel, Vec2{left + wide, low + high} * kPixel),
                dark / (wide * high), 1e-9);
  }
}

TEST(FloorImage, EveryKindOfPngIsRead) {
  struct Case {
    const char* what;
    test::PngKind kind;
    std::string pixel;
    int dark;
  };
  using std::string_literals::operator""s;
  for (const Case& c : {Case{"grey", {8, PNG_COLOR_TYPE_GRAY}, "\x33", 204},
                        Case{"16 bits", {16, PNG_COLOR_TYPE_GRAY}, "\x33\x33", 204},
                        Case{"black of 1 bit", {1, PNG_COLOR_TYPE_GRAY}, "\0"s, 255},
                        Case{"white of 2 bits", {2, PNG_COLOR_TYPE_GRAY}, "\xC0", 0},
                        Case{"colours", {8, PNG_COLOR_TYPE_RGB}, "\xFF\0\0"s, 201},
                        Case{"colours of 16 bits", {16, PNG_COLOR_TYPE_RGB}, "\0\0\xFF\xFF\0\0"s, 73},
                        Case{"half transparent black", {8, PNG_COLOR_TYPE_RGB_ALPHA}, "\0\0\0\x80"s, 128},
                        Case{"transparent", {8, PNG_COLOR_TYPE_GRAY_ALPHA}, "\0\0"s, 0},
                        Case{"palette", {4, PNG_COLOR_TYPE_PALETTE}, "\x20", 73}}) {
    const FloorImage image(png_of(1, 1, {c.pixel}, c.kind), "floor.png", 0.001);
    EXPECT_EQ(image.at(0, 0), c.dark) << c.what;
  }
}

TEST(FloorImage, AMapHasItFromItsFolderWithTheSizeOfThePicture) {
  const Folder folder;
  write_file(folder / "floor.png", kPicture);
  write_file(folder / "my.map", text_of("goal = \"none\"\n" + kPath));
  const Map map = read_map(folder / "my.map");
  ASSERT_TRUE(map.image);
  EXPECT_EQ(map.width, 2);
  EXPECT_EQ(map.height, 1);
  EXPECT_NEAR(map.image->darkness({0.1, 0.05}, 0.005), 1.0, 1e-12);
  EXPECT_NEAR(map.image->darkness({0.1, 0.045}, 0.005), 0.5, 1e-12);
  const Map again = parse_map(write_map(map), (folder / "my.map").string());
  EXPECT_EQ(again.image->png(), kPicture);
  EXPECT_EQ(again.image->pixel_m(), 0.001);
}

TEST(FloorImage, TheHashOfAMapIsThatOfItsFileAndItsPictureTogether) {
  const Folder folder;
  const std::string small = text_of(kPath);
  std::string large = text_of();
  for (int row = 0; row < 150; ++row) large += std::string(2000, '.') + "\n";
  write_file(folder / "floor.png", kPicture);
  for (const std::string& text : {small, large}) {
    write_file(folder / "my.map", text);
    EXPECT_EQ(sha256_of(read_map(folder / "my.map")), sha256(text + kPicture));
    EXPECT_EQ(sha256_of_map(folder / "my.map"), sha256(text + kPicture));
  }
  write_file(folder / "plain.map", "...\n");
  EXPECT_EQ(sha256_of_map(folder / "plain.map"), sha256("...\n"));
}

TEST(FloorImage, BadPicturesAreToldInASentence) {
  const Folder folder;
  const std::string huge_header = [] {
    std::string png = grey_png(4, 4, noise);
    png.replace(16, 8, std::string("\0\0\xFF\xFF\0\0\xFF\xFF", 8));  // changes the size, but not the CRC
    return png;
  }();
  std::string wrong_crc = grey_png(60, 60, noise);
  wrong_crc[wrong_crc.size() - 14] ^= 1;
  const auto cut = [](std::size_t bytes) { return grey_png(60, 60, noise).substr(0, bytes); };
  struct Case {
    std::string png, message;
  };
  for (const Case& c :
       {Case{"", "floor.png: this is not a PNG file"}, Case{"GIF89a", "floor.png: this is not a PNG file"},
        Case{cut(20), "floor.png: the PNG is damaged: the file is truncated"},
        Case{cut(400), "floor.png: the PNG is damaged: the file is truncated"},
        Case{wrong_crc, "floor.png: the PNG is damaged: IDAT: CRC error"},
        Case{huge_header, "floor.png: the PNG is damaged: IHDR: CRC error"},
        Case{png_of(9, 9, std::vector<std::string>(9, std::string(9, 'x')),
                    {8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_ADAM7}),
             "floor.png: the PNG is interlaced; save it without interlacing"},
        Case{grey_png(1, 1, noise),
             "my.map:2:9: the picture is too small: expected at least the width of the line, 10 mm, got 1 x "
             "1 mm; is pixel = \"1 "
             "mm\""}}) {
    write_file(folder / "floor.png", c.png);
    write_file(folder / "my.map", text_of(kPath));
    EXPECT_THAT(message_of([&] { read_map(folder / "my.map"); }), HasSubstr(c.message));
  }
}

// A decompression bomb: the header of a tiny file announces 100,000 x 100,000 pixels.
TEST(FloorImage, AHugePictureIsRefusedByItsHeader) {
  std::string png;
  {
    png_structp write = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(write);
    png_set_write_fn(
        write, &png,
        [](png_structp from, png_bytep data, std::size_t size) {
          static_cast<std::string*>(png_get_io_ptr(from))->append(reinterpret_cast<char*>(data), size);
        },
        nullptr);
    png_set_IHDR(write, info, 100'000, 100'000, 1, PNG_COLOR_TYPE_GRAY, 0, 0, 0);
    png_write_info(write, info);
    png_destroy_write_struct(&write, &info);
  }
  png += std::string("\0\1\0\0IDAT", 8);
  EXPECT_THAT(message_of([&] { FloorImage(png, "bomb.png", 0.001); }),
              "bomb.png: the picture is too large: expected at most 100000 pixels a side and 50 million in "
              "all, got 100000 x 100000");
}

TEST(FloorImage, BadKeysAreToldInASentence) {
  const Folder folder;
  write_file(folder / "floor.png", kPicture);
  struct Case {
    std::string text, message;
  };
  for (const Case& c :
       {Case{"+++\nfloor = \"gone.png\"\npixel = \"1 mm\"\n+++\n", "my.map:2:9: the picture gone.png "},
        Case{"+++\nfloor = \"../floor.png\"\npixel = \"1 mm\"\n+++\n",
             "my.map:2:9: floor: expected the name of a picture next to the map, without folders, got "
             "\"../floor.png\""},
        Case{"+++\nfloor = \"/etc/floor.png\"\npixel = \"1 mm\"\n+++\n", "without folders"},
        Case{"+++\nfloor = \"floor.jpg\"\n+++\n", "expected stripes, raster or the name of a picture"},
        Case{"+++\nfloor = \"floor.png\"\n+++\n", "my.map:2:9: a picture requires the side of a pixel"},
        Case{"+++\npixel = \"1 mm\"\n+++\n..\n", "my.map:2:9: pixel requires a picture"},
        Case{text_of(kPath, "pixel = \"1\"\n"), "my.map:3:9: "},
        Case{text_of(kPath, "pixel = \"1 m\"\n"), "my.map:3:9: "},
        Case{text_of("size = [\"100 mm\", \"100 mm\"]\n" + kPath),
             "the picture is larger than the floor: expected at most 100 x 100 mm"},
        Case{text_of() + "..\n__\n", "no error"},
        Case{text_of() + ".\n.\n", "the picture is larger than the floor: expected at most 100 x 200 mm"},
        Case{text_of(kPath + "[[mark]]\nalong = \"10 mm\"\n"), "everything painted is in the picture"}}) {
    write_file(folder / "my.map", c.text);
    EXPECT_THAT(message_of([&] { read_map(folder / "my.map"); }), HasSubstr(c.message)) << c.text;
  }
  write_file(folder / "my.map", text_of());
  EXPECT_THAT(message_of([&] { default_start(read_map(folder / "my.map")); }),
              HasSubstr("the floor is a picture without a [[path]] along its line"));
}

}  // namespace robosim::map::floor_image_test
