#include "sim/map/light.h"

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/map/map.h"
#include "sim/map/map_writer.h"
#include "tests/support/refusal.h"

namespace robosim::map::light_test {

Map lit_map(const std::string& lights) { return parse_map("+++\n" + lights + "\n+++\n_11_\n", "m.map"); }

TEST(Lights, AreReadAndWrittenBack) {
  const Map map = lit_map(R"([[light]]
level = "12.5 %"
[[light]]
level = 0.4
at = ["700 mm", "30 cm"]
height = "500 mm"
flicker = "80 %"
frequency = "120 Hz"
[[light]]
level = 2
at = ["1 m", "1 m"]
radius = "200 mm"
moves = ["-5 mm/s", "0 mm/s"])");
  ASSERT_EQ(map.lights.size(), 3u);
  EXPECT_FALSE(map.lights[0].at);
  EXPECT_EQ(map.lights[0].level, 0.125);
  EXPECT_NEAR(length(*map.lights[1].at - Vec2{0.7, 0.3}), 0.0, 1e-12);
  EXPECT_EQ(map.lights[1].frequency, 120.0);
  EXPECT_EQ(map.lights[2].radius, 0.2);
  EXPECT_EQ(map.lights[2].moves, (Vec2{-0.005, 0.0}));
  const std::string text = write_map(map);
  const Map again = parse_map(text, "again.map");
  EXPECT_EQ(again.lights.size(), 3u);
  EXPECT_EQ(again.lights[2].moves, map.lights[2].moves);
  EXPECT_EQ(again.lights[1].flicker, 0.8);
  EXPECT_EQ(write_map(again), text);
}

TEST(Lights, ThatMakeNoSenseAreRefused) {
  const auto complaint = [](const std::string& lights) -> std::string {
    return test::refusal([&] { lit_map(lights); });
  };
  const std::string at = "at = [\"1 m\", \"1 m\"]\n";
  const std::pair<std::string, const char*> refused[] = {
      {"[light]\nlevel = 1", "m.map:2:1: light: expected [[light]]"},
      {"[[light]]", "lacks the key level"},
      {"[[light]]\nlevel = -1", "m.map:3:9: level: expected"},
      {"[[light]]\nlevel = \"3 V\"", "m.map:3:9: "},
      {"[[light]]\nlevel = 1\n" + at,
       "m.map:2:1: invalid light: expected a lamp, which has `at` and `height`; a patch of sun"},
      {"[[light]]\nlevel = 1\nheight = \"1 m\"", "invalid light: expected a lamp"},
      {"[[light]]\nlevel = 1\nheight = \"1 m\"\nradius = \"1 m\"\n" + at, "invalid light: expected a lamp"},
      {"[[light]]\nlevel = 1\nheight = \"1 m\"\nmoves = [\"1 mm/s\", \"1 mm/s\"]\n" + at,
       "invalid light: expected a lamp"},
      {"[[light]]\nlevel = 1\nradius = \"1 m\"\nmoves = \"1 mm/s\"\n" + at, "moves: expected [X, Y]"},
      {"[[light]]\nlevel = 1\nradius = \"1 m\"\nmoves = [\"1 mm\", \"1 mm\"]\n" + at, "mm/s"},
      {"[[light]]\nlevel = 1\nflicker = 2", "flicker: expected"},
      {"[[light]]\nlevel = 1\nfrequency = 50", "expected a string with a unit"},
      {"[[light]]\nlevel = 1\ncolour = \"red\"", "unknown key colour"},
  };
  for (const auto& [text, message] : refused)
    EXPECT_THAT(complaint(text), testing::HasSubstr(message)) << text;
  std::string many;
  for (int i = 0; i < 65; ++i) many += "[[light]]\nlevel = 0\n";
  EXPECT_THAT(complaint(many), testing::HasSubstr("too many lights: expected at most 64"));
}

}  // namespace robosim::map::light_test
