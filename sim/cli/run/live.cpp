#include "sim/cli/run/live.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "sim/base/error.h"
#include "sim/base/wall_clock.h"
#include "sim/cli/output.h"
#include "sim/launch/client/driven_run.h"
#include "sim/launch/client/interrupts.h"
#include "sim/record/recording.h"
#include "sim/view/terminal/pacer.h"
#include "sim/wire/json_writer.h"
#include "sim/wire/protocol.h"

namespace robosim::cli {
namespace {

constexpr std::int64_t kFrame_us = 1'000'000 / 60;
constexpr std::int64_t kTick_ns = 1'000'000;
constexpr std::int64_t kLongestLeg_ns = 1'000'000'000;  // maximum simulated time between checks for requests
constexpr double kFastest = 1000.0;
constexpr std::size_t kLongestRequest = 1 << 17;
constexpr long long kId = 1;  // request number of the only run

/// Reads lines of the standard input, as they arrive.
class Requests {
 public:
  /// Returns the next line. Waits at most `wait_us`; -1 = without limit.
  std::optional<std::string> next(std::int64_t wait_us) {
    for (;;) {
      if (const std::size_t end = unread_.find('\n'); end != std::string::npos) {
        std::string line = unread_.substr(0, end);
        unread_.erase(0, end + 1);
        return line;
      }
      if (ended_ || !wait(wait_us)) return std::nullopt;
      wait_us = 0;
      char some[4096];
      const ssize_t got = ::read(STDIN_FILENO, some, sizeof some);
      ended_ = got <= 0 || unread_.size() > kLongestRequest;
      if (got > 0) unread_.append(some, static_cast<std::size_t>(got));
    }
  }
  bool ended() const { return ended_; }

 private:
  // Returns whether input is available.
  static bool wait(std::int64_t wait_us) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    const timespec time{static_cast<time_t>(wait_us / 1'000'000),
                        static_cast<long>(wait_us % 1'000'000 * 1000)};
    return ::ppoll(&input, 1, wait_us < 0 ? nullptr : &time, nullptr) > 0;
  }

  std::string unread_;
  bool ended_ = false;
};

class Live {
 public:
  Live(client::Runner& runner, const record::RecordedRun& run, const wire::OnEvent& on_event)
      : recorded_(run),
        on_event_(on_event),
        gatherer_(begun(run)),
        run_(runner, run.request, [this](const wire::Event& e) { hear(e); }) {
    tell_state();
  }

  result::RunResult run() {
    while (!run_.over()) {
      flush();
      if (client::Interrupts::count() > 0) run_.end();
      if (const auto line = requests_.next(until_due_us())) {
        serve(*line);
      } else if (requests_.ended()) {
        run_.end();
      } else if (!pacer_.paused()) {
        advance();
      }
    }
    tell(wire::to_line(kId, wire::Answer(run_.result())));
    flush();
    return run_.result();
  }

 private:
  void tell(const std::string& line) { told_ += line; }
  void flush() { print(std::exchange(told_, {})); }
  void tell_state() { tell(wire::to_line(kId, wire::Answer(run_.state()))); }

  void hear(const wire::Event& event) {
    on_event_(event);
    const std::string line = wire::to_line(kId, wire::Answer(event));
    const std::size_t robots = recorded_.request.agents.size() + 1;
    if (started_ == robots) return tell(line);
    begun_ += line;
    if (!std::holds_alternative<wire::Started>(event)) return;
    gatherer_.add(event);
    if (++started_ < robots) return;
    tell_recording();
    tell(begun_);
  }

  void tell_recording() {
    record::RecordingHeader header = gatherer_.header();
    const auto set_result = [this](record::RobotRecord& robot) {
      robot.result.goal = robot.started.goal;
      robot.result.seed = recorded_.request.seed;
      robot.result.profile = recorded_.request.profile;
    };
    set_result(header);
    for (record::RobotRecord& other : header.others) set_result(other);
    tell(wire::text_of(wire::OrderedJson{{"id", kId}, {"recording", wire::to_json(header)}}) + "\n");
  }

  std::int64_t until_due_us() {
    if (pacer_.paused()) return -1;
    return pacer_.wait_us(run_.state().t_ns / 1000, wall_us());
  }

  void advance() {
    const double frame_ns =
        pacer_.speed() > 0.0 ? pacer_.speed() * kFrame_us * 1e3 : static_cast<double>(leg_ns_);
    next_ns_ = std::max(next_ns_, static_cast<double>(run_.state().t_ns)) + frame_ns;
    const std::int64_t began_us = wall_us();
    go_to(static_cast<std::int64_t>(std::ceil(next_ns_ / kTick_ns)) * kTick_ns);
    const std::int64_t took_us = wall_us() - began_us;
    if (took_us > kFrame_us) leg_ns_ = std::max(leg_ns_ / 2, kTick_ns);
    if (took_us < kFrame_us / 2) leg_ns_ = std::min(leg_ns_ * 2, kLongestLeg_ns);
  }

  void go_to(std::int64_t t_ns) {
    if (run_.go_on(t_ns)) tell_state();
  }

  void serve(const std::string& line) {
    const auto asked = wire::parse_live_request(line);
    try {
      if (!asked.request) throw InputError(asked.fault);
      std::visit([this](const auto& request) { carry_out(request); }, *asked.request);
    } catch (const InputError& error) {
      tell(wire::to_line(kId, wire::Answer(wire::Refused{error.what()})));
    }
  }
  void carry_out(const wire::Play& play) {
    if (!(play.speed >= 0.0 && play.speed <= kFastest))
      throw InputError("speed: expected a number from 0 to 1000");
    pacer_.set_speed(play.speed);
    pacer_.set_paused(false);
    next_ns_ = 0.0;
  }
  void carry_out(const wire::Pause&) { pacer_.set_paused(true); }
  void carry_out(const wire::StepOn& step) {
    pacer_.set_paused(true);
    go_to(run_.state().t_ns + step.ms * kTick_ns);
  }
  void carry_out(const wire::Act& act) {
    const auto agent = static_cast<std::size_t>(act.agent);
    if (const std::size_t count = recorded_.request.agents.size() + 1; agent >= count)
      throw InputError(fmt::format("agent: expected a robot from 0 to {}, got {}", count - 1, agent));
    const std::size_t known = run_.script(agent).size();
    run_.act(act.lines, agent);
    tell(wire::to_line(kId, wire::Answer(wire::Accepted{run_.script(agent).substr(known), act.agent})));
  }
  void carry_out(const wire::End&) { run_.end(); }

  const record::RecordedRun& recorded_;
  const wire::OnEvent& on_event_;
  record::Gatherer gatherer_;  // for the initial part of a recording
  std::size_t started_ = 0;    // number of started robots
  // events that arrive before all robots have started; they are reported after the report `recording`
  std::string begun_;
  std::string told_;
  Requests requests_;
  terminal::Pacer pacer_ = paused();
  double next_ns_ = 0.0;  // simulated time at which the next frame ends
  // at maximum speed: simulated time that takes about one frame of wall-clock time
  std::int64_t leg_ns_ = kTick_ns;
  client::DrivenRun run_;  // last, so that its listeners are constructed before it

  static record::Gatherer begun(const record::RecordedRun& run) {
    record::Gatherer gatherer;
    gatherer.begin(run);
    return gatherer;
  }
  static terminal::Pacer paused() {
    terminal::Pacer pacer(1.0);
    pacer.set_paused(true);
    return pacer;
  }
};

}  // namespace

result::RunResult run_live(client::Runner& runner, const record::RecordedRun& run,
                           const wire::OnEvent& on_event) {
  return Live(runner, run, on_event).run();
}

}  // namespace robosim::cli
