#include "sim/runner/remote_controller.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/error.h"
#include "sim/exec/host/confinement.h"
#include "sim/runner/answers.h"
#include "sim/runner/line_io.h"

namespace robosim::runner {

void RemoteController::answer(const wire::Answer& answer) const { write_line(wire::to_line(id_, answer)); }

namespace {

wire::Paused paused_of(const run::Standstill& standstill, int agent) {
  wire::Paused paused = to_wire(standstill.state(agent), standstill.sample(agent));
  if (const judge::Outcome* outcome = standstill.outcome(agent)) {
    paused.verdict = judge::to_string(outcome->verdict);
    paused.why = outcome->why;
  }
  return paused;
}

wire::Paused paused_of(const run::Standstill& standstill) {
  wire::Paused first = paused_of(standstill, 0);
  for (int agent = 1; agent < standstill.agent_count(); ++agent)
    first.others.push_back(paused_of(standstill, agent));
  return first;
}

}  // namespace

// Adds the present time to each line, so that the line runs now.
void RemoteController::add_lines(const wire::Act& act, run::Standstill& standstill) const {
  const std::string& lines = act.lines;
  std::string timed;
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', begin), lines.size());
    const std::string line = lines.substr(begin, end - begin);
    if (line.find_first_not_of(" \t\r") != std::string::npos)
      timed += fmt::format("at {}ms {}\n", standstill.state().t / kMillisecond, line);
    begin = end + 1;
  }
  standstill.add(scenario::parse_scenario(timed, script_file_), act.agent);
  answer(wire::Accepted{timed, act.agent});
}

std::optional<run::Leg> RemoteController::serve(const wire::DrivenRequest& request,
                                                run::Standstill& standstill) const {
  if (const auto* act = std::get_if<wire::Act>(&request)) {
    add_lines(*act, standstill);
  } else if (const auto* read = std::get_if<wire::ReadEeprom>(&request)) {
    answer(wire::Eeprom{standstill.eeprom(read->agent)});
  } else if (const auto* go_on = std::get_if<wire::GoOn>(&request)) {
    run::Leg leg{go_on->to_ns.value_or(kNever), go_on->until};
    standstill.check(leg);
    return leg;
  } else {
    return run::Leg{.end = true};
  }
  return std::nullopt;
}

run::Leg RemoteController::next(run::Standstill& standstill) {
  before_pause_(standstill.state().t);
  answer(paused_of(standstill));
  for (;;) {
    const auto line = read_line(&interrupted_);
    if (!line && interrupted_.load(std::memory_order_relaxed)) return {.end = true};
    if (!line) exec::keyed_exit(0);  // the client has disconnected
    const auto asked = wire::parse_driven_request(*line);
    try {
      if (!asked.request) throw InputError(asked.fault);
      if (const auto leg = serve(*asked.request, standstill)) return *leg;
    } catch (const InputError& error) {
      answer(wire::Refused{error.what()});
    }
  }
}

}  // namespace robosim::runner
