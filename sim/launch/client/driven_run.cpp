#include "sim/launch/client/driven_run.h"

#include "sim/base/error.h"
#include "sim/launch/client/process.h"

namespace robosim::client {

DrivenRun::DrivenRun(Runner& runner, wire::RunRequest request, wire::OnEvent on_event)
    : runner_(runner), on_event_(std::move(on_event)), scripts_{request.script} {
  for (const wire::AgentRequest& agent : request.agents) scripts_.push_back(agent.script);
  for (std::string& script : scripts_)
    if (!script.empty() && script.back() != '\n') script += '\n';
  request.interactive = true;
  runner_.begin(request);
  id_ = runner_.last_id_;
  take(*runner_.answer(true, on_event_));
}

DrivenRun::~DrivenRun() {
  try {
    end();
  } catch (const std::exception&) {
    // The runner has died, which ends the run.
  }
}

wire::Line DrivenRun::ask(const wire::DrivenRequest& request) {
  runner_.process_->write(wire::to_line(id_, request));
  return *runner_.answer(true, on_event_);
}

// Stores a pause or the result. Returns false if the run is over.
bool DrivenRun::take(wire::Line line) {
  if (auto* paused = std::get_if<wire::Paused>(&line.content)) {
    state_ = std::move(*paused);
    return true;
  }
  if (auto* result = std::get_if<result::RunResult>(&line.content)) {
    result_ = std::move(*result);
    return false;
  }
  if (const auto* refused = std::get_if<wire::Refused>(&line.content)) throw InputError(refused->message);
  throw wire::RunnerError("unexpected answer of the runner");
}

void DrivenRun::act(const std::string& lines, std::size_t agent) {
  if (over()) throw InputError("the run is over and accepts no more requests");
  wire::Line line = ask(wire::Act{lines, static_cast<int>(agent)});
  if (const auto* accepted = std::get_if<wire::Accepted>(&line.content)) {
    scripts_.at(agent) += accepted->lines;
    return;
  }
  take(std::move(line));
}

std::vector<std::uint8_t> DrivenRun::eeprom(std::size_t agent) {
  if (over()) throw InputError("the run is over, and its memory no longer exists");
  wire::Line line = ask(wire::ReadEeprom{static_cast<int>(agent)});
  if (auto* memory = std::get_if<wire::Eeprom>(&line.content)) return std::move(memory->bytes);
  take(std::move(line));
  return {};
}

bool DrivenRun::go_on(std::int64_t to_ns, const std::vector<result::Stop>& stops) {
  if (over() || to_ns <= state_.t_ns) return !over();
  return take(ask(wire::GoOn{to_ns, stops}));
}

const result::RunResult& DrivenRun::finish() {
  while (!over()) take(ask(wire::GoOn{}));
  return *result_;
}

const result::RunResult& DrivenRun::end() {
  while (!over()) take(ask(wire::End{}));
  return *result_;
}

}  // namespace robosim::client
