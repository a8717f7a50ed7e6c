#include "sim/campaign/wiring/candidate_trial.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "sim/base/file.h"
#include "sim/base/robot_name.h"
#include "sim/build/source.h"
#include "sim/launch/client/interrupts.h"

namespace robosim::wiring {
namespace {

constexpr int kMostDrafts = 5;
constexpr std::size_t kMostTrials = 64;
constexpr std::int64_t kSampleEvery_ns = 50'000'000;
constexpr double kLook_s = 10.0;
constexpr double kDrive_s = 60.0;
constexpr double kSquare_mm = 50.0;  // side of a square of FollowedLine
constexpr const char* kGoal = "laps:1";

std::int64_t to_ns(double seconds) { return static_cast<std::int64_t>(seconds * 1e9); }

// Returns whether trial `a` is clearly better. A small difference is chance.
bool is_much_better(const Trial& a, const Trial& b) {
  constexpr double kMuch = 1.5, kSome_m = 1.0;
  if (a.follows != b.follows) return a.follows;
  if (a.follows) return kMuch * a.result.metrics.cross_track_rms_mm < b.result.metrics.cross_track_rms_mm;
  return a.followed_m > kMuch * b.followed_m && a.followed_m > b.followed_m + kSome_m;
}

// Returns whether `ways` differs from `follower` in exactly one of the three properties below, and in nothing
// else. The robot of `follower` follows the line, but may do so although one of these properties is wrong.
bool may_be_better(const Ways& ways, const Ways& follower) {
  int differences = 0;
  for (const bool Ways::*is : {&Ways::black_low, &Ways::other_order, &Ways::other_sides})
    differences += ways.*is != follower.*is;
  Ways rest = ways;
  for (bool Ways::*is : {&Ways::black_low, &Ways::other_order, &Ways::other_sides}) rest.*is = follower.*is;
  return differences == 1 && rest == follower;
}

}  // namespace

GuessedBoard board_for(const launch::SketchChoice& sketch) {
  const build::ProjectRules rules = request_of(sketch, *board_at(0), "host", {}).rules;
  return board_for(build::read_sketch(sketch.path, rules));
}

bool follows_a_lap(const result::RunResult& result, bool sensors_beside) {
  constexpr double kBeside_mm = 50.0, kMostOff = 0.5;
  return result.verdict == "reached" && result.metrics.cross_track_rms_mm < kBeside_mm &&
         (sensors_beside || result.metrics.off_line_s < kMostOff * result.time_s);
}

std::vector<Ways> combinations(const Ways& open) {
  std::vector<Way> ways;
  for (const Way& way : kWays)
    if (open.*way.is) ways.push_back(way);
  std::vector<unsigned> sets;
  for (unsigned set = 1; set < 1u << ways.size(); ++set) sets.push_back(set);
  std::stable_sort(sets.begin(), sets.end(),
                   [](unsigned a, unsigned b) { return std::popcount(a) < std::popcount(b); });
  std::vector<Ways> all;
  for (const unsigned set : sets) {
    Ways& one = all.emplace_back();
    for (std::size_t i = 0; i < ways.size(); ++i) one.*ways[i].is = (set >> i & 1u) != 0;
  }
  return all;
}

void FollowedLine::add(const wire::Sample& sample) {
  constexpr double kNear_mm = 30.0;
  if (std::abs(sample.cross_track_mm) > kNear_mm) return;
  squares_.emplace(static_cast<int>(std::floor(sample.x_mm / kSquare_mm)),
                   static_cast<int>(std::floor(sample.y_mm / kSquare_mm)));
}

double FollowedLine::length() const { return 1e-3 * kSquare_mm * static_cast<double>(squares_.size()); }

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
                                      const std::function<void(const wire::Event&)>& on_event) {
  write_file(file_, wiring::text_of(draft));
  launch_.request.script = presses(draft) + key_;
  launch_.request.goal = goal;
  launch_.request.for_ns = to_ns(for_s);
  const launch::Prepared run = launcher_.prepare(
      launch_, launch::choose(launch_), [&](const std::string& name) { return runner_.describe_robot(name); },
      runner_.hello());
  const client::Interrupts interrupts(runner_);
  result::RunResult result = runner_.run(run.request, on_event);
  if (client::Interrupts::signal() != 0) throw std::runtime_error("interrupted");
  return result;
}

Trial CandidateTrial::attempt(const RobotDraft& draft, const Ways& ways) {
  launch_.request.samples_every_ns = kSampleEvery_ns;
  FollowedLine line;
  Trial trial{ways, 0.0, false, run(draft, kDrive_s, kGoal, [&](const wire::Event& event) {
                if (const auto* sample = std::get_if<wire::Sample>(&event)) line.add(*sample);
              })};
  trial.followed_m = line.length();
  trial.follows = follows_a_lap(trial.result, draft.open.close && !ways.close);
  return trial;
}

RobotDraft CandidateTrial::guess(const Ways& ways) {
  RobotDraft draft = wiring::guess(board_, names_, history_, ways);
  if (!key_.empty())
    draft.notes.push_back("The sketch reads its sensors only after this line of a script: " +
                          key_.substr(0, key_.size() - 1));
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

void CandidateTrial::choose_key(const RobotDraft& draft) {
  constexpr double kLookForKey_s = 6.0, kMuch = 1.5;
  constexpr double kSome = 20.0;  // number of reads
  const std::string& object = names_.serial_object;
  if (object.empty() || object.find("Serial") == std::string::npos) return;
  const auto count = [&](const std::string& key) {
    double reads = 0.0;
    key_ = key;
    history_.begin();
    const result::RunResult result = run(draft, kLookForKey_s, "none", [&](const wire::Event& event) {
      history_.add(event);
      if (std::holds_alternative<wire::LevelSeen>(event) || std::holds_alternative<wire::VoltsSeen>(event))
        ++reads;
    });
    history_.end(to_ns(result.time_s));
    return reads;
  };
  double most = names_.serial_keys.empty() ? 0.0 : kMuch * count("") + kSome;
  std::string best;
  for (const char key : names_.serial_keys) {
    const std::string line = std::string("at 300ms send \"") + key + "\"\n";
    const double reads = count(line);
    if (reads <= most) continue;
    most = reads;
    best = line;
  }
  key_ = best;
}

RobotDraft CandidateTrial::draft() {
  RobotDraft draft;
  draft.base = "uno3";
  draft.board = board_.name;
  std::string text = wiring::text_of(draft);
  launch_.request.pins = launch_.request.io = true;
  choose_key(draft);
  for (int i = 0; i < kMostDrafts; ++i) {
    history_.begin();
    const result::RunResult result =
        run(draft, kLook_s, "none", [&](const wire::Event& event) { history_.add(event); });
    history_.end(to_ns(result.time_s));
    draft = guess({});
    const std::string next = wiring::text_of(draft);
    if (next == text) break;
    text = next;
  }
  launch_.request.pins = launch_.request.io = false;
  return draft;
}

std::vector<Trial> CandidateTrial::choose(RobotDraft& draft) {
  std::vector<Trial> trials = {attempt(draft, {})};
  std::size_t best = 0;
  for (const Ways& ways : combinations(draft.open)) {
    if (trials.size() == kMostTrials) break;
    if (trials[best].follows && !may_be_better(ways, trials[best].ways)) continue;
    const RobotDraft other = guess(ways);
    trials.push_back(attempt(other, ways));
    if (!is_much_better(trials.back(), trials[best])) continue;
    best = trials.size() - 1;
    draft = other;
  }
  return trials;
}

}  // namespace robosim::wiring
