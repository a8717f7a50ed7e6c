// The baseline run without any disturbance, and the sketch's purpose derived from it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/cli/hunt/deeds.h"
#include "sim/cli/hunt/hunt.h"

namespace robosim::cli {
namespace {

constexpr double kLongest_s = 300.0, kAfter_s = 20.0;
constexpr double kWayAgain = 1.5,
                 kWayOn_s = 15.0;  // added to a multiple of the way's time, for most runs
constexpr double kSlower = 5.0;
constexpr std::size_t kTours = 4, kEnoughTours = 2;

bool reached(const std::optional<wire::RunResult>& result) { return result && result->verdict == "reached"; }

}  // namespace

double Hunt::time_of(const HuntWorld& world) const {
  double usual = (span_ms(world, bench_.space()) + world.later_ms) / 1000.0;
  const bool waits = std::any_of(world.deeds.begin(), world.deeds.end(),
                                 [](const Deed& deed) { return !deed.after.empty(); });
  if (waits && plain_.reached()) usual = std::min(kLongest_s, usual + plain_.result.time_s);
  if (!world.to_goal || !plain_.reached()) return usual;
  const double limit = std::ceil(patience_s(world, bench_.space(), plain_));
  return limit > kLongest_s ? usual : std::max(limit, usual);
}

bool Hunt::find_plain() {
  listener_.progress("recording the baseline run …");
  const std::vector<std::vector<Deed>> ways = openings(bench_.space());
  std::vector<HuntWorld> worlds;
  for (std::size_t map = 0; map < (bench_.maps_are_given() ? 1 : bench_.space().maps.size()); ++map)
    for (const std::vector<Deed>& way : ways) {
      HuntWorld& world = worlds.emplace_back();
      world.map = map;
      world.deeds = way;
      world.for_s = bench_.space().for_ms / 1000.0;
    }
  std::vector<std::optional<wire::RunResult>> results;
  if (!bench_.run(worlds, results)) return false;
  if (std::none_of(results.begin(), results.end(), reached)) {
    // Robots that are still on their way may need longer.
    std::vector<HuntWorld> slow;
    for (std::size_t i = 0; i < worlds.size(); ++i)
      if (results[i] && results[i]->verdict == "timeout" && results[i]->metrics.distance_m > kMoved_m) {
        slow.push_back(worlds[i]);
        slow.back().for_s = kSlower * worlds[i].for_s;
      }
    std::vector<std::optional<wire::RunResult>> later;
    if (!bench_.run(slow, later)) return false;
    if (std::any_of(later.begin(), later.end(), reached)) worlds = slow, results = later;
  }
  const auto is_better = [](const wire::RunResult& a, const wire::RunResult& b) {
    if ((a.verdict == "reached") != (b.verdict == "reached")) return a.verdict == "reached";
    return b.metrics.distance_m < kMoved_m && a.metrics.distance_m > kMoved_m;
  };
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < worlds.size(); ++i)
    if (results[i] && (!best || is_better(*results[i], *results[*best]))) best = i;
  if (!best) throw InputError(bench_.refusal());
  plain_ = {*results[*best], bench_.robot()};
  plain_world_ = worlds[*best];
  if (!bench_.maps_are_given()) {
    // It is meant for all on which it reaches its goal, and does not collide.
    std::vector<std::size_t> kept{plain_world_.map};
    for (std::size_t i = 0; i < worlds.size(); ++i)
      if (reached(results[i]) && results[i]->metrics.collisions <= plain_.result.metrics.collisions &&
          std::find(kept.begin(), kept.end(), worlds[i].map) == kept.end())
        kept.push_back(worlds[i].map);
    bench_.keep_maps(kept);
  }
  HuntSpace& space = bench_.space();
  space.usual_ms = space.for_ms;
  if (plain_.reached())
    space.usual_ms =
        std::min(space.for_ms, static_cast<int>(1000.0 * (kWayAgain * plain_.result.time_s + kWayOn_s)));
  plain_world_.map = 0;
  bench_.space().opening = plain_world_.deeds;
  plain_world_.for_s = time_of(plain_world_);
  return feel() && hear() && tour();
}

/// A read of a whole port includes the bumper's pin. So whether the sketch uses it is tested by pressing it.
bool Hunt::feel() {
  const auto& unused = plain_.result.usage.unused;
  std::vector<HuntWorld> pressed;
  for (const auto& part : bench_.robot().parts) {
    if (part.type != "bumper" || std::find(unused.begin(), unused.end(), part.name) != unused.end()) continue;
    HuntWorld& world = pressed.emplace_back(plain_world_);
    world.deeds.push_back({static_cast<int>(500.0 * plain_.result.time_s),
                           fmt::format("fault {} pressed for 2s", part.name), "press " + part.name});
  }
  if (!pressed.empty()) pressed.push_back(plain_world_);
  std::vector<std::optional<wire::RunResult>> results;
  if (!bench_.run(pressed, results)) return false;
  for (std::size_t i = 0; i + 1 < results.size(); ++i)
    if (results[i] && results.back() && results[i]->trace_hash != results.back()->trace_hash)
      bench_.space().feels = true;
  return true;
}

/// Collects its output, also after its goal: messages may come then.
bool Hunt::hear() {
  if (!hears(bench_.space())) return true;
  HuntWorld world = plain_world_;
  world.to_goal = false;
  world.for_s = std::max(world.for_s, std::ceil(plain_.result.time_s) + kAfter_s);
  std::vector<std::optional<wire::RunResult>> results;
  if (!bench_.run({world}, results)) return false;
  if (results.front()) bench_.space().said = beginnings_of(results.front()->serial);
  return true;
}

/// A follower of loops that turns at a line's end may tour one floor without being meant for others.
bool Hunt::tour() {
  HuntSpace& space = bench_.space();
  for (std::size_t map = 1; map < space.maps.size() && !bench_.maps_are_given() && space.draws_maps; ++map) {
    if (!space.maps[map].networks) continue;
    std::vector<HuntWorld> worlds = networks_like(space, map, arguments_.seed, kTours);
    for (HuntWorld& world : worlds) world.for_s = time_of(world);
    std::vector<std::optional<wire::RunResult>> results;
    if (!bench_.run(worlds, results)) return false;
    space.maps[map].tours =
        static_cast<std::size_t>(std::count_if(results.begin(), results.end(), reached)) >= kEnoughTours;
  }
  return true;
}

}  // namespace robosim::cli
