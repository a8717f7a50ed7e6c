// Implements the RapidCheck generators of random_worlds.h.
#include <fmt/format.h>
#include <rapidcheck/gen/Create.h>
#include <rapidcheck/gen/Numeric.h>
#include <rapidcheck/gen/Transform.h>
#include <rapidcheck/seq/Create.h>
#include <rapidcheck/shrinkable/Create.h>

#include <algorithm>
#include <filesystem>

#include "robosim/random_worlds.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/campaign/random_worlds/fault_plan.h"
#include "sim/campaign/random_worlds/line_network.h"
#include "sim/campaign/random_worlds/robot_variant.h"
#include "sim/campaign/random_worlds/track.h"
#include "sim/testing/request_builder.h"

namespace robosim::testing {
namespace {

using namespace random_worlds;

/// Returns a generator of objects that can shrink themselves. `draw(rng, size)` draws one object.
template <typename Thing, typename Draw>
rc::Gen<Thing> drawn(Draw draw) {
  return [draw](const rc::Random& seed, int size) {
    rc::Random random = seed;
    const RandomSource rng = [&](int below) {
      return static_cast<int>(random.next() % static_cast<unsigned>(below));
    };
    return rc::shrinkable::shrinkRecur(
        draw(rng, size), [](const Thing& thing) { return rc::seq::fromContainer(thing.smaller()); });
  };
}

/// Scales `most` by the generator's size, and returns at least 1.
int share(int most, int size) {
  return std::max(1, most * std::min(size, rc::kNominalSize) / rc::kNominalSize);
}

void check_apart(int cells) {
  if (cells < 2)
    throw InputError(fmt::format("lines {} cell apart would touch: expected at least 2 cells", cells));
}

FaultLimits limits_of(const Faults& faults) {
  const auto ms = [](Duration time) { return static_cast<int>(time / std::chrono::milliseconds(1)); };
  return {faults.at_most,        ms(faults.from),       ms(faults.until),
          faults.sensor_offset,  faults.sensor_noise,   faults.covered.count() / 1000,
          faults.motor_weakness, faults.clock_drift_ppm};
}

wire::RobotInfo described(const std::string& robot) { return Borrowed("host")->describe_robot(robot); }

}  // namespace

rc::Gen<std::string> networks(Networks limits) {
  check_apart(limits.apart);
  const auto draw = [limits](const RandomSource& rng, int size) {
    return grow(
        {1 + rng(share(limits.lines, size)), limits.apart, limits.most_ways, limits.cycles, limits.obstacles},
        rng);
  };
  return rc::gen::map(drawn<LineNetwork>(draw), [](const LineNetwork& network) { return network.map(); });
}

rc::Gen<std::string> trees(int lines) { return networks({.lines = lines}); }

rc::Gen<std::string> tracks(Tracks limits) {
  check_apart(limits.apart);
  const std::string front = fmt::format(
      "+++\ncell = \"{:g} mm\"\ncorner = \"{:g} mm\"\ngoal = \"laps:1\"\n[legend]\n3 = \"gap\"\n+++\n",
      limits.cell_mm, limits.corner_mm);
  const auto draw = [limits](const RandomSource& rng, int size) {
    return lay_out({1 + rng(share(limits.squares, size)), limits.apart, limits.gaps}, rng);
  };
  return rc::gen::map(drawn<Track>(draw), [front](const Track& track) { return front + track.grid(); });
}

rc::Gen<std::string> robots(const std::string& file, double mounting_mm) {
  const wire::RobotInfo robot = described(file);
  const std::vector<Figure> figures = figures_of(read_file(robot.file), robot.file, mounting_mm);
  const bool is_path = file.find_first_of("/.") != std::string::npos;
  const std::string base = is_path ? std::filesystem::absolute(file).string() : file;
  const auto draw = [figures](const RandomSource& rng, int) { return assemble(figures, rng); };
  return rc::gen::map(drawn<RobotVariant>(draw),
                      [figures, base](const RobotVariant& variant) { return variant.file(base, figures); });
}

rc::Gen<std::string> faults(const std::string& robot, Faults wanted) {
  const FaultLimits limits = limits_of(wanted);
  const wire::RobotInfo info = described(robot);
  Breakable parts;
  for (const auto& sensor : info.sensors) parts.sensors.push_back(sensor.name);
  for (const auto& part : info.parts)
    if (part.type == "motor") parts.motors.push_back(part.name);
  const auto draw = [limits, parts](const RandomSource& rng, int size) {
    return draw_up(limits, share(limits.at_most, size), parts, rng);
  };
  return rc::gen::map(drawn<FaultPlan>(draw),
                      [limits](const FaultPlan& plan) { return plan.script(limits); });
}

rc::Gen<Trial> trials(const Worlds& worlds) {
  const Trial& t = worlds.trial;
  const auto one_seed = [](std::uint64_t seed) {
    return seed > 1 ? rc::seq::just<std::uint64_t>(1) : rc::Seq<std::uint64_t>();
  };
  rc::Gen<std::uint64_t> seeds = rc::gen::just(t.seed);
  if (worlds.seeds > 1) {
    const auto any = rc::gen::inRange<std::uint64_t>(1, worlds.seeds + 1);
    seeds = rc::gen::shrink(rc::gen::noShrink(any), one_seed);
  }
  const auto trial_of = [t](const std::string& script, const std::string& robot, std::uint64_t seed,
                            const std::string& map) {
    Trial trial = t;
    if (!trial.script.empty() && trial.script.back() != '\n') trial.script += '\n';
    trial.script += script;
    trial.robot = robot;
    trial.seed = seed;
    trial.map = map;
    return trial;
  };
  return rc::gen::apply(trial_of, worlds.scripts.value_or(rc::gen::just(std::string())),
                        worlds.robots.value_or(rc::gen::just(t.robot)), seeds,
                        worlds.maps.value_or(rc::gen::just(t.map)));
}

}  // namespace robosim::testing
