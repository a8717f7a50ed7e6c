#include "sim/campaign/wiring/candidate_trial.h"

#include "sim/base/file.h"
#include "sim/base/robot_name.h"
#include "sim/build/source.h"
#include "sim/launch/client/interrupts.h"

namespace robosim::wiring {
namespace {

constexpr int kMostDrafts = 5;
constexpr double kLook_s = 5.0;
constexpr double kDrive_s = 60.0;
constexpr const char* kGoal = "laps:1";

std::int64_t to_ns(double seconds) { return static_cast<std::int64_t>(seconds * 1e9); }

double on_line_s(const result::RunResult& result) { return result.time_s - result.metrics.off_line_s; }

// Returns whether result `a` is clearly better: the robot moves, or stays on the line much longer. A small
// difference is chance.
bool is_much_better(const result::RunResult& a, const result::RunResult& b) {
  constexpr double kMuch = 1.5, kMoved_m = 0.05;
  const bool a_moved = a.metrics.distance_m > kMoved_m, b_moved = b.metrics.distance_m > kMoved_m;
  if (a_moved != b_moved) return a_moved;
  return on_line_s(a) > kMuch * on_line_s(b);
}

}  // namespace

bool follows_a_lap(const result::RunResult& result, bool sensors_beside) {
  constexpr double kBeside_mm = 50.0, kMostOff = 0.5;
  return result.verdict == "reached" && result.metrics.cross_track_rms_mm < kBeside_mm &&
         (sensors_beside || result.metrics.off_line_s < kMostOff * result.time_s);
}

CandidateTrial::CandidateTrial(launch::Launch launch, const BoardSpec& board,
                               const std::filesystem::path& folder, launch::Listener listener)
    : launch_(std::move(launch)),
      board_(board),
      file_(folder / "robot.toml"),
      launcher_(std::move(listener)),
      runner_(launch_.target),
      history_(board) {
  const launch::SketchChoice sketch = launch::choose_sketch(launch_.sketch, launch_.environment);
  const build::ProjectRules rules = request_of(sketch, board, launch_.target, {}).rules;
  names_ = read_names(build::read_sketch(sketch.path, rules), board);
  launch_.robot = robot_with_board(file_.string(), board.name);
}

result::RunResult CandidateTrial::run(const RobotDraft& draft, double for_s, const std::string& goal,
                                      PinHistory* history) {
  write_file(file_, wiring::text_of(draft));
  launch_.request.script = presses(draft);
  launch_.request.goal = goal;
  launch_.request.for_ns = to_ns(for_s);
  launch_.request.pins = launch_.request.io = history != nullptr;
  const launch::Prepared run = launcher_.prepare(
      launch_, launch::choose(launch_), [&](const std::string& name) { return runner_.describe_robot(name); },
      runner_.hello());
  const client::Interrupts interrupts(runner_);
  if (!history) return runner_.run(run.request);
  history->begin();
  result::RunResult result = runner_.run(run.request, [&](const wire::Event& event) { history->add(event); });
  history->end(to_ns(result.time_s));
  return result;
}

RobotDraft CandidateTrial::guess(const Ways& ways) {
  RobotDraft draft = wiring::guess(board_, names_, history_, ways);
  for (;;) {
    write_file(file_, wiring::text_of(draft));
    try {
      runner_.describe_robot(launch_.robot);
      return draft;
    } catch (const InputError& error) {
      if (error.place().file != file_.string() || !remove_refused(draft, error.place().line, error.message()))
        throw;
    }
  }
}

RobotDraft CandidateTrial::draft() {
  RobotDraft draft;
  draft.base = "uno3";
  draft.board = board_.name;
  std::string text = wiring::text_of(draft);
  for (int i = 0; i < kMostDrafts; ++i) {
    run(draft, kLook_s, "none", &history_);
    draft = guess({});
    const std::string next = wiring::text_of(draft);
    if (next == text) break;
    text = next;
  }
  return draft;
}

result::RunResult CandidateTrial::choose(RobotDraft& draft) {
  const Open open = draft.open;
  result::RunResult best = run(draft, kDrive_s, kGoal, nullptr);
  follows_ = follows_a_lap(best, open.distance);
  tried_ = 1;
  for (int bits = 1; bits < 16 && !follows_; ++bits) {
    const Ways ways{(bits & 1) != 0, (bits & 4) != 0, (bits & 8) != 0, (bits & 2) != 0};
    if ((ways.black_low && !open.black) || (ways.other_order && !open.order) ||
        (ways.other_sides && !open.sides) || (ways.close && !open.distance))
      continue;
    const RobotDraft other = guess(ways);
    result::RunResult result = run(other, kDrive_s, kGoal, nullptr);
    ++tried_;
    follows_ = follows_a_lap(result, open.distance && !ways.close);
    if (!follows_ && !is_much_better(result, best)) continue;
    best = std::move(result);
    draft = other;
  }
  return best;
}

}  // namespace robosim::wiring
