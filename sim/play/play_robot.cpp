#include "sim/play/play_robot.h"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <optional>

#include "hal/board/board_spec.h"
#include "sim/base/error.h"
#include "sim/build/sketch.h"
#include "sim/client/interrupts.h"
#include "sim/client/runner.h"
#include "sim/tui/live_view.h"

namespace robosim::play {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kLongest_ns = 3'600'000 * kMs;
constexpr std::int64_t kPressed_ns = 1000 * kMs;  // the button
constexpr std::int64_t kThinking_ns = 100 * kMs;  // simulated, between the question and the answer

/// What drives a robot as an algorithm does.
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

/// Where AiNavigator waits for the user: after "destination?" and "refused" for a destination, after "Put me
/// on a line" for a scan.
bool waits(const std::string& line) {
  return begins(line, "destination?") || begins(line, "refused") || begins(line, "Put me on");
}

std::int64_t time_of(const wire::Event& event) {
  if (const auto* sample = std::get_if<wire::Sample>(&event)) return sample->t_us * 1000;
  if (const auto* serial = std::get_if<wire::SerialText>(&event)) return serial->t_ns;
  if (const auto* note = std::get_if<wire::Note>(&event)) return note->t_ns;
  return 0;
}

class Drive {
 public:
  Drive(const grid::Map& map, const grid::Start& start, const Act& act, tui::Console& console)
      : map_(map), act_(act), console_(console), runner_("host"), robot_(runner_.describe_robot(act.robot)) {
    const BoardSpec* board = find_board(robot_.board.name.c_str());
    if (!board)
      throw wire::RunnerError("the runner named a board that this program lacks: " + robot_.board.name);
    request_.image = build::build({build::find_sketch(act.sketch), *board}).image.string();
    request_.map = map.file;
    request_.robot = act.robot;
    request_.start = fmt::format("{},{},{}", start.cell.x, start.cell.y, grid::letter(start.facing));
    request_.serial = true;
    request_.notes = console.is_live();
    request_.samples_every_ns = console.is_live() ? tui::kViewEvery_ns : 0;
  }

  std::string tour() {
    request_.goal = "tour";
    run(false);
    return sentence();
  }

  std::string navigate(const AskPerson& ask) {
    request_.goal = "none";
    request_.for_ns = kLongest_ns;
    request_.script = "at 1s press start 100ms\n";
    std::vector<std::string> told;
    for (;;) {
      run(true);
      told.insert(told.end(), said_.begin(), said_.end());
      if (!waiting_) return sentence();
      if (begins(said_.back(), "Put me on")) {
        told.pop_back();
        return fmt::format("The robot gave up: {}", told.empty() ? "" : told.back());
      }
      const std::string answer = ask_destination(ask, told);
      if (answer.empty())
        return fmt::format("The robot has done its drives. Time: {:.2f} s.",
                           static_cast<double>(until_) * 1e-9);
      told.push_back("> " + answer);
      request_.script += fmt::format("at {}ms send \"{}\\n\"\n", (until_ + kThinking_ns) / kMs, answer);
    }
  }

 private:
  /// Runs on from until_, to the end or until the sketch waits for the user.
  void run(bool may_wait) {
    const std::int64_t from = until_;
    said_.clear();
    waiting_ = false;
    int signal = 0;
    console_.lend([&] {
      const client::Interrupts interrupts(runner_);
      std::optional<tui::LiveScene> scene;
      std::optional<tui::LiveView> live;
      if (console_.is_live()) {
        runner_.keep_close();
        scene.emplace(fmt::format("{} · {} on {}", act_.sketch, act_.robot, map_.name), map_, robot_);
      }
      result_ = runner_.run(request_, [&](const wire::Event& event) {
        const bool is_new = time_of(event) > from || from == 0;
        if (scene && !is_new) scene->add(event);  // seen before
        if (scene && is_new && !waiting_) {
          if (!live)
            live.emplace(*scene, tui::LiveView::Options{1.0, console_.look(),
                                                        [] { return client::Interrupts::count() > 0; },
                                                        [&] { quit_ = true, runner_.interrupt(); }});
          live->on_event(event);
        }
        const auto* serial = std::get_if<wire::SerialText>(&event);
        if (!serial || !is_new || waiting_) return;
        hear(*serial);
        if (!may_wait || serial->t_ns <= kPressed_ns || !waits(said_.back())) return;
        waiting_ = true;
        until_ = serial->t_ns;
        runner_.interrupt();
      });
      if (live && !waiting_ && !quit_) live->finish(result_);
      signal = client::Interrupts::signal();
    });
    if (signal == 0) return;
    ::raise(signal);  // for whoever noted signals before
    throw SessionQuit{true};
  }

  void hear(const wire::SerialText& serial) {
    std::string line = serial.text;
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
      told.push_back("That cannot be sent: letters, digits, blanks, - and _ can, at most 15 of them.");
    }
  }

  std::string sentence() const {
    return fmt::format("{}: {} Time: {:.2f} s, {:.2f} m.", result_.verdict, result_.why, result_.time_s,
                       result_.metrics.distance_m);
  }

  const grid::Map& map_;
  Act act_;
  tui::Console& console_;
  client::Runner runner_;
  wire::RobotInfo robot_;
  wire::RunRequest request_;
  wire::RunResult result_;
  std::vector<std::string> said_;  // by the sketch, in this run, after what had been heard before
  bool waiting_ = false;
  bool quit_ = false;       // by q in the view
  std::int64_t until_ = 0;  // when the sketch last waited
};

}  // namespace

std::string play_robot(const grid::Map& map, const grid::Start& start, Algorithm algorithm,
                       tui::Console& console, const AskPerson& ask) {
  Drive drive(map, start, act_of(algorithm), console);
  return algorithm == Algorithm::ai ? drive.navigate(ask) : drive.tour();
}

}  // namespace robosim::play
