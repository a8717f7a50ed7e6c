#include "sim/view/play/play_robot.h"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "sim/base/escaped.h"
#include "sim/launch/client/driven_run.h"
#include "sim/launch/client/interrupts.h"
#include "sim/launch/client/runner.h"
#include "sim/launch/launch.h"
#include "sim/view/terminal/live_view.h"
#include "sim/wire/messages.h"

namespace robosim::play {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kLongest_ns = 3'600'000 * kMs;
constexpr std::int64_t kPressed_ns = 1000 * kMs;  // duration of pressing the button
constexpr std::int64_t kThinking_ns = 100 * kMs;  // simulated time between the question and the answer

/// The sketch of an algorithm, and the robot for the sketch.
struct Act {
  const char* sketch;
  const char* robot;
};

Act act_of(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::left:
      return {"LeftPath", "uno3"};
    case Algorithm::right:
      return {"RightPath", "uno3"};
    case Algorithm::ai:
      break;
  }
  return {"AiNavigator", "uno5"};
}

bool begins(const std::string& text, const char* with) { return text.rfind(with, 0) == 0; }

/// Matches output after which AiNavigator waits for the user. After the first two texts, AiNavigator waits
/// for a destination. After the last text, it waits until the user puts the robot on a line, for a scan.
constexpr const char* kWaits = "^(destination\\?|refused|Put me on)";

class Drive {
 public:
  Drive(const map::Map& map, const map::Start& start, const Act& act, terminal::Console& console)
      : map_(map), act_(act), console_(console), runner_("host") {
    launch_.sketch = act.sketch;
    launch_.map = map.file;
    launch_.robot = act.robot;
    launch_.request.start = fmt::format("{},{},{}", start.cell.x, start.cell.y, map::letter(start.facing));
    launch_.request.serial = true;
    launch_.request.notes = console.is_live();
    launch_.request.samples_every_ns = console.is_live() ? terminal::kViewEvery_ns : 0;
  }

  std::string tour() {
    launch_.request.goal = "tour";
    begin();
    watch([&] { run_->finish(); });
    return sentence();
  }

  std::string navigate(const AskPerson& ask) {
    launch_.request.goal = "none";
    launch_.request.for_ns = kLongest_ns;
    launch_.request.script = "at 1s press start 100ms\n";
    begin();
    watch([&] {
      if (run_->go_on(kPressed_ns)) go_on_until_it_waits();
    });
    std::vector<std::string> told;
    for (;;) {
      told.insert(told.end(), said_.begin(), said_.end());
      if (run_->over()) return sentence();
      if (begins(said_.back(), "Put me on")) {
        told.pop_back();
        return fmt::format("The robot gave up: {}", told.empty() ? "" : told.back());
      }
      const std::string answer = ask_destination(ask, told);
      const std::int64_t now_ns = run_->state().t_ns;
      if (answer.empty())
        return fmt::format("The robot has done its drives. Time: {:.2f} s.",
                           static_cast<double>(now_ns) * 1e-9);
      told.push_back("> " + answer);
      watch([&] {
        if (!run_->go_on(now_ns + kThinking_ns)) return;
        run_->act(fmt::format("send \"{}\"", escaped(answer + "\n")));
        go_on_until_it_waits();
      });
    }
  }

 private:
  void begin() {
    launch::Launcher launcher;
    launch::Prepared prepared = launcher.prepare(
        launch_, choose(launch_), [&](const std::string& name) { return runner_.describe_robot(name); },
        runner_.hello());
    if (console_.is_live()) {
      runner_.keep_close();
      scene_.emplace(fmt::format("{} · {} on {}", act_.sketch, act_.robot, map_.name), map_,
                     prepared.robot_info);
    }
    run_.emplace(runner_, std::move(prepared.request), [&](const wire::Event& event) { take(event); });
  }

  void go_on_until_it_waits() {
    run_->go_on(kLongest_ns, {result::Stop::line(kWaits, run_->state().serial_bytes)});
    if (!run_->over() && run_->state().stop < 0) run_->finish();
  }

  /// Continues the run, in the live view if it exists.
  void watch(const std::function<void()>& go_on) {
    said_.clear();
    int signal = 0;
    console_.lend([&] {
      const client::Interrupts interrupts(runner_);
      bool quit = false;  // the user pressed q
      if (scene_)
        view_.emplace(*scene_, terminal::LiveView::Options{1.0, console_.look(),
                                                           [] { return client::Interrupts::count() > 0; },
                                                           [&] { quit = true, runner_.interrupt(); }});
      go_on();
      if (view_ && run_->over() && !quit) view_->finish(run_->result());
      view_.reset();
      signal = client::Interrupts::signal();
    });
    if (signal == 0) return;
    ::raise(signal);  // so that an outer handler receives it, too
    throw SessionQuit{true};
  }

  void take(const wire::Event& event) {
    if (view_)
      view_->on_event(event);
    else if (scene_)
      scene_->add(event);
    const auto* serial = std::get_if<wire::SerialText>(&event);
    if (!serial) return;
    std::string line = serial->text;
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
    said_.push_back(std::move(line));
  }

  static std::string ask_destination(const AskPerson& ask, std::vector<std::string>& told) {
    constexpr std::size_t kLongest = 15;
    for (;;) {
      const std::string answer = ask(told, "Destination (a number or a name; Enter stops, q quits):");
      const bool is_plain =
          answer.size() <= kLongest && std::all_of(answer.begin(), answer.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
                   c == '_' || c == ' ';
          });
      if (is_plain) return answer;
      told.push_back("That cannot be sent: expected at most 15 letters, digits, blanks, - and _.");
    }
  }

  std::string sentence() const {
    const result::RunResult& result = run_->result();
    return fmt::format("{}: {} Time: {:.2f} s, {:.2f} m.", result.verdict, result.why, result.time_s,
                       result.metrics.distance_m);
  }

  const map::Map& map_;
  Act act_;
  terminal::Console& console_;
  client::Runner runner_;
  launch::Launch launch_;
  std::optional<terminal::LiveScene> scene_;
  std::optional<terminal::LiveView> view_;
  std::optional<client::DrivenRun> run_;
  std::vector<std::string> said_;  // output of the sketch since the last question
};

}  // namespace

std::string play_robot(const map::Map& map, const map::Start& start, Algorithm algorithm,
                       terminal::Console& console, const AskPerson& ask) {
  Drive drive(map, start, act_of(algorithm), console);
  return algorithm == Algorithm::ai ? drive.navigate(ask) : drive.tour();
}

}  // namespace robosim::play
