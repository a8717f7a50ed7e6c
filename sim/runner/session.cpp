#include "sim/runner/session.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "hal/board/board_spec.h"
#include "sim/base/bundle.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/exec/gdb/server.h"
#include "sim/robot/description.h"
#include "sim/runner/answers.h"
#include "sim/runner/known_hash.h"
#include "sim/runner/lines.h"
#include "sim/runner/remote_controller.h"
#include "sim/runner/request.h"

namespace robosim::runner {
namespace {

constexpr int kProtocol = 1;

// Firmware that spends this much processor time inside one tick (usually a microsecond) will never end it: it
// loops in code that is not instrumented, such as a library function that was handed an endless string.
constexpr int kWatchdogSeconds = 5;
constexpr int kWatchdogStatus = 99;

std::atomic<bool> interrupted{false};
std::atomic<SimTime> reached{-1};
SimTime reached_at_last_look = -2;  // the watchdog's own

void on_interrupt(int) { interrupted.store(true, std::memory_order_relaxed); }

void on_watchdog(int) {
  const SimTime now = reached.load(std::memory_order_relaxed);
  if (now == reached_at_last_look) ::_exit(kWatchdogStatus);
  reached_at_last_look = now;
}

void start_watchdog() {
  struct sigaction action {};
  action.sa_handler = on_watchdog;
  action.sa_flags = SA_RESTART | SA_ONSTACK;
  ::sigaction(SIGVTALRM, &action, nullptr);
  const timeval every{kWatchdogSeconds, 0};
  const itimerval timer{every, every};
  ::setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

// Turns what a run tells into protocol events.
class Narrator final : public run::Listener {
 public:
  Narrator(nlohmann::json id, const RunRequest& request, const BoardSpec& board, exec::Executor& executor)
      : id_(std::move(id)), request_(request), board_(board), executor_(executor) {}

  void began(const run::Beginning& beginning) override {
    send("started", to_json(beginning));
    if (request_.gdb_port > 0) send("debugger_awaited", {{"port", request_.gdb_port}});
  }
  void sampled(const run::Sample& s) override { send("sample", to_json(s)); }
  void happened(const wire::RunEvent& event) override {
    if (request_.stream_notes) send("note", {{"t_ns", event.t_ns}, {"text", wire::text_of(event)}});
  }
  void pin_changed(Pin pin, const PinDrive& drive, SimTime t) override {
    static constexpr const char* kModes[] = {"input", "input_pullup", "output"};
    if (!request_.stream_pins) return;
    detail("pin", t,
           {{"t_ns", t},
            {"pin", board_.pins[pin].name},
            {"mode", kModes[static_cast<int>(drive.mode)]},
            {"level", drive.level},
            {"pwm", drive.pwm},
            {"duty", drive.duty},
            {"tone_hz", drive.tone_hz}});
  }
  bool wants_inputs() const override { return request_.stream_io; }
  void level_seen(Pin pin, bool level, SimTime t) override {
    detail("level", t, {{"t_ns", t}, {"pin", board_.pins[pin].name}, {"level", level}});
  }
  void volts_seen(Pin pin, double volts, SimTime t) override {
    detail("volts", t, {{"t_ns", t}, {"pin", board_.pins[pin].name}, {"volts", volts}});
  }
  void byte_received(std::uint8_t byte, SimTime t) override {
    detail("byte", t, {{"t_ns", t}, {"value", byte}, {"sent", false}});
  }
  void byte_sent(std::uint8_t byte, SimTime t) override {
    if (request_.stream_io) {
      const Json event{{"t_ns", t}, {"value", byte}, {"sent", true}};
      if (request_.source) {
        const exec::SourceLine source = executor_.source_of(byte);
        if (in_span(t)) send_with("byte", event, source);
      } else {
        send("byte", event);
      }
    }
    if (!request_.stream_serial) return;
    line_ += static_cast<char>(byte);
    if (byte == '\n' || line_.size() >= 256) flush_serial(t);
  }
  void flush_serial(SimTime t) {
    if (!line_.empty()) send("serial", {{"t_ns", t}, {"text", line_}});
    line_.clear();
  }

 private:
  bool in_span(SimTime t) const { return t >= request_.source->first && t < request_.source->second; }
  void detail(const char* event, SimTime t, const Json& body) {
    if (!request_.source)
      send(event, body);
    else if (in_span(t))
      send_with(event, body, executor_.source());
  }
  void send_with(const char* event, Json body, const exec::SourceLine& source) {
    if (!source.file.empty())
      body["source"] = {{"function", source.function}, {"file", source.file}, {"line", source.line}};
    send(event, body);
  }
  void send(const char* event, const Json& body) {
    Json line = with_id(id_);
    line["event"] = event;
    line.update(body);
    write_line(line);
  }

  nlohmann::json id_;
  const RunRequest& request_;
  const BoardSpec& board_;
  exec::Executor& executor_;
  std::string line_;
};

// The outcome, together with what it rests on.
Json result_of(const judge::Outcome& outcome, const RunRequest& request, const robot::Description& robot) {
  Json result = to_json(outcome);
  result["goal"] = judge::to_string(outcome.goal);
  result["for_s"] = static_cast<double>(request.limit) * 1e-9;
  result["seed"] = request.seed;
  result["profile"] = request.profile == robot::Profile::ideal ? "ideal" : "typical";
  result["map_sha256"] = sha256_of_file(request.map);
  result["robot_sha256"] = robot.sha256;
  result["image_sha256"] = known_sha256(request.image);
  return result;
}

void run_request(const Target& target, const RunRequest& request, const nlohmann::json& id, Json& answer) {
  const grid::Map map = grid::read_map(request.map);
  const robot::Description robot = robot::load_description(request.robot);
  const std::unique_ptr<exec::Executor> executor = target.make_executor(*robot.board, request.image);

  if (request.clock_start > 0) executor->set_clock_start(request.clock_start);

  std::optional<exec::gdb::Server> debugger;
  if (request.gdb_port > 0) {
    debugger.emplace(static_cast<std::uint16_t>(request.gdb_port), interrupted);
    executor->debug_with(*debugger);
  }

  run::Setup setup;
  setup.map = &map;
  run::AgentSetup& agent = setup.agents.emplace_back();
  agent.robot = &robot;
  agent.executor = executor.get();
  if (!request.start.empty()) agent.start = grid::parse_start(map, request.start);
  if (!request.goal.empty()) agent.goal = judge::parse_goal(request.goal);
  agent.scenario = scenario::parse_scenario(request.script, request.script_file);
  setup.limit = request.limit;
  setup.seed = request.seed;
  setup.profile = request.profile;
  setup.samples_every = request.samples_every;
  setup.interrupted = &interrupted;
  setup.reached = &reached;
  if (!debugger) start_watchdog();  // nor is a chip ever caught inside a tick

  if (request.source) executor->trace_bytes(request.source->first, request.source->second);
  Narrator narrator(id, request, *robot.board, *executor);
  agent.listener = &narrator;
  RemoteController controller(id, request.script_file, interrupted,
                              [&](SimTime t) { narrator.flush_serial(t); });
  if (request.interactive) setup.controller = &controller;
  const judge::Outcome outcome = run::simulate(setup).front();
  narrator.flush_serial(outcome.time);
  if (!request.counters.empty()) write_file(request.counters, pack(executor->counters()));
  if (debugger) debugger->ended(static_cast<int>(judge::exit_status(outcome.verdict)));
  answer["result"] = result_of(outcome, request, robot);
}

// In the fork. The process ends here, without the parent's exit handlers.
[[noreturn]] void run_in_child(const Target& target, const nlohmann::json& json, const nlohmann::json& id) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  ::sigaction(SIGINT, &action, nullptr);
  try {
    Json answer = with_id(id);
    run_request(target, parse_run_request(json), id, answer);
    write_line(answer);
  } catch (const InputError& error) {
    answer_error(id, "input", error.what());
  } catch (const ToolMissing& error) {
    answer_error(id, "tool", error.what());
  } catch (const std::exception& error) {
    answer_error(id, "internal", error.what());
  }
  ::_exit(0);
}

std::string cause_of_death(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("it took its process down by signal {} ({})", WTERMSIG(status),
                       ::strsignal(WTERMSIG(status)));
  if (WEXITSTATUS(status) == kWatchdogStatus) return "it loops without end inside a library function";
  return fmt::format("it took its process down with exit status {}", WEXITSTATUS(status));
}

// Firmware ended its process in a way that no handler could catch.
void report_death(const nlohmann::json& json, const nlohmann::json& id, int status) {
  judge::Outcome outcome;
  outcome.verdict = judge::Verdict::crashed;
  outcome.crash = exec::Crash{cause_of_death(status), {}};
  outcome.why = "The sketch crashed: " + outcome.crash->reason + ".";
  const RunRequest request = parse_run_request(json);
  if (!request.goal.empty()) outcome.goal = judge::parse_goal(request.goal);
  Json answer = with_id(id);
  answer["result"] = result_of(outcome, request, robot::load_description(request.robot));
  write_line(answer);
}

void serve_run(const Target& target, const nlohmann::json& json, const nlohmann::json& id) {
  known_sha256(parse_run_request(json).image);
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error(std::string("cannot fork: ") + std::strerror(errno));
  if (child == 0) run_in_child(target, json, id);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) report_death(json, id, status);
}

void serve_line(const Target& target, const std::string& line) {
  nlohmann::json id = nullptr;
  try {
    const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
    if (!json.is_object()) throw InputError("a request must be one JSON object a line");
    id = json.value("id", nlohmann::json());
    if (!id.is_number()) throw InputError("a request needs a number as its \"id\"");
    const nlohmann::json& what = json.value("do", nlohmann::json());
    if (what == "run") {
      serve_run(target, json, id);
    } else if (what == "describe_robot") {
      const nlohmann::json name = json.value("robot", nlohmann::json());
      if (!name.is_string()) throw InputError("describe_robot needs the key \"robot\", a name or a path");
      Json answer = with_id(id);
      answer["robot"] = to_json(robot::describe(robot::load_description(name.get<std::string>())));
      write_line(answer);
    } else {
      throw InputError(
          fmt::format("unknown request {}; known are \"run\" and \"describe_robot\"", what.dump()));
    }
  } catch (const InputError& error) {
    answer_error(id, "input", error.what());
  } catch (const std::exception& error) {
    answer_error(id, "internal", error.what());
  }
}

}  // namespace

int serve(const Target& target) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // no runner outlives its client
  std::signal(SIGINT, SIG_IGN);        // meant for the run, not for its server
  std::signal(SIGPIPE, SIG_IGN);       // a client that has gone is noticed when writing
  Json hello;
  hello["hello"] = "robosim-" + target.name;
  hello["protocol"] = kProtocol;
  hello["version"] = ROBOSIM_VERSION;
  hello["target"] = target.name;
  write_line(hello);
  while (const auto line = read_line())
    if (!line->empty()) serve_line(target, *line);
  return static_cast<int>(ExitStatus::ok);
}

}  // namespace robosim::runner
