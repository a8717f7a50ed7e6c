#include "sim/record/record_svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "sim/base/file.h"
#include "sim/record/trail_path.h"
#include "tests/support/temporary_folder.h"

namespace robosim::record {
namespace record_svg_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class Picture : public ::testing::Test {
 protected:
  Picture() {
    write_file(map, "____#\n_S.._\n_____\n_____\n");
    run.sketch = "A<B";
    run.request.map = map;
  }
  ~Picture() override {
    std::filesystem::remove(map);
    std::filesystem::remove(file);
  }
  std::string drawn(const result::RunResult& result = {}) {
    recorder.finish(result);
    return read_file(file);
  }

  const test::TemporaryFolder folder;
  const std::string map = folder / "picture.map", file = folder / "picture.svg";
  RecordedRun run;
  SvgRecorder recorder{file};
};

TEST_F(Picture, ShowsTheFloorTheTrailAndHowItEnded) {
  recorder.begin(run);
  wire::Started started;
  started.x = started.y = 1;
  started.stations = {{1, "dock", 1, 1}};
  recorder.add(started);
  recorder.add(wire::Sample{0, 150, 250, 0, 0});
  recorder.add(wire::Sample{10000, 250, 250, 0, 500});
  result::RunResult result;
  result.verdict = "lost";
  result.time_s = 3.0;
  const std::string svg = drawn(result);
  EXPECT_THAT(svg, HasSubstr(R"(d="M400.0 100.0h100.0v-100.0h-100.0z" fill="#b9b4a8")"))
      << "the wall is at the top right";
  EXPECT_THAT(svg,
              HasSubstr(R"(d="M150.0 150.0 L350.0 150.0" fill="none" stroke="#1f1f1f" stroke-width="20.0")"));
  EXPECT_THAT(svg, HasSubstr("M150.0 150.0L250.0 150.0\" stroke=\"" + speed_colour(8) + "\""));
  EXPECT_THAT(svg, HasSubstr(">dock</text>"));
  EXPECT_THAT(svg, HasSubstr(": lost after 3.00 s</text>"));
  EXPECT_THAT(svg, HasSubstr("A&lt;B"));
  EXPECT_THAT(svg, Not(HasSubstr("A<B")));
}

TEST_F(Picture, ShowsMarksInTheirOwnColour) {
  write_file(
      map,
      "+++\nsize = [\"1 m\", \"500 mm\"]\n[[path]]\nfrom = [\"100 mm\", \"100 mm\"]\nsegments = [{ length "
      "= \"800 mm\" }]\n[[mark]]\nalong = \"300 mm\"\n[[mark]]\nalong = \"500 mm\"\ncolour = \"red\"\n+++\n");
  recorder.begin(run);
  recorder.add(wire::Started{});
  const std::string svg = drawn();
  EXPECT_THAT(svg, HasSubstr(R"(fill="#c8322b")"));
  EXPECT_THAT(svg, HasSubstr("400.0 350.0")) << "the other mark";
}

TEST_F(Picture, ShowsHillsDarkerWhereTheyAreHigher) {
  write_file(
      map,
      "+++\nsize = [\"1 m\", \"500 mm\"]\n[[path]]\nfrom = [\"100 mm\", \"100 mm\"]\nsegments = [{ length "
      "= \"800 mm\" }]\n[[hill]]\nalong = \"400 mm\"\nsize = [\"240 mm\", \"100 mm\"]\nslope = \"10 deg\"\n"
      "[[surface]]\nalong = \"100 mm\"\nradius = \"50 mm\"\nkind = \"wet\"\n+++\n");
  recorder.begin(run);
  recorder.add(wire::Started{});
  const std::string svg = drawn();
  EXPECT_THAT(svg, HasSubstr(R"(d="M400.0 350.0L380.0 350.0L380.0 450.0L400.0 450.0Z" fill="#f4edde")"));
  EXPECT_THAT(svg, HasSubstr(R"(d="M620.0 350.0L600.0 350.0L600.0 450.0L620.0 450.0Z" fill="#d1b682")"));
  EXPECT_THAT(svg, HasSubstr(R"(fill="#d9e8f3")"));
}

TEST_F(Picture, TintsCellsWhoseSurfaceTheLegendSays) {
  write_file(map, "+++\n[legend]\n4 = \"wet line\"\n5 = \"carpet\"\n+++\n.44.\n_5__\n");
  recorder.begin(run);
  recorder.add(wire::Started{});
  const std::string svg = drawn();
  EXPECT_THAT(svg, HasSubstr(R"(d="M300.0 0.0L100.0 0.0L100.0 100.0L300.0 100.0Z" fill="#d9e8f3")"));
  EXPECT_THAT(svg, HasSubstr(R"(d="M200.0 100.0L100.0 100.0L100.0 200.0L200.0 200.0Z" fill="#e6dcea")"));
}

TEST_F(Picture, CutsOffAtItsEdgeWhatSticksOutOfTheFloor) {
  const auto with = [&](const std::string& x) {
    write_file(map, "+++\nsize = [\"1 m\", \"500 mm\"]\n[[surface]]\nat = [\"" + x +
                        " mm\", \"200 mm\"]\nradius = \"150 mm\"\nkind = \"wet\"\n+++\n");
    recorder.begin(run);
    recorder.add(wire::Started{});
    return drawn();
  };
  const std::string cut = R"(<svg width="1000.0" height="500.0">)";
  EXPECT_THAT(with("500"), AllOf(HasSubstr("<circle"), Not(HasSubstr(cut))));
  EXPECT_THAT(with("900"), AllOf(HasSubstr("<circle"), HasSubstr(cut)));
}

TEST_F(Picture, MarksCollisionsWhereTheRobotWas) {
  recorder.begin(run);
  recorder.add(wire::Started{});
  EXPECT_THAT(drawn(), Not(HasSubstr("#d55e00")));
  recorder.add(wire::Sample{0, 100, 200, 0, 0});
  recorder.add(wire::note_of({0, 0, result::CollisionBegan{}}));
  EXPECT_THAT(drawn(), HasSubstr(R"(d="M80.0 220.0L120.0 180.0M80.0 180.0L120.0 220.0" stroke="#d55e00")"));
}

TEST_F(Picture, DrawsNoLineToWhereAScriptPutsTheRobotNorWhereItMovesItToAndFro) {
  recorder.begin(run);
  recorder.add(wire::Started{});
  const auto acts = [&](const char* verb) {
    recorder.add(wire::note_of({0, 0, result::ScriptActed{verb, "", ""}}));
  };
  recorder.add(wire::Sample{0, 100, 200, 0, 0});
  acts("place");
  recorder.add(wire::Sample{10000, 130, 200, 0, 0});
  recorder.add(wire::Sample{20000, 140, 200, 0, 500});
  acts("sweep");
  recorder.add(wire::Sample{30000, 140, 210, 0, 0});
  recorder.add(wire::Sample{40000, 140, 220, 0, 0});
  acts("lower");
  recorder.add(wire::Sample{50000, 140, 200, 0, 0});
  recorder.add(wire::Sample{60000, 150, 200, 0, 500});
  EXPECT_THAT(drawn(), HasSubstr("d=\"M130.0 200.0L140.0 200.0M140.0 200.0L150.0 200.0\" stroke=\"#fff\""));
}

TEST_F(Picture, TellsOfNoDistanceFromTheLineWhereNothingSeesIt) {
  result::RunResult result;
  result.metrics.cross_track_max_mm = 12.0;
  run.robot_info.sensors.resize(1);
  recorder.begin(run);
  EXPECT_THAT(drawn(result), HasSubstr("m driven, its sensors 12.0 mm off the line at most; robot"));
  run.robot_info.sensors.clear();
  recorder.begin(run);
  EXPECT_THAT(drawn(result), HasSubstr("m driven; robot"));
}

TEST(Trails, AreNotDrawnWhereTheRobotWasCarried) {
  const auto all = stretches({{0, 0, 100}, {10, 0, 100}, {30, 0, 100, true}, {40, 0, 100}}, 100);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].last, 1u);
  EXPECT_EQ(all[1].first, 2u);
}

TEST(Trails, KeepCornersAndLeaveOutWhatLiesOnTheWay) {
  EXPECT_THAT(corners({{0, 0, 0}, {5, 0.1, 0}, {10, 0, 0}, {10, 5, 0}, {10, 10, 0}}, 0, 4, 0.5),
              ElementsAre(0u, 2u, 4u));
}

}  // namespace record_svg_test
}  // namespace robosim::record
