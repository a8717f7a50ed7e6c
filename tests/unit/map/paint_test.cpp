#include "sim/map/paint.h"

#include <gmock/gmock.h>

#include "sim/map/map.h"
#include "sim/map/map_writer.h"
#include "sim/map/stripes.h"
#include "tests/support/refusal.h"

namespace robosim::map::paint_test {

using ::testing::HasSubstr;

std::string text_with(const std::string& top, const std::string& path) {
  return "+++\nsize = [\"2 m\", \"1 m\"]\nline = \"20 mm\"\n" + top +
         "\n[[path]]\nfrom = [\"200 mm\", \"500 mm\"]\n" + path + "\n+++\n";
}

constexpr const char* kThreePaints =
    "segments = [{ length = \"300 mm\" },\n"
    "{ length = \"300 mm\", width = \"12 mm\", worn = \"30 %\" },\n"
    "{ length = \"300 mm\", colour = \"grey 60 %\", gloss = 0.05 }]";

TEST(Paint, IsThatOfTheMapUnlessAPathOrASegmentSaysAnother) {
  const Map map = parse_map(text_with("worn = \"10 %\"\n", kThreePaints), "m.map");
  const std::vector<Paint> paints = paints_of(map);
  ASSERT_EQ(paints.size(), 3u);
  EXPECT_EQ(paints[0], (Paint{0.020, Colour{Hue::black}, 0.1, 0.0}));
  EXPECT_EQ(paints[1], (Paint{0.012, Colour{Hue::black}, 0.3, 0.0}));
  EXPECT_EQ(paints[2], (Paint{0.020, Colour{Hue::grey, 0.6}, 0.1, 0.05}));

  const Map all = parse_map(
      text_with("paint = \"white on black\"\n", std::string("width = \"10 mm\"\n") + kThreePaints), "m.map");
  EXPECT_EQ(paints_of(all)[1], (Paint{0.010, Colour{Hue::white}, 0.0, 0.0}));
  EXPECT_EQ(paints_of(all)[2].width, 0.012);
  EXPECT_EQ(paints_of(all)[3].width, 0.010);
}

TEST(Paint, IsAddedOnceForAllThatHaveTheSame) {
  std::string segments;
  for (int i = 0; i < 60; ++i)
    segments += i % 2 ? "{ length = \"10 mm\" }," : "{ length = \"10 mm\", width = \"12 mm\" },";
  const Map map = parse_map(text_with("", "segments = [" + segments + "]"), "m.map");
  EXPECT_EQ(map.course.paints.size(), 1u);
  EXPECT_FALSE(is_plain(map));
  EXPECT_TRUE(
      is_plain(parse_map(text_with("", "segments = [{ length = \"1 m\", width = \"20 mm\" }]"), "m.map")))
      << "the segment is as wide as the map's line";
}

TEST(Paint, IsWrittenAsItWasRead) {
  const std::string mark =
      "\n[[mark]]\nalong = \"300 mm\"\ncolour = \"red\"\nworn = 0.5\n[[area]]\ncolour = \"black\"\nat = "
      "[\"1 m\", \"300 mm\"]\nradius = \"50 mm\"\ngloss = 0.07\n";
  const Map map = parse_map(text_with("worn = 0.1\ngloss = 0.02\n", kThreePaints + mark), "m.map");
  const std::string written = write_map(map);
  const Map again = parse_map(written, "again.map");
  EXPECT_EQ(paints_of(again), paints_of(map)) << written;
  EXPECT_EQ(again.course.marks.at(0).paint, map.course.marks.at(0).paint);
  EXPECT_EQ(again.course.areas.at(0).gloss, 0.07);
  EXPECT_EQ(again.worn, 0.1);
  EXPECT_EQ(write_map(again), written);
}

TEST(Paint, ReachesHalfItsOwnWidthIntoAGap) {
  const Map map =
      parse_map(text_with("",
                          "segments = [{ length = \"300 mm\", width = \"40 mm\" }, { length = "
                          "\"100 mm\", gap = true }, { length = \"300 mm\", width = \"10 mm\" }]"),
                "m.map");
  const Stripes stripes(map, 0.05);
  double wide_end = 0.0, narrow_begin = 9.0;
  for (const Stripe& s : stripes.all()) {
    if (!s.painted) continue;
    if (paints_of(map)[s.paint].width == 0.040) wide_end = std::max(wide_end, s.b.x);
    if (paints_of(map)[s.paint].width == 0.010) narrow_begin = std::min(narrow_begin, s.a.x);
  }
  EXPECT_NEAR(wide_end, 0.5 - 0.020, 1e-12);
  EXPECT_NEAR(narrow_begin, 0.6 + 0.005, 1e-12);
}

struct PaintMistake {
  const char* name;
  const char* top;
  std::string path;
  const char* says;
};

void PrintTo(const PaintMistake& mistake, std::ostream* out) { *out << mistake.name; }

class PaintMistakes : public testing::TestWithParam<PaintMistake> {};

TEST_P(PaintMistakes, AreToldWithTheirPlace) {
  const PaintMistake& mistake = GetParam();
  EXPECT_THAT(test::refusal([&] { parse_map(text_with(mistake.top, mistake.path), "m.map"); }),
              testing::AllOf(HasSubstr(mistake.says), HasSubstr("m.map:")));
}

std::string segment(const std::string& keys) { return "segments = [{ length = \"1 m\", " + keys + " }]"; }

std::string kinds(int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += "{ length = \"10 mm\", worn = 0." + std::to_string(10 + i) + " },\n";
  return "segments = [" + all + "]";
}

INSTANTIATE_TEST_SUITE_P(
    All, PaintMistakes,
    testing::Values(
        PaintMistake{"TooNarrow", "", segment("width = \"0.5 mm\""),
                     "m.map:7:39: width: expected 1 to 100 mm, got 0.5 mm"},
        PaintMistake{"TooWide", "", segment("width = \"200 mm\""), "width: expected 1 to 100 mm, got 200 mm"},
        PaintMistake{"NoLength", "", segment("width = 12"), "width"},
        PaintMistake{"MoreThanAll", "", segment("worn = \"120 %\""), "worn: expected 0 to 1"},
        PaintMistake{"LessThanNothing", "", segment("worn = -0.1"), "worn: expected 0 to 1"},
        PaintMistake{"WornText", "", segment("worn = \"much\""), "worn"},
        PaintMistake{"NoColour", "", segment("colour = \"blue\""), "colour: expected black"},
        PaintMistake{"TooGlossy", "", segment("gloss = 2"), "gloss: expected 0 to 1"},
        PaintMistake{"OfAGap", "", segment("gap = true, width = \"12 mm\""), "a gap is not painted"},
        PaintMistake{"OfACorner", "", "segments = [{ length = \"1 m\" }, { angle = \"90 deg\", worn = 0.5 }]",
                     "a corner is not painted"},
        PaintMistake{"OfTheMap", "worn = 1.5\n", segment("gap = false"), "worn: expected 0 to 1"},
        PaintMistake{"OfARasterFloor", "floor = \"raster\"\nworn = 0.5\n", segment("gap = false"),
                     "worn requires lines; floor = \"raster\" has painted cells"},
        PaintMistake{"TooMany", "", kinds(33), "too many kinds of line: expected at most 32"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

TEST(Paint, MayBeOf32Kinds) {
  EXPECT_EQ(parse_map(text_with("", kinds(32)), "m.map").course.paints.size(), 32u);
}

}  // namespace robosim::map::paint_test
