#include "sim/runner/fork_runs.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <utility>

#include "sim/base/archive.h"
#include "sim/base/child.h"
#include "sim/base/descriptor.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/wire/protocol.h"

namespace robosim::runner {
namespace {

constexpr std::size_t kMostWays = 64;

/// Detects whether the sketch has sent a text. Passes the beginning of the run to the next listener, and
/// drops all other reports.
class Ear final : public run::Listener {
 public:
  Ear(std::string text, run::Listener* next) : text_(std::move(text)), next_(next) {}
  void began(const run::Beginning& beginning) override { next_->began(beginning); }
  void byte_sent(std::uint8_t byte, SimTime) override {
    if (has_heard_ || text_.empty()) return;
    last_ += static_cast<char>(byte);
    if (last_.size() > text_.size()) last_.erase(0, 1);
    has_heard_ = last_ == text_;
  }
  bool has_heard() const { return has_heard_; }

 private:
  const std::string text_;
  run::Listener* const next_;
  std::string last_;
  bool has_heard_ = false;
};

void check(const wire::RunRequest& request, bool may_copy) {
  if (!may_copy)
    throw InputError(
        "splitting a run requires a chip target, because on the host the run's process is confined");
  const std::size_t ways = request.ways->scripts.size();
  if (ways == 0 || ways > kMostWays)
    throw InputError(fmt::format("the branches of a run: expected 1 to {}, got {}", kMostWays, ways));
  if (!request.agents.empty()) throw InputError("splitting a run requires a run of one robot");
  if (request.interactive || request.gdb_port > 0 || request.why || request.source_ns)
    throw InputError("a run that is driven, debugged or traced to its cause cannot be split");
  if (request.samples_every_ns > 0 || request.columns_every_ns > 0 || request.pins || request.serial ||
      request.notes || request.io)
    throw InputError("a run that is split cannot stream events");
}

/// Returns the steps of a way's script. The run splits at `parted`. Throws InputError if a step is due
/// earlier, or waits for an event other than the split.
std::vector<scenario::Step> steps_of(const std::string& script, const wire::Ways& ways,
                                     const std::string& file, SimTime parted) {
  std::vector<scenario::Step> steps = scenario::parse_scenario(script, file);
  for (scenario::Step& step : steps) {
    scenario::Trigger& trigger = step.trigger;
    using enum scenario::Trigger::Kind;
    if (trigger.kind == serial && !ways.after.empty() && trigger.text == ways.after) {
      trigger = {at, parted + trigger.time, {}, {}, 0};
      continue;
    }
    if (trigger.kind != at)
      throw InputError(step.place, "expected a line that begins with “at”, or with the way's `after`");
    if (trigger.time < parted) throw InputError(step.place, "this line is due before the run is split");
  }
  return steps;
}

std::string read_all(const Descriptor& from) {
  std::string all;
  char some[65536];
  for (;;) {
    const ssize_t got = ::read(from.get(), some, sizeof some);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return all;
    all.append(some, static_cast<std::size_t>(got));
  }
}

result::RunResult in_copy_of_process(const std::function<wire::Answer()>& work) {
  Pipe pipe;
  const pid_t parent = ::getpid();
  Child child([&] {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) return 0;
    pipe.read.close();
    write_all(pipe.write.get(), wire::to_line({}, work()));
    return 0;
  });
  pipe.write.close();
  const std::string line = read_all(pipe.read);
  const Ending ending = child.wait();
  if (!ending.ok() || line.empty()) throw std::runtime_error("the process of a branch " + ending.text());
  const wire::Line answer = wire::parse_line(line);
  if (const auto* error = std::get_if<wire::ErrorAnswer>(&answer.content)) throw InputError(error->message);
  return std::get<result::RunResult>(answer.content);
}

}  // namespace

result::RunResult run_all_branches(RequestedRun& run, const wire::RunRequest& request,
                                   const std::function<void()>& in_copy) {
  check(request, in_copy != nullptr);
  const wire::Ways& ways = *request.ways;
  run::Setup& setup = run.setup();
  Ear ear(ways.after, setup.agents.front().listener);
  setup.agents.front().listener = &ear;
  run::Simulation simulation(setup);
  if (ways.after.empty()) {
    simulation.run_until(ways.at_ns);
  } else {
    while (!ear.has_heard() && !simulation.is_over()) simulation.run_until(simulation.now() + kTick);
  }
  const auto go = [&](std::size_t way) {
    if (!simulation.is_over())
      simulation.add(steps_of(ways.scripts[way], ways, request.script_file, simulation.now()));
    simulation.run_until(setup.limit);
    result::RunResult result = run.result_of(simulation.end());
    if (!request.counters.empty())
      write_file(request.counters + (way == 0 ? "" : fmt::format(".{}", way + 1)),
                 pack(run.executor().counters()));
    return result;
  };
  std::vector<result::RunResult> others;
  for (std::size_t way = 1; way < ways.scripts.size(); ++way)
    others.push_back(in_copy_of_process([&]() -> wire::Answer {
      in_copy();
      try {
        return go(way);
      } catch (const InputError& error) {
        return wire::ErrorAnswer{"input", error.what()};
      }
    }));
  result::RunResult result = go(0);
  result.ways = std::move(others);
  return result;
}

}  // namespace robosim::runner
