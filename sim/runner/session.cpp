#include "sim/runner/session.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstring>
#include <iterator>
#include <new>
#include <sstream>

#include "hal/board/board_spec.h"
#include "sim/base/archive.h"
#include "sim/base/child.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/system_error.h"
#include "sim/exec/gdb/server.h"
#include "sim/exec/host/confinement.h"
#include "sim/robot/description.h"
#include "sim/runner/abnormal_end.h"
#include "sim/runner/answers.h"
#include "sim/runner/fork_runs.h"
#include "sim/runner/known_hash.h"
#include "sim/runner/line_io.h"
#include "sim/runner/read_ahead.h"
#include "sim/runner/remote_controller.h"
#include "sim/runner/requested_run.h"
#include "sim/runner/sandbox_proxy.h"
#include "sim/wire/protocol.h"

namespace robosim::runner {
namespace {

constexpr int kLongestEnd_us = 2'000'000;

std::atomic<bool> interrupted{false};
std::atomic<SimTime> reached{run::kLoading};
std::atomic<int> acting_robot{0};
SimTime reached_at_last_look = -2;  // at the watchdog's last check
int acting_at_last_look = 0;        // at the watchdog's last check

void on_interrupt(int) { interrupted.store(true, std::memory_order_relaxed); }

void on_watchdog(int) {
  const SimTime now = reached.load(std::memory_order_relaxed);
  const int who = acting_robot.load(std::memory_order_relaxed);
  if (now == reached_at_last_look && who == acting_at_last_look)
    ::_exit(now == run::kLoading ? kLoadingStatus : kWatchdogStatus);
  reached_at_last_look = now;
  acting_at_last_look = who;
}

void start_watchdog() {
  struct sigaction action {};
  action.sa_handler = on_watchdog;
  action.sa_flags = SA_RESTART | SA_ONSTACK;
  ::sigaction(SIGVTALRM, &action, nullptr);
  const timeval every{kLongestTick_s, 0};
  const itimerval timer{every, every};
  ::setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

/// Returns the factory for `target`. Throws InputError if this runner has none.
const ExecutorFactory& factory_of(const ExecutorFactory& runner, const std::string& target) {
  if (target.empty() || target == runner.target) return runner;
  std::vector<std::string> names = {runner.target};
  for (const ExecutorFactory& other : runner.besides) {
    if (other.target == target) return other;
    names.push_back(other.target);
  }
  throw InputError(fmt::format("unknown target of robosim-{}: expected {}, got “{}”", runner.target,
                               one_of(names), target));
}

/// Returns the numbers of the request's robots that run native code.
std::vector<std::size_t> to_confine(const ExecutorFactory& runner, const wire::RunRequest& request) {
  std::vector<std::size_t> numbers;
  const std::vector<wire::AgentRequest> agents = agents_of(request);
  for (std::size_t i = 0; i < agents.size(); ++i) {
    try {
      if (factory_of(runner, agents[i].target).prepare_for_confinement) numbers.push_back(i);
    } catch (const InputError& error) {
      throw InputError(agents[i].name.empty() ? error.message()
                                              : "robot " + agents[i].name + ": " + error.message());
    }
  }
  return numbers;
}

// Formats the robot's number and then offsets in hexadecimal, separated by blanks.
std::string text_of(std::size_t agent, const std::vector<std::uintptr_t>& offsets) {
  std::string text = fmt::format("{:x} ", agent);
  for (const std::uintptr_t offset : offsets) text += fmt::format("{:x} ", offset);
  return text;
}

// Parses the result of text_of(), up to the first invalid number, and at most kMost numbers.
std::vector<std::uintptr_t> offsets_in(const std::string& text) {
  constexpr std::size_t kMost = 257;
  std::vector<std::uintptr_t> offsets;
  std::istringstream words(text);
  for (std::uintptr_t offset = 0; offsets.size() < kMost && words >> std::hex >> offset;)
    offsets.push_back(offset);
  return offsets;
}

constexpr char kAskLines = 'l';
constexpr char kAskToKeepCounters = 'c';

// Does work that a confined run requests because the run may not do it itself.
std::string serve_ask(const wire::RunRequest& request, const ReadAhead& ahead, char what,
                      const std::string& question) {
  if (what == kAskLines) {
    const std::vector<wire::AgentRequest> agents = agents_of(request);
    const std::vector<std::uintptr_t> numbers = offsets_in(question);
    if (numbers.empty() || numbers[0] >= agents.size()) return "";
    const std::string& image = agents[numbers[0]].image;
    const auto read = ahead.images.find(image);
    if (read == ahead.images.end()) return "";
    const std::vector<std::uintptr_t> offsets(numbers.begin() + 1, numbers.end());
    return read->second.lines->find(offsets, [&] { return exec::ask_addr2line(image, offsets); });
  }
  if (what != kAskToKeepCounters || request.counters.empty()) return "";
  try {
    write_file(request.counters, question);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void keep_counters(const wire::RunRequest& request, const std::string& counters, const SandboxProxy* proxy) {
  if (!proxy) return write_file(request.counters, counters);
  if (const std::string fault = proxy->ask(kAskToKeepCounters, counters); !fault.empty())
    throw InputError(fault);
}

result::RunResult run_request(const ExecutorFactory& factory, const wire::RunRequest& request,
                              const wire::Id& id, SandboxProxy* proxy, const ReadAhead& ahead) {
  // A run with a proxy is watched by the proxy. A run with a debugger is on an emulated chip, which never
  // hangs within a tick. Loading is watched, too: debug information can take any time to read.
  if (!proxy && request.gdb_port == 0) start_watchdog();
  // Never destroyed, since the end of the process frees everything.
  RequestedRun& run = *new RequestedRun(
      [&](const std::string& target, const BoardSpec& board, const std::filesystem::path& image) {
        return factory_of(factory, target).make(board, image);
      },
      request, [&id](wire::Event event) { write_line(wire::to_line(id, std::move(event))); },
      proxy ? SharedBatches{proxy->waiting(), [proxy] { return &proxy->hand_on(); }} : SharedBatches{},
      ahead.robots, ahead.map);
  std::optional<exec::gdb::Server> debugger;
  if (request.gdb_port > 0) {
    debugger.emplace(static_cast<std::uint16_t>(request.gdb_port), interrupted);
    run.debug_with(*debugger);
  }
  run.setup().interrupted = &interrupted;
  run.setup().reached = proxy ? &proxy->reached() : &reached;
  if (!request.agents.empty()) run.setup().acting = proxy ? &proxy->acting() : &acting_robot;
  RemoteController controller(id, request.script_file, interrupted, [&](SimTime t) { run.flush(t); });
  if (request.interactive) run.setup().controller = &controller;
  if (proxy) {
    const std::vector<wire::AgentRequest> agents = agents_of(request);
    for (const std::size_t agent : to_confine(factory, request))
      factory_of(factory, agents[agent].target)
          .prepare_for_confinement(
              run.executor(agent),
              [proxy, agent](const auto&, const auto& offsets) {
                return proxy->ask(kAskLines, text_of(agent, offsets));
              },
              ahead.images.at(agents[agent].image).content);
    // A fleet's chips, or a map that was not read ahead, may have enlarged the process's memory since the
    // fork.
    const bool has_grown = !request.agents.empty() || !ahead.map;
    if (exec::why_not_confined().empty()) proxy->confine(has_grown);
  }
  if (request.ways) return run_all_branches(run, request, proxy ? std::function<void()>() : start_watchdog);
  result::RunResult result = run.go();
  if (!request.counters.empty()) keep_counters(request, pack(run.executor().counters()), proxy);
  if (debugger) debugger->ended(result.status);
  return result;
}

// Returns the answer of `serve`, or an answer for the error that it throws.
template <typename Serve>
std::optional<wire::Answer> answer_of(Serve serve) {
  try {
    return serve();
  } catch (const InputError& error) {
    return wire::ErrorAnswer{"input", error.what()};
  } catch (const ToolMissing& error) {
    return wire::ErrorAnswer{"tool", error.what()};
  } catch (const std::exception& error) {
    const std::string fault = system_error_of(error);
    if (!fault.empty() && exec::is_confined())
      exec::keyed_exit(exec::kNoMemoryStatus);  // in a confined run, only missing memory causes these errors
    if (!fault.empty()) return wire::ErrorAnswer{"tool", fault};
    return wire::ErrorAnswer{"internal", error.what()};
  }
}

// Executes a request in a forked process. Returns the process's exit status.
int run_in_child(const ExecutorFactory& factory, const wire::RunRequest& request, const wire::Id& id,
                 pid_t runner, SandboxProxy* proxy, const ReadAhead& ahead) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != runner) return 0;  // the runner had ended before the call above
  if (proxy) {
    proxy->enter(sealed_images(ahead));
    route_through(*proxy);
  }
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  ::sigaction(SIGINT, &action, nullptr);
  const std::string answer =
      wire::to_line(id, *answer_of([&] { return run_request(factory, request, id, proxy, ahead); }));
  if (proxy) {
    proxy->answer(answer);
    exec::keyed_exit(0);
  }
  write_line(answer);
  return 0;
}

bool was_refused(const Ending& ending) {
  return ending.signal == SIGSYS || ending.status == exec::kRefusedStatus;
}

// Waits for the end of a process that has closed its pipes. Returns nothing if the process does not end soon:
// its firmware has then closed the pipes.
std::optional<Ending> end_of(Child& run) {
  for (int wait_us = 50, waited_us = 0; !run.has_ended();
       waited_us += wait_us, wait_us = std::min(2 * wait_us, 10'000)) {
    if (waited_us > kLongestEnd_us) return std::nullopt;
    ::usleep(static_cast<useconds_t>(wait_us));
  }
  return run.wait();
}

// Sends the batch that a run's process left behind. Skips an invalid batch, which firmware has overwritten.
void tell_rest(const wire::RunRequest& request, const wire::Id& id, wire::BatchMemory* waiting) {
  const wire::Batch rest = wire::BatchWriter(waiting).take();
  try {
    wire::BatchReader(request).read(rest.bytes, [](const wire::Event&) {});
  } catch (const wire::RunnerError&) {
    return;
  }
  if (!rest.bytes.empty()) write_line(wire::to_line(id, wire::Event(rest)));
}

/// Returns the processor time that a run may take, as a multiple of the simulated time. In a fleet, emulators
/// may be slower than the chips that they emulate.
double share_of(const wire::RunRequest& request) {
  constexpr double kOfEachInFleet = 10.0;
  return request.agents.empty() ? 1.0 : kOfEachInFleet * static_cast<double>(request.agents.size() + 1);
}

std::optional<wire::Answer> serve_confined_run(const ExecutorFactory& factory,
                                               const wire::RunRequest& request, const wire::Id& id,
                                               pid_t self, const ReadAhead& ahead) {
  SandboxProxy proxy(request.batches, request.interactive);
  Child child([&] { return run_in_child(factory, request, id, self, &proxy, ahead); });
  bool finds_lines = true;  // false once a search has found no lines: further searches are refused
  const SandboxProxy::Told told = proxy.serve(child,
                                              [&](char what, const std::string& question) {
                                                if (what == kAskLines && !finds_lines) return std::string();
                                                const std::string answer =
                                                    serve_ask(request, ahead, what, question);
                                                if (what == kAskLines) finds_lines = !answer.empty();
                                                return answer;
                                              },
                                              id, {request.for_ns, share_of(request)});
  if (request.batches && !told.answer) tell_rest(request, id, proxy.waiting());
  const auto guilty = [&] { return guilty_robot(request, to_confine(factory, request), proxy.acting()); };
  const SimTime time = proxy.time();
  const auto refused = [&](const std::string& cause) {
    return result_of_crash(request, cause, exec::kSandboxCheck, guilty(), time);
  };
  if (told.forged) return refused("it wrote to the pipe of its result");
  if (told.found == RunWatch::Found::loops)
    return result_of_crash(request, proxy.reached() == run::kLoading ? kNeverLoads : kLoops, "", guilty(),
                           time);
  if (told.found == RunWatch::Found::exhausts)
    return refused(fmt::format(
        "it took more processor time than allowed: {} s in addition to the simulated time", kLongestRun_s));
  if (told.found == RunWatch::Found::sleeps)
    return refused(
        fmt::format("it slept for {} s of wall time without advancing simulated time", kLongestSleep_s));
  const std::optional<Ending> ending = end_of(child);
  if (!ending) return refused("it closed the pipe of its result");
  if (was_refused(*ending)) return refused("the sandbox refuses a system call of the sketch");
  if (ending->status == exec::kNoMemoryStatus) return answer_without_memory(request, guilty(), time);
  if (!ending->ok()) return result_of_crash(request, cause_of(*ending), "", guilty(), time);
  if (!told.answer) return refused("it ended its process before the run was over");
  write_line(*told.answer);
  return std::nullopt;
}

// Serves a request for a run. Returns nothing if the forked process has answered.
std::optional<wire::Answer> serve_run(const ExecutorFactory& factory, const wire::RunRequest& request,
                                      const wire::Id& id, ReadAhead& ahead) {
  for (const wire::AgentRequest& agent : agents_of(request)) known_sha256(agent.image);
  const std::vector<std::size_t> confined = to_confine(factory, request);
  ahead = read_ahead(request, confined, std::move(ahead));
  const pid_t self = ::getpid();
  if (!confined.empty()) return serve_confined_run(factory, request, id, self, ahead);
  const Ending ending =
      Child([&] { return run_in_child(factory, request, id, self, nullptr, ahead); }).wait();
  if (ending.ok()) return std::nullopt;
  return result_of_crash(request, cause_of(ending), "", 0, 0);
}

// Describes a robot, and caches it in `known`: the client usually requests a run of this robot next.
wire::RobotInfo describe_robot(const wire::DescribeRobot& asked, Robots& known) {
  const auto robot = known_robot(asked.robot, known);
  known[asked.robot] = robot;
  wire::RobotInfo info = to_wire(robot::describe(*robot));
  if (asked.full) info.text = robot::full_text(asked.robot);
  return info;
}

void serve_line(const ExecutorFactory& factory, const std::string& line, ReadAhead& ahead) {
  const auto asked = wire::parse_request(line);
  const auto answer = answer_of([&]() -> std::optional<wire::Answer> {
    if (!asked.request) throw InputError(asked.fault);
    if (const auto* run = std::get_if<wire::RunRequest>(&*asked.request))
      return serve_run(factory, *run, asked.id, ahead);
    return describe_robot(std::get<wire::DescribeRobot>(*asked.request), ahead.robots);
  });
  if (answer) write_line(wire::to_line(asked.id, *answer));
}

wire::Hello hello_of(const ExecutorFactory& factory) {
  wire::Hello hello{"robosim-" + factory.target, wire::kProtocol, ROBOSIM_VERSION, factory.target};
  const auto runs_here = [](const ExecutorFactory& one) { return one.prepare_for_confinement != nullptr; };
  if (!runs_here(factory) && std::none_of(factory.besides.begin(), factory.besides.end(), runs_here))
    return hello;
  hello.no_sandbox_why = exec::why_not_confined();
  hello.sandbox = hello.no_sandbox_why.empty()                        ? "on"
                  : hello.no_sandbox_why == exec::what_kernel_lacks() ? "missing"
                                                                      : "off";
  return hello;
}

}  // namespace

int serve(const ExecutorFactory& factory) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // so that no runner outlives its client
  std::signal(SIGINT, SIG_IGN);        // handled by the run, not by its server
  std::signal(SIGPIPE, SIG_IGN);       // writes detect that the client has disconnected
  std::signal(SIGXFSZ, SIG_IGN);       // writes detect a limit on file sizes
  write_line(wire::to_line({}, hello_of(factory)));
  ReadAhead ahead;
  while (const auto line = read_line())
    if (!line->empty()) serve_line(factory, *line, ahead);
  return static_cast<int>(ExitStatus::ok);
}

}  // namespace robosim::runner
