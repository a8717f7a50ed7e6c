#include "sim/judge/contest.h"

#include "sim/judge/goal.h"

namespace robosim::judge {
namespace {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

}  // namespace

Contest::Contest(const Goal& goal, const map::Map& map, Vec2 start) {
  switch (goal.kind) {
    case Goal::Kind::robotrace:
      rules_.emplace<Race>(map, Race::Finish::at_rest_in_area);
      break;
    case Goal::Kind::ukmars:
      rules_.emplace<Race>(map, Race::Finish::line);
      break;
    case Goal::Kind::drag_race:
      rules_.emplace<DragRace>(map);
      break;
    case Goal::Kind::rescue_line:
      rules_.emplace<RescueRun>(map, start);
      break;
    case Goal::Kind::line_maze:
      rules_.emplace<MazeTries>(map, start, goal.tries);
      break;
    default:
      break;
  }
}

void Contest::look(const RulesInput& now, Events& events) {
  std::visit(Overloaded{[](std::monostate) {}, [&](auto& rules) { rules.look(now, events); }}, rules_);
}

bool Contest::reached() const {
  return std::visit(Overloaded{[](std::monostate) { return false; },  //
                               [](const auto& rules) { return rules.reached(); }},
                    rules_);
}

bool Contest::over(SimTime t) const {
  const auto* const rescue = std::get_if<RescueRun>(&rules_);
  return rescue && rescue->over(t);
}

bool Contest::give_up(Events& events) {
  auto* const rescue = std::get_if<RescueRun>(&rules_);
  if (rescue) rescue->give_up(events);
  return rescue;
}

std::optional<Pose> Contest::take_hand() {
  auto* const rescue = std::get_if<RescueRun>(&rules_);
  return rescue ? rescue->take_hand() : std::nullopt;
}

std::string Contest::summary() const {
  return std::visit(Overloaded{[](std::monostate) { return std::string(); },
                               [](const auto& rules) { return rules.summary(); }},
                    rules_);
}

void Contest::score(result::Metrics& metrics) const {
  std::visit(Overloaded{[](std::monostate) {}, [&](const auto& rules) { rules.score(metrics); }}, rules_);
}

}  // namespace robosim::judge
