#include "sim/run/director.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim::run {
namespace {

std::string describe(const Action& action) {
  switch (action.verb) {
    case Action::Verb::press:
      return action.part + " pressed";
    case Action::Verb::release:
      return action.part + " released";
    case Action::Verb::send:
      return action.part.empty() ? fmt::format("\"{}\" sent to the sketch", action.text)
                                 : fmt::format("{} sent to {}", action.text, action.part);
    case Action::Verb::place:
      return "robot placed at " + action.text;
    case Action::Verb::cover:
      return action.part + " covered";
    case Action::Verb::fault: {
      std::string text = fmt::format("fault: {}", action.part);
      for (const std::string& argument : action.arguments) text += " " + argument;
      return text;
    }
    case Action::Verb::power:
      return "power " + action.part;
  }
  return "";
}

}  // namespace

Director::Director(std::vector<Step> steps, const Stage& stage, const Progress& progress) : stage_(stage) {
  for (Step& step : steps) {
    check(step, progress);
    if (step.trigger.kind == Trigger::Kind::serial)
      longest_text_ = std::max(longest_text_, step.trigger.text.size());
    pending_.push_back({std::move(step), false});
  }
}

void Director::check(const Step& step, const Progress& progress) const {
  const Action& action = step.action;
  try {
    if (step.trigger.kind == Trigger::Kind::station) {
      std::vector<std::string> names;
      for (const Target& station : progress.stations()) names.push_back(station.name);
      if (std::find(names.begin(), names.end(), step.trigger.text) == names.end())
        throw InputError(
            fmt::format("there is no station {}; {}", step.trigger.text,
                        names.empty() ? "the map has none" : "the stations are " + one_of(names)));
    }
    if (action.verb == Action::Verb::place) grid::parse_start(stage_.map, action.text);
    if (action.verb == Action::Verb::press || action.verb == Action::Verb::release)
      stage_.robot.check_press(action.part);
    if (action.verb == Action::Verb::send && !action.part.empty()) stage_.robot.check_send(action.part);
    if (action.verb == Action::Verb::cover) stage_.robot.check_cover(action.part);
    if (action.verb == Action::Verb::fault)
      stage_.robot.check_fault(action.part, action.arguments.front(),
                               {action.arguments.begin() + 1, action.arguments.end()});
  } catch (const InputError& error) {
    throw InputError(step.place, error.message());
  }
}

void Director::hear(std::uint8_t byte) {
  if (longest_text_ == 0) return;
  heard_ += static_cast<char>(byte);
  if (heard_.size() > 4 * longest_text_) heard_.erase(0, heard_.size() - longest_text_);
  for (Pending& pending : pending_)
    if (pending.step.trigger.kind == Trigger::Kind::serial && heard_.ends_with(pending.step.trigger.text))
      pending.heard = true;
}

bool Director::due(const Pending& pending, SimTime t, const Progress& progress) const {
  const Trigger& trigger = pending.step.trigger;
  switch (trigger.kind) {
    case Trigger::Kind::at:
      return t >= trigger.time;
    case Trigger::Kind::serial:
      return pending.heard;
    case Trigger::Kind::station:
      return progress.is_visited(trigger.text);
  }
  return false;
}

void Director::act(SimTime t, const Progress& progress, std::vector<std::string>& notes) {
  for (std::size_t i = 0; i < undo_.size();) {
    if (t < undo_[i].at) {
      ++i;
      continue;
    }
    perform(undo_[i].action, t, true);
    undo_.erase(undo_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  for (std::size_t i = 0; i < pending_.size();) {
    if (!due(pending_[i], t, progress)) {
      ++i;
      continue;
    }
    const Step step = pending_[i].step;
    pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(i));
    perform(step.action, t, false);
    notes.push_back(describe(step.action));
    if (step.action.duration) undo_.push_back({t + *step.action.duration, step.action});
  }
}

void Director::perform(const Action& action, SimTime t, bool undo) {
  switch (action.verb) {
    case Action::Verb::press:
      if (undo) {
        stage_.robot.release(action.part, t);
      } else {
        stage_.robot.press(action.part, t);
      }
      break;
    case Action::Verb::release:
      stage_.robot.release(action.part, t);
      break;
    case Action::Verb::send:
      if (!action.part.empty()) stage_.robot.send(action.part, action.bits, t);
      if (!action.part.empty()) break;
      for (const char c : action.text) stage_.executor.board().receive_byte(static_cast<std::uint8_t>(c), t);
      break;
    case Action::Verb::place: {
      const grid::Start where = grid::parse_start(stage_.map, action.text);
      stage_.body.place({stage_.stripes.point_of(where.cell), grid::heading(where.facing)});
      break;
    }
    case Action::Verb::cover:
      stage_.robot.cover(action.part, !undo);
      break;
    case Action::Verb::fault:
      stage_.robot.fault(action.part, action.arguments.front(),
                         {action.arguments.begin() + 1, action.arguments.end()});
      break;
    case Action::Verb::power: {
      const bool on = undo || action.part == "on";
      if (on == powered_) break;
      powered_ = on;
      stage_.robot.power(on, t);
      if (on) {
        stage_.executor.power_on(t);
      } else {
        stage_.executor.power_off(t);
      }
      break;
    }
  }
}

}  // namespace robosim::run
