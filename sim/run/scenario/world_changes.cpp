#include "sim/run/scenario/world_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/base/error.h"
#include "sim/base/parse_unsigned.h"
#include "sim/run/scenario/places.h"

namespace robosim::scenario {
namespace {

using enum Action::Verb;

constexpr double kErased_m = 0.005;   // width that is erased beyond each edge of the line
constexpr double kDoorRadius = 0.01;  // in metres; radius of the discs that form a door
constexpr double kDoorStep = 0.015;   // in metres; distance between the middles of two discs
constexpr double kLongestDoor = 5.0;  // m

struct Box {
  Vec2 least, most;
};

/// Returns the box around a line, with a margin on each side.
Box box_of(const Stretch& stretch, double half) {
  const auto [a, b] = stretch;
  return {{std::min(a.x, b.x) - half, std::min(a.y, b.y) - half},
          {std::max(a.x, b.x) + half, std::max(a.y, b.y) + half}};
}

}  // namespace

void WorldChanges::check(const Action& action) const {
  if (action.verb == obstacle || action.verb == clear) parse_cell(map_, action.text);
  if (!action.to.empty()) parse_cell(map_, action.to);
  if (action.verb == paint || action.verb == erase || action.verb == door) {
    const Stretch stretch = parse_stretch(map_, action.text);
    if (action.verb == door && stretch.to == stretch.from)
      throw InputError("invalid door: expected two different cells");
    if (action.verb == door && length(stretch.to - stretch.from) > kLongestDoor)
      throw InputError(fmt::format("the door is too long: expected at most {} m", kLongestDoor));
  }
  if (action.verb == light) lights_of(action.text);
}

Vec2 WorldChanges::place_of(map::CellAt cell) const {
  return map::is_line(map_.at(cell)) ? stripes_.point_of(cell) : map_.centre(cell);
}

result::ScriptActed WorldChanges::put_obstacle(const Action& action, SimTime t) {
  clear_obstacle(action.text);
  const map::CellAt cell = parse_cell(map_, action.text);
  const Vec2 at = place_of(cell);
  Obstacle& put = state_.obstacles.emplace_back(Obstacle{cell, world_.add_obstacle(at, action.radius)});
  if (!action.to.empty()) {
    put.from = at;
    put.to = place_of(parse_cell(map_, action.to));
    put.began = t;
    put.period = action.period;
  }
  result::ScriptActed acted{
      "obstacle", action.part, action.text, {1e3 * at.x, 1e3 * at.y, 1e3 * action.radius}, {}, {}};
  if (put.period > 0) acted.moves = {1e3 * put.to.x, 1e3 * put.to.y, 1e-9 * static_cast<double>(put.period)};
  return acted;
}

void WorldChanges::clear_obstacle(const std::string& text) {
  const map::CellAt cell = parse_cell(map_, text);
  std::erase_if(state_.obstacles, [&](const Obstacle& one) {
    if (one.cell != cell) return false;
    world_.remove_obstacle(one.number);
    return true;
  });
}

void WorldChanges::move_obstacles(SimTime t) {
  for (Obstacle& one : state_.obstacles) {
    if (one.period == 0) continue;
    const double share = std::min(static_cast<double>(t - one.began) / static_cast<double>(one.period), 1.0);
    world_.move_obstacle(one.number, one.from + (one.to - one.from) * share);
    if (share == 1.0) one.period = 0;
  }
}

/// Returns the lights that a script selects: all, or one by its number from 1.
std::vector<std::size_t> WorldChanges::lights_of(const std::string& text) const {
  std::vector<std::size_t> lights;
  const std::size_t count = map_.lights.size();
  const std::uint64_t number = parse_unsigned(text).value_or(0);
  if (count == 0) throw InputError("the map has no light to switch; [[light]] in the map makes one");
  if (text != "all" && (number == 0 || number > count))
    throw InputError(fmt::format("unknown light: expected 1 to {} or all, got \"{}\"", count, text));
  for (std::size_t i = 0; i < count; ++i)
    if (text == "all" || i + 1 == number) lights.push_back(i);
  return lights;
}

/// Returns half the width of the strip that an action changes.
double WorldChanges::half_width(const Action& action) const {
  if (action.verb == door) return kDoorRadius;
  return 0.5 * map_.line_m + (action.verb == erase ? kErased_m : 0.0);
}

result::ScriptActed WorldChanges::told(const char* verb, const Action& action) const {
  result::ScriptActed acted{verb, action.part, action.text, {}, {}, {}};
  if (action.verb == light) return acted;
  const auto [least, most] = box_of(parse_stretch(map_, action.text), half_width(action));
  const Vec2 size = most - least;
  acted.box_mm = {1e3 * least.x, 1e3 * least.y, 1e3 * size.x, 1e3 * size.y};
  return acted;
}

void WorldChanges::remove_patch(const std::string& text) {
  const auto known = state_.patches.find(text);
  if (known == state_.patches.end()) return;
  world_.patches().remove(known->second);
  state_.patches.erase(known);
}

void WorldChanges::add_patch(const Action& action) {
  const auto [least, most] = box_of(parse_stretch(map_, action.text), half_width(action));
  remove_patch(action.text);
  state_.patches[action.text] = world_.patches().add(least, most, action.verb == paint);
}

void WorldChanges::open_door(const std::string& text) {
  for (const int disc : state_.doors[text]) world_.remove_obstacle(disc);
  state_.doors.erase(text);
}

void WorldChanges::shut_door(const std::string& text) {
  const auto [a, b] = parse_stretch(map_, text);
  open_door(text);
  const int steps = std::max(1, static_cast<int>(std::ceil(length(b - a) / kDoorStep)));
  std::vector<int>& discs = state_.doors[text];
  for (int i = 0; i <= steps; ++i)
    discs.push_back(world_.add_obstacle(a + (b - a) * (static_cast<double>(i) / steps), kDoorRadius));
}

void WorldChanges::bring_about(const Action& action) {
  if (action.verb == paint || action.verb == erase) add_patch(action);
  if (action.verb == door && action.part == "shut") shut_door(action.text);
  if (action.verb == door && action.part == "open") open_door(action.text);
  if (action.verb != light) return;
  for (const std::size_t number : lights_of(action.text))
    world_.lighting().switch_light(number, action.part == "on");
}

result::ScriptActed WorldChanges::perform(const Action& action) {
  bring_about(action);
  const char* const verb = action.verb == paint   ? "paint"
                           : action.verb == erase ? "erase"
                           : action.verb == door  ? "door"
                                                  : "light";
  return told(verb, action);
}

result::ScriptActed WorldChanges::undo(const Action& action) {
  static const std::map<std::string, std::string> opposites = {
      {"shut", "open"}, {"open", "shut"}, {"on", "off"}, {"off", "on"}};
  Action back = action;
  if (action.verb == paint || action.verb == erase) {
    remove_patch(action.text);
  } else {
    back.part = opposites.at(action.part);
    bring_about(back);
  }
  return told("restore", back);
}

}  // namespace robosim::scenario
