// Measures the world alone: one tick of one body, and one reading of the floor by a sensor.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "sim/world/world.h"

namespace {

using namespace robosim;

// Returns a map with a line along a rectangle, 3 m x 2 m, on an open floor. Its corners have the radius
// `corner_m`.
map::Map loop_map(double corner_m) {
  map::Map map;
  map.width = 40;
  map.height = 30;
  map.cells.assign(static_cast<std::size_t>(map.width * map.height), map::Cell::floor);
  map.corner_m = corner_m;
  const auto paint = [&map](int x, int y) {
    map.cells[static_cast<std::size_t>(y * map.width + x)] = map::Cell::line;
  };
  for (int x = 5; x <= 34; ++x) paint(x, 5), paint(x, 24);
  for (int y = 5; y <= 24; ++y) paint(5, y), paint(34, y);
  return map;
}

constexpr int kSensors = 5;

// Drives in a circle, over the lines and next to them. Every `read_every` ticks (0 = never), five sensors
// read the floor. They are 9.5 mm apart and 60 mm ahead of the axle.
void drive_and_read(benchmark::State& state, double corner_m, int read_every) {
  const map::Map map = loop_map(corner_m);
  world::World world(map);
  world::Body& body = world.body(world.add_body(world::default_body_params(), {{2.0, 0.58}, {1.0, 0.0}}));
  int tick = 0;
  for (auto _ : state) {
    if (read_every && ++tick == read_every) {
      tick = 0;
      for (int i = 0; i < kSensors; ++i) {
        const Vec2 at = body.pose_after(0.000112 * i).to_world({0.06, (i - 2) * 0.0095});
        benchmark::DoNotOptimize(world.floor().on_line(at, 0.003));
      }
    }
    body.command(world::left, {0.45, 0.55});
    body.command(world::right, {0.60, 0.40});
    world.step();
    benchmark::DoNotOptimize(body.pose().position.x);
  }
  if (body.collisions()) state.SkipWithError("it drove into a wall");
}

void world_tick(benchmark::State& state) { drive_and_read(state, 0.0, 0); }
BENCHMARK(world_tick);
void world_tick_with_five_sensors(benchmark::State& state) { drive_and_read(state, 0.0, 1); }
BENCHMARK(world_tick_with_five_sensors);
void world_tick_with_five_sensors_round(benchmark::State& state) { drive_and_read(state, 0.15, 1); }
BENCHMARK(world_tick_with_five_sensors_round);
void world_tick_with_five_sensors_every_5_ms(benchmark::State& state) { drive_and_read(state, 0.0, 5); }
BENCHMARK(world_tick_with_five_sensors_every_5_ms);

// Returns points all over the map. Most of them are off the line, like most of a floor.
std::vector<Vec2> points() {
  std::vector<Vec2> all;
  unsigned random = 1;
  for (int i = 0; i < 4096; ++i) {
    random = random * 1664525u + 1013904223u;
    all.push_back({(random >> 8 & 4095) / 4096.0 * 4.0, (random >> 20) / 4096.0 * 3.0});
  }
  return all;
}

void coverage(benchmark::State& state, double corner_m, bool raster) {
  map::Map map = loop_map(corner_m);
  map.raster = raster;
  const world::Floor floor(map);
  const std::vector<Vec2> at = points();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(floor.on_line(at[i++ & 4095], 0.003));
}

void floor_coverage_square(benchmark::State& state) { coverage(state, 0.0, false); }
BENCHMARK(floor_coverage_square);
void floor_coverage_round(benchmark::State& state) { coverage(state, 0.15, false); }
BENCHMARK(floor_coverage_round);
// Measures one reading of a floor with a loop of 3.2 m x 2.2 m, which the map describes as a path. `paint`
// contains additional TOML keys (width, colour, wear) for one long side and two bends. `marks` is the number
// of marks next to the line.
void read_path(benchmark::State& state, const std::string& paint, int marks = 0) {
  const std::string bend = "{ radius = \"150 mm\", angle = \"90 deg\"";
  std::string beside;
  for (int i = 0; i < marks; ++i)
    beside += "[[mark]]\nside = \"" + std::string(i % 2 ? "left" : "right") + "\"\nalong = \"" +
              std::to_string(0.2 + 9.6 * i / marks) + " m\"\n";
  const map::Map map = map::parse_map(
      "+++\nsize = [\"4 m\", \"3 m\"]\n[[path]]\nfrom = [\"550 mm\", \"400 mm\"]\nsegments = [\n{ length = "
      "\"2.9 m\"" +
          paint + " }, " + bend + " }, { length = \"1.9 m\" }, " + bend + paint +
          " },\n{ length = \"2.9 m\" }, " + bend + paint + " }, { length = \"1.9 m\" }, " + bend + " }]\n" +
          beside + "+++\n",
      "path.map");
  const world::Floor floor(map);
  const std::vector<Vec2> at = points();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(floor.darkness(at[i++ & 4095], 0.003));
}

void floor_coverage_path(benchmark::State& state) { read_path(state, ""); }
BENCHMARK(floor_coverage_path);
void floor_marks(benchmark::State& state) { read_path(state, "", 40); }
BENCHMARK(floor_marks);
void floor_paints(benchmark::State& state) {
  read_path(state, ", width = \"12 mm\", colour = \"grey 60 %\"");
}
BENCHMARK(floor_paints);
void floor_paints_and_marks(benchmark::State& state) {
  read_path(state, ", width = \"12 mm\", colour = \"grey 60 %\"", 40);
}
BENCHMARK(floor_paints_and_marks);
void floor_worn(benchmark::State& state) { read_path(state, ", worn = \"30 %\""); }
BENCHMARK(floor_worn);
void floor_coverage_raster(benchmark::State& state) { coverage(state, 0.0, true); }
BENCHMARK(floor_coverage_raster);

// Measures one query of the distance to the line, at points along the line and within 15 mm of its centre.
void distance_to_line(benchmark::State& state, double corner_m) {
  const map::Map map = loop_map(corner_m);
  const world::Floor floor(map);
  std::size_t i = 0;
  for (auto _ : state) {
    const double x = 0.7 + 0.0006 * static_cast<double>(i & 4095),
                 y = 0.535 + 0.00003 * static_cast<double>(i % 1000);
    ++i;
    benchmark::DoNotOptimize(floor.distance_to_line({x, y}));
  }
}

void floor_distance_square(benchmark::State& state) { distance_to_line(state, 0.0); }
BENCHMARK(floor_distance_square);
void floor_distance_round(benchmark::State& state) { distance_to_line(state, 0.15); }
BENCHMARK(floor_distance_round);

}  // namespace
