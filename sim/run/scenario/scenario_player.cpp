#include "sim/run/scenario/scenario_player.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "sim/base/did_you_mean.h"
#include "sim/base/noise.h"
#include "sim/run/scenario/places.h"

namespace robosim::scenario {
namespace {

result::ScriptActed acted(const char* verb, const Action& action) {
  using enum Action::Verb;
  const bool has_bytes =
      action.verb != lift && action.verb != lower && action.verb != sweep && action.verb != tilt;
  return {verb, action.part, has_bytes ? action.text : ""};
}

}  // namespace

ScenarioPlayer::ScenarioPlayer(std::vector<Step> steps, const Stage& stage, const judge::Progress& progress)
    : stage_(stage),
      board_(stage.executor, stage.robot, stage.seed, stage.number),
      changes_(stage.map, stage.stripes, stage.world) {
  add(std::move(steps), progress);
}

void ScenarioPlayer::restore(const Saved& saved) {
  state_ = saved.own;
  board_.restore(saved.board);
  changes_.restore(saved.world);
}

void ScenarioPlayer::check_limits(const std::vector<Step>& steps) {
  std::size_t all = state_.timed.size() + state_.awaiting.size(), awaited = state_.awaiting.size();
  std::size_t changes = state_.change_lines;
  std::set<std::pair<int, int>> cells = state_.obstacle_cells;
  const auto refuse = [](const Step& step, std::size_t most, const char* what) {
    throw InputError(step.place, fmt::format("the script is too long: expected at most {} {}", most, what));
  };
  for (const Step& step : steps) {
    if (++all > kMostSteps) refuse(step, kMostSteps, "lines");
    if (step.trigger.kind != Trigger::Kind::at && ++awaited > kMostAwaited)
      refuse(step, kMostAwaited, "lines that begin with after");
    using enum Action::Verb;
    const Action::Verb verb = step.action.verb;
    if ((verb == paint || verb == erase || verb == door) && ++changes > kMostChanges)
      refuse(step, kMostChanges, "lines that paint, erase or move a door");
    if (verb != obstacle) continue;
    const map::CellAt cell = parse_cell(stage_.map, step.action.text);
    if (cells.insert({cell.x, cell.y}).second && cells.size() > kMostObstacles)
      refuse(step, kMostObstacles, "cells with obstacles");
  }
  state_.obstacle_cells = std::move(cells);
  state_.change_lines = changes;
}

void ScenarioPlayer::add(std::vector<Step> steps, const judge::Progress& progress) {
  std::vector<std::optional<ReadFault>> faults;
  for (Step& step : steps) {
    if (!step.varies.empty()) draw(step, progress);
    faults.push_back(check(step, progress));
  }
  check_limits(steps);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Trigger trigger = steps[i].trigger;
    if (trigger.kind == Trigger::Kind::serial)
      state_.longest_text = std::max(state_.longest_text, trigger.text.size());
    Pending pending{state_.steps++, std::move(steps[i]), std::move(faults[i])};
    if (trigger.kind == Trigger::Kind::at)
      state_.timed.emplace(std::pair(trigger.time, pending.number), std::move(pending));
    else
      state_.awaiting.push_back(std::move(pending));
  }
}

void ScenarioPlayer::draw(Step& step, const judge::Progress& progress) const {
  for (const double end : {-1.0, 1.0})
    check(parse_varied(step, [end](std::size_t) { return end; }), progress);
  if (stage_.profile == Profile::ideal) return;
  // The stream depends only on the step's text, so that other lines do not affect it.
  const NoiseStream stream(stage_.seed, stage_.number, step.varies, "script");
  step = parse_varied(step, [&](std::size_t n) { return 2.0 * stream.uniform(n) - 1.0; });
}

std::optional<ScenarioPlayer::ReadFault> ScenarioPlayer::check(const Step& step,
                                                               const judge::Progress& progress) const {
  const Action& action = step.action;
  try {
    if (step.trigger.kind == Trigger::Kind::station) {
      std::vector<std::string> names;
      for (const judge::Waypoint& station : progress.stations()) names.push_back(station.name);
      if (std::find(names.begin(), names.end(), step.trigger.text) == names.end())
        throw InputError(names.empty()
                             ? fmt::format("unknown station “{}”: the map has no stations", step.trigger.text)
                             : fmt::format("unknown station: {}", expected_one_of(step.trigger.text, names)));
    }
    if (step.trigger.kind == Trigger::Kind::told) stage_.robot.check_tells(step.trigger.part);
    if (step.trigger.kind == Trigger::Kind::eeprom) board_.check_eeprom();
    changes_.check(action);
    if (action.verb == Action::Verb::place) parse_place(stage_.map, stage_.stripes, action.text);
    if (action.verb == Action::Verb::press || action.verb == Action::Verb::release)
      stage_.robot.check_press(action.part);
    if (action.verb == Action::Verb::send && !action.part.empty())
      stage_.robot.check_send(action.part, {action.text, action.held});
    if (action.verb == Action::Verb::cover) stage_.robot.check_cover(action.part);
    if (action.verb == Action::Verb::fault)
      return read_fault(action.part, action.arguments, action.duration.has_value());
    return std::nullopt;
  } catch (const InputError& error) {
    throw InputError(step.place, error.message());
  }
}

ScenarioPlayer::ReadFault ScenarioPlayer::read_fault(const std::string& part,
                                                     const std::vector<std::string>& arguments,
                                                     bool ends) const {
  std::vector<std::string> names = stage_.robot.breakable();
  const bool of_robot = std::find(names.begin(), names.end(), part) != names.end();
  if (!of_robot && BoardFaults::knows(part)) return board_.read(part, arguments, ends);
  names.insert(names.end(), BoardFaults::names().begin(), BoardFaults::names().end());
  if (!of_robot) throw InputError(fmt::format("unknown part for a fault: {}", expected_one_of(part, names)));
  return stage_.robot.read_fault(part, arguments.front(), {arguments.begin() + 1, arguments.end()});
}

void ScenarioPlayer::hear(std::uint8_t byte) {
  if (state_.longest_text == 0) return;
  state_.heard += static_cast<char>(byte);
  if (state_.heard.size() > 4 * state_.longest_text)
    state_.heard.erase(0, state_.heard.size() - state_.longest_text);
  for (Pending& pending : state_.awaiting)
    if (pending.step.trigger.kind == Trigger::Kind::serial &&
        state_.heard.ends_with(pending.step.trigger.text))
      pending.heard = true;
}

void ScenarioPlayer::hear(const robot::PartText& told) {
  for (Pending& pending : state_.awaiting) {
    const Trigger& trigger = pending.step.trigger;
    if (trigger.kind == Trigger::Kind::told && trigger.part == told.part &&
        told.text.find(trigger.text) != std::string::npos)
      pending.heard = true;
  }
}

bool ScenarioPlayer::met(const Pending& pending, const judge::Progress& progress) const {
  const Trigger& trigger = pending.step.trigger;
  switch (trigger.kind) {
    case Trigger::Kind::at:
      return true;
    case Trigger::Kind::serial:
    case Trigger::Kind::told:
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

// Ends actions whose time is over. If several end in the same tick, they end in the order in which they
// began.
void ScenarioPlayer::end_what_is_over(SimTime t, judge::Events& events) {
  std::map<std::uint64_t, std::pair<SimTime, Undo>> over;
  while (!state_.undo.empty() && state_.undo.begin()->first.first <= t) {
    Undo& undo = state_.undo.begin()->second;
    if (const std::string subject = subject_of(undo.action); !subject.empty()) state_.lasting.erase(subject);
    over.emplace(undo.number, std::pair(state_.undo.begin()->first.first, std::move(undo)));
    state_.undo.erase(state_.undo.begin());
  }
  for (const auto& [number, undo] : over) {
    if (const std::string finger = finger_of(undo.second.action); !finger.empty()) {
      std::set<Moment>& all = state_.fingers[finger];
      all.erase({undo.first, number});
      if (!all.empty()) continue;
    }
    if (auto event = end(undo.second, t)) events.push_back(std::move(*event));
  }
}

// Notes a finger that presses or covers a part until `due`. The verb `release` removes all fingers from a
// button.
void ScenarioPlayer::note_finger(const Action& action, const Moment& due) {
  if (action.verb == Action::Verb::release) {
    const auto all = state_.fingers.extract("press " + action.part);
    if (all)
      for (const auto& one : all.mapped()) state_.undo.erase(one);
  } else if (const std::string finger = finger_of(action); !finger.empty()) {
    state_.fingers[finger].insert(due);
  }
}

void ScenarioPlayer::carry_out(Pending pending, SimTime t, judge::Events& events) {
  Action& action = pending.step.action;
  const std::string subject = subject_of(action);
  if (const auto before = state_.lasting.find(subject); before != state_.lasting.end()) {
    state_.undo.erase(before->second);
    state_.lasting.erase(before);
  }
  if (subject == "body" && state_.sweep) {  // a sweep ends where it began
    stage_.body.place(state_.sweep->base);
    state_.sweep.reset();
  }
  if (subject == "body") state_.tilt.reset();
  events.push_back(perform(action, pending.fault, t));
  const Moment due(action.duration ? t + *action.duration : kNever, state_.undos++);
  note_finger(action, due);
  if (!action.duration) return;
  if (!subject.empty()) state_.lasting[subject] = due;
  state_.undo.emplace(due, Undo{due.second, std::move(action), std::move(pending.fault)});
}

// Runs the steps that are due. In one tick, they run in the order of the script.
void ScenarioPlayer::act_now(SimTime t, const judge::Progress& progress, judge::Events& events) {
  if (!state_.undo.empty()) end_what_is_over(t, events);
  if (state_.sweep) stage_.body.carry(state_.sweep->at(t));
  if (state_.tilt) stage_.body.tilt(state_.tilt->at(t));
  changes_.act(t);
  if (state_.awaiting.empty() && (state_.timed.empty() || state_.timed.begin()->first.first > t)) return;
  std::map<std::uint64_t, Pending> due;
  while (!state_.timed.empty() && state_.timed.begin()->first.first <= t) {
    Pending& pending = state_.timed.begin()->second;
    due.emplace(pending.number, std::move(pending));
    state_.timed.erase(state_.timed.begin());
  }
  const auto carry_out_before = [&](std::uint64_t number) {
    while (!due.empty() && due.begin()->first < number) {
      Pending next = std::move(due.begin()->second);
      due.erase(due.begin());
      carry_out(std::move(next), t, events);
    }
  };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < state_.awaiting.size(); ++i) {
    Pending& pending = state_.awaiting[i];
    carry_out_before(pending.number);
    if (!met(pending, progress)) {
      if (kept != i) state_.awaiting[kept] = std::move(pending);
      ++kept;
    } else if (const SimTime wait = pending.step.trigger.time; wait > 0) {
      state_.timed.emplace(std::pair(t + wait, pending.number), std::move(pending));
    } else {
      carry_out(std::move(pending), t, events);
    }
  }
  state_.awaiting.erase(state_.awaiting.begin() + static_cast<std::ptrdiff_t>(kept), state_.awaiting.end());
  carry_out_before(std::numeric_limits<std::uint64_t>::max());
}

void ScenarioPlayer::note_repair(const std::string& part, SimTime t) {
  const auto fault = state_.broken.find(part);
  if (fault == state_.broken.end()) return;
  state_.faults[fault->second].ended = t;
  state_.broken.erase(fault);
}

void ScenarioPlayer::bring_about(const ReadFault& fault, SimTime t) {
  if (const auto* of_part = std::get_if<robot::PartFault>(&fault)) {
    stage_.robot.fault(*of_part);
  } else {
    board_.fail(std::get<BoardFault>(fault), t);
  }
}

void ScenarioPlayer::repair(const ReadFault& fault, SimTime t) {
  if (const auto* of_part = std::get_if<robot::PartFault>(&fault)) {
    stage_.robot.fault({of_part->part, {}});
  } else {
    board_.repair(std::get<BoardFault>(fault), t);
  }
}

result::RunEvent::What ScenarioPlayer::break_or_repair(const Action& action, const ReadFault& fault,
                                                       SimTime t) {
  const bool ran = board_.powered();
  bring_about(fault, t);
  note_repair(action.part, t);
  const auto* const of_part = std::get_if<robot::PartFault>(&fault);
  const bool whole =
      of_part ? of_part->fault.failure == robot::Failure::ok : repairs(std::get<BoardFault>(fault));
  if (whole) return result::FaultEnded{action.part, action.arguments, true};
  state_.broken[action.part] = state_.faults.size();
  state_.faults.push_back(
      {action.part, action.arguments, of_part ? std::optional(of_part->fault.failure) : std::nullopt, t});
  return result::FaultBegan{action.part, action.arguments, ran && !board_.powered()};
}

void ScenarioPlayer::feed(double volts, SimTime t, judge::Events& events) {
  const bool ran = board_.powered();
  board_.feed(volts, t);
  if (ran && !board_.powered()) events.push_back(result::PowerLost{});
  if (!ran && board_.powered()) events.push_back(result::PowerBack{});
}

result::RunEvent::What ScenarioPlayer::switch_power(const Action& action, SimTime t) {
  const bool ran = board_.powered();
  board_.switch_power(action.part == "on", t);
  if (action.part == "on") return result::PowerBack{};
  if (!ran || board_.powered()) return result::PowerLost{};
  return result::PowerLost{board_.leave_half_written(action.half_written, t)};
}

result::RunEvent::What ScenarioPlayer::perform(const Action& action, const std::optional<ReadFault>& fault,
                                               SimTime t) {
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
        stage_.robot.send(action.part, {action.text, action.held}, t);
      }
      return acted("send", action);
    case Action::Verb::place:
      stage_.body.place(parse_place(stage_.map, stage_.stripes, action.text));
      return acted("place", action);
    case Action::Verb::lift:
      stage_.body.lift(true);
      return acted("lift", action);
    case Action::Verb::lower:
      stage_.body.lift(false);
      return acted("lower", action);
    case Action::Verb::sweep:
      state_.sweep = Sweep{stage_.body.pose(), t, action.period, action.reach};
      stage_.body.carry(state_.sweep->at(t));
      return acted("sweep", action);
    case Action::Verb::tilt:
      state_.tilt = Tilt{t, action.period, t + *action.duration, action.angle, action.side};
      stage_.body.tilt(state_.tilt->at(t));
      return acted("tilt", action);
    case Action::Verb::obstacle:
      return changes_.put_obstacle(action, t);
    case Action::Verb::clear:
      changes_.clear_obstacle(action.text);
      return acted("clear", action);
    case Action::Verb::cover:
      stage_.robot.cover(action.part, true);
      return acted("cover", action);
    case Action::Verb::fault:
      return break_or_repair(action, *fault, t);
    case Action::Verb::power:
      return switch_power(action, t);
    case Action::Verb::paint:
    case Action::Verb::erase:
    case Action::Verb::door:
    case Action::Verb::light:
      return changes_.perform(action);
  }
  return {};
}

std::optional<result::RunEvent::What> ScenarioPlayer::end(const Undo& undo, SimTime t) {
  const Action& action = undo.action;
  switch (action.verb) {
    case Action::Verb::press:
      stage_.robot.release(action.part, t);
      return acted("release", action);
    case Action::Verb::lift:
    case Action::Verb::tilt:
      state_.tilt.reset();
      stage_.body.lift(false);
      return acted("lower", action);
    case Action::Verb::sweep:
      stage_.body.place(state_.sweep->base);
      state_.sweep.reset();
      return acted("lower", action);
    case Action::Verb::obstacle:
      changes_.clear_obstacle(action.text);
      return acted("clear", action);
    case Action::Verb::cover:
      stage_.robot.cover(action.part, false);
      return acted("uncover", action);
    case Action::Verb::fault:
      repair(*undo.fault, t);
      note_repair(action.part, t);
      return result::FaultEnded{action.part, action.arguments, false};
    case Action::Verb::power:
      board_.switch_power(true, t);
      return result::PowerBack{};
    case Action::Verb::paint:
    case Action::Verb::erase:
    case Action::Verb::door:
    case Action::Verb::light:
      return changes_.undo(action);
    default:
      return std::nullopt;
  }
}

}  // namespace robosim::scenario
