#include "sim/scenario/scenario_player.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/scenario/script_line.h"

namespace robosim::scenario {
namespace {

wire::ScriptActed acted(const char* verb, const Action& action) {
  const bool has_bytes = action.verb != Action::Verb::lift && action.verb != Action::Verb::lower;
  return {verb, action.part, has_bytes ? action.text : ""};
}

/// Two of them about one thing: the later one counts, and the earlier one's end no more.
bool replaces(const Action& later, const Action& earlier) {
  using enum Action::Verb;
  const auto both = [&](Action::Verb verb) { return later.verb == verb && earlier.verb == verb; };
  if (both(power)) return true;
  if (both(fault)) return later.part == earlier.part;
  if (both(obstacle) || (later.verb == clear && earlier.verb == obstacle)) return later.text == earlier.text;
  const auto is_move = [](Action::Verb verb) { return verb == lift || verb == lower || verb == place; };
  return is_move(later.verb) && is_move(earlier.verb);
}

grid::CellAt parse_cell(const grid::Map& map, const std::string& text) {
  const auto width = static_cast<std::uint64_t>(map.width), height = static_cast<std::uint64_t>(map.height);
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::string_view row = std::string_view(text).substr(std::min(comma + 1, text.size()));
  const std::uint64_t x = parse_whole(text.substr(0, comma)).value_or(width);
  const std::uint64_t y = parse_whole(row).value_or(height);
  if (x >= width || y >= height)
    throw InputError(fmt::format("\"{}\" is no cell of the map: allowed are COLUMN,ROW from 0,0 to {},{}",
                                 text, width - 1, height - 1));
  return {static_cast<int>(x), static_cast<int>(y)};
}

}  // namespace

ScenarioPlayer::ScenarioPlayer(std::vector<Step> steps, const Stage& stage, const judge::Progress& progress)
    : stage_(stage), board_(stage.executor, stage.robot, stage.seed, stage.number) {
  add(std::move(steps), progress);
}

void ScenarioPlayer::add(std::vector<Step> steps, const judge::Progress& progress) {
  for (const Step& step : steps) check(step, progress);
  for (Step& step : steps) {
    if (step.trigger.kind == Trigger::Kind::serial)
      longest_text_ = std::max(longest_text_, step.trigger.text.size());
    pending_.push_back({std::move(step)});
  }
}

void ScenarioPlayer::check(const Step& step, const judge::Progress& progress) const {
  const Action& action = step.action;
  try {
    if (step.trigger.kind == Trigger::Kind::station) {
      std::vector<std::string> names;
      for (const judge::Waypoint& station : progress.stations()) names.push_back(station.name);
      if (std::find(names.begin(), names.end(), step.trigger.text) == names.end())
        throw InputError(
            fmt::format("there is no station {}; {}", step.trigger.text,
                        names.empty() ? "the map has none" : "the stations are " + one_of(names)));
    }
    if (step.trigger.kind == Trigger::Kind::eeprom) board_.check_eeprom();
    if (action.verb == Action::Verb::obstacle || action.verb == Action::Verb::clear)
      parse_cell(stage_.map, action.text);
    if (action.verb == Action::Verb::place) grid::parse_start(stage_.map, action.text);
    if (action.verb == Action::Verb::press || action.verb == Action::Verb::release)
      stage_.robot.check_press(action.part);
    if (action.verb == Action::Verb::send && !action.part.empty()) stage_.robot.check_send(action.part);
    if (action.verb == Action::Verb::cover) stage_.robot.check_cover(action.part);
    if (action.verb == Action::Verb::fault) check_fault(action);
  } catch (const InputError& error) {
    throw InputError(step.place, error.message());
  }
}

bool ScenarioPlayer::is_of_board(const Action& fault) const {
  const std::vector<std::string> parts = stage_.robot.breakable();
  return BoardFaults::knows(fault.part) && std::find(parts.begin(), parts.end(), fault.part) == parts.end();
}

void ScenarioPlayer::check_fault(const Action& action) const {
  if (is_of_board(action)) return board_.check(action.part, action.arguments, action.duration.has_value());
  std::vector<std::string> names = stage_.robot.breakable();
  names.insert(names.end(), BoardFaults::names().begin(), BoardFaults::names().end());
  if (std::find(names.begin(), names.end(), action.part) == names.end())
    throw InputError(fmt::format("there is no {} that can break; there is {}", action.part, one_of(names)));
  stage_.robot.check_fault(action.part, action.arguments.front(),
                           {action.arguments.begin() + 1, action.arguments.end()});
}

void ScenarioPlayer::hear(std::uint8_t byte) {
  if (longest_text_ == 0) return;
  heard_ += static_cast<char>(byte);
  if (heard_.size() > 4 * longest_text_) heard_.erase(0, heard_.size() - longest_text_);
  for (Pending& pending : pending_)
    if (pending.step.trigger.kind == Trigger::Kind::serial && heard_.ends_with(pending.step.trigger.text))
      pending.heard = true;
}

bool ScenarioPlayer::met(const Pending& pending, SimTime t, const judge::Progress& progress) const {
  const Trigger& trigger = pending.step.trigger;
  switch (trigger.kind) {
    case Trigger::Kind::at:
      return t >= trigger.time;
    case Trigger::Kind::serial:
      return pending.heard;
    case Trigger::Kind::station:
      return progress.is_visited(trigger.text);
    case Trigger::Kind::boot:
      return board_.boots() >= trigger.count;
    case Trigger::Kind::eeprom:
      return board_.eeprom_writes() >= trigger.count;
  }
  return false;
}

void ScenarioPlayer::act(SimTime t, const judge::Progress& progress, judge::Events& events) {
  for (std::size_t i = 0; i < undo_.size();) {
    if (t < undo_[i].at) {
      ++i;
      continue;
    }
    const Action action = undo_[i].action;
    undo_.erase(undo_.begin() + static_cast<std::ptrdiff_t>(i));
    if (auto event = end(action, t)) events.push_back(std::move(*event));
  }
  for (std::size_t i = 0; i < pending_.size();) {
    Pending& pending = pending_[i];
    const Trigger& trigger = pending.step.trigger;
    if (pending.due == kNever && met(pending, t, progress))
      pending.due = trigger.kind == Trigger::Kind::at ? t : t + trigger.time;
    if (t < pending.due) {
      ++i;
      continue;
    }
    const Action action = pending.step.action;
    pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(i));
    std::erase_if(undo_, [&](const Undo& undo) { return replaces(action, undo.action); });
    events.push_back(perform(action, t));
    if (action.duration) undo_.push_back({t + *action.duration, action});
  }
}

void ScenarioPlayer::put_obstacle(const Action& action) {
  clear_obstacle(action.text);
  const grid::CellAt cell = parse_cell(stage_.map, action.text);
  const Vec2 at =
      grid::is_line(stage_.map.at(cell)) ? stage_.stripes.point_of(cell) : stage_.map.centre(cell);
  obstacles_.push_back({cell, stage_.world.add_obstacle(at, action.radius)});
}

void ScenarioPlayer::clear_obstacle(const std::string& text) {
  const grid::CellAt cell = parse_cell(stage_.map, text);
  std::erase_if(obstacles_, [&](const Obstacle& obstacle) {
    if (obstacle.cell != cell) return false;
    stage_.world.remove_obstacle(obstacle.number);
    return true;
  });
}

void ScenarioPlayer::repaired(const std::string& part, SimTime t) {
  for (judge::ScriptFault& fault : faults_)
    if (fault.part == part && fault.ended == kNever) fault.ended = t;
}

wire::RunEvent::What ScenarioPlayer::break_or_repair(const Action& action, SimTime t) {
  const bool ran = board_.powered();
  if (is_of_board(action)) {
    board_.fail(action.part, action.arguments, t);
  } else {
    stage_.robot.fault(action.part, action.arguments.front(),
                       {action.arguments.begin() + 1, action.arguments.end()});
  }
  repaired(action.part, t);
  if (action.arguments.front() == "ok") return wire::FaultEnded{action.part, action.arguments};
  faults_.push_back({action.part, action.arguments, t});
  return wire::FaultBegan{action.part, action.arguments, ran && !board_.powered()};
}

wire::RunEvent::What ScenarioPlayer::switch_power(const Action& action, SimTime t) {
  const bool ran = board_.powered();
  board_.switch_power(action.part == "on", t);
  if (action.part == "on") return wire::PowerBack{};
  if (!ran || board_.powered()) return wire::PowerLost{};
  return wire::PowerLost{board_.leave_half_written(action.half_written, t)};
}

wire::RunEvent::What ScenarioPlayer::perform(const Action& action, SimTime t) {
  switch (action.verb) {
    case Action::Verb::press:
      stage_.robot.press(action.part, t);
      return acted("press", action);
    case Action::Verb::release:
      stage_.robot.release(action.part, t);
      return acted("release", action);
    case Action::Verb::send:
      if (action.part.empty()) {
        board_.send(action.text, t);
      } else {
        stage_.robot.send(action.part, action.bits, t);
      }
      return acted("send", action);
    case Action::Verb::place: {
      const grid::Start where = grid::parse_start(stage_.map, action.text);
      stage_.body.place({stage_.stripes.point_of(where.cell), grid::heading(where.facing)});
      return acted("place", action);
    }
    case Action::Verb::lift:
      stage_.body.lift(true);
      return acted("lift", action);
    case Action::Verb::lower:
      stage_.body.lift(false);
      return acted("lower", action);
    case Action::Verb::obstacle:
      put_obstacle(action);
      return acted("obstacle", action);
    case Action::Verb::clear:
      clear_obstacle(action.text);
      return acted("clear", action);
    case Action::Verb::cover:
      stage_.robot.cover(action.part, true);
      return acted("cover", action);
    case Action::Verb::fault:
      return break_or_repair(action, t);
    case Action::Verb::power:
      return switch_power(action, t);
  }
  return {};
}

std::optional<wire::RunEvent::What> ScenarioPlayer::end(const Action& action, SimTime t) {
  switch (action.verb) {
    case Action::Verb::press:
      stage_.robot.release(action.part, t);
      return std::nullopt;
    case Action::Verb::lift:
      stage_.body.lift(false);
      return acted("lower", action);
    case Action::Verb::obstacle:
      clear_obstacle(action.text);
      return acted("clear", action);
    case Action::Verb::cover:
      stage_.robot.cover(action.part, false);
      return std::nullopt;
    case Action::Verb::fault:
      if (is_of_board(action)) {
        board_.fail(action.part, {"ok"}, t);
      } else {
        stage_.robot.fault(action.part, "ok", {});
      }
      repaired(action.part, t);
      return wire::FaultEnded{action.part, action.arguments};
    case Action::Verb::power:
      board_.switch_power(true, t);
      return wire::PowerBack{};
    default:
      return std::nullopt;
  }
}

}  // namespace robosim::scenario
