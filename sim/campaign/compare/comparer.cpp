#include "sim/campaign/compare/comparer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <optional>
#include <utility>

#include "sim/base/error.h"
#include "sim/campaign/compare/difference.h"
#include "sim/campaign/compare/jitter_probe.h"
#include "sim/campaign/compare/observer.h"
#include "sim/campaign/compare/target_runs.h"
#include "sim/campaign/rerun/sanitizer_rerun.h"
#include "sim/launch/names.h"
#include "sim/wire/agent_of.h"

namespace robosim::campaign {
namespace {

constexpr std::int64_t kBefore_ns = 500'000'000, kBehind_ns = 100'000'000;  // period around a difference
constexpr std::int64_t kLongestPart_ns = 1'000'000'000;
constexpr std::size_t kMostTicks = 10;  // maximum number of clock ticks at which the host is delayed
constexpr std::size_t kSaid = 3;        // number of lines that are shown before the differing line

}  // namespace

class Comparer::Work {
 public:
  Work(const CompareOptions& options, Progress& progress, const launch::Listener& listener)
      : options_(options), progress_(progress), target_runs_(target_runs_of(options, listener)) {}

  Compared compare(std::uint64_t seed) {
    progress_.say(fmt::format("{} targets, seed {} …", target_runs_.size(), seed));
    Compared compared;
    compared.seed = seed;
    compared.moves = options_.moves;
    compared.sketch = title();
    const std::vector<Histories> histories = run_lanes(seed, compared);
    std::vector<Found> found = compare_with(0, histories, compared);
    // If the first target lacks a feature, its differences reveal nothing about the other targets. Therefore
    // also compares the second target with the later targets.
    if (lacks_something(compared.target_runs[0]))
      for (Found& one : compare_with(1, histories, compared)) found.push_back(std::move(one));
    // Finds the earliest difference that is neither chance nor due to a missing feature.
    std::optional<Compared> on_edge;
    std::deque<analysis::History> more;
    while (!found.empty()) {
      const auto earliest = std::min_element(found.begin(), found.end(), [](const Found& a, const Found& b) {
        return a.difference.first_ns() < b.difference.first_ns();
      });
      Found one = std::move(*earliest);
      found.erase(earliest);
      compared.difference = std::move(one.difference);
      compared.robot = target_runs_[0].name(one.pair.robot);
      look_closer(compared, one.pair);
      find_lacks(compared, one.pair.robot, one.target_runs);
      compared.edges.clear();
      if (compared.lacks.empty()) {
        compared.edges = edges_.find(compared, one.pair);
        if (compared.edges.empty()) break;
      }
      if (!on_edge) on_edge = compared;
      if (auto next = behind_tick(compared, one, more)) found.push_back(std::move(*next));
    }
    if (compared.same() && on_edge) compared = std::move(*on_edge);
    progress_.clear();
    return compared;
  }

 private:
  /// Returns the name of the sketch, the file of several robots, or the number of robots.
  std::string title() const {
    const launch::Fleet& fleet = target_runs_[0].fleet;
    if (fleet.members.empty()) return launch::title_of(target_runs_[0].run.members[0].sketch);
    return fleet.file.empty() ? fmt::format("{} robots", fleet.members.size()) : fleet.file;
  }

  /// The histories of a target run, one for each robot.
  using Histories = std::vector<analysis::History>;

  struct Found {
    analysis::Difference difference;
    std::array<std::size_t, 2> target_runs;
    Pair pair;
  };

  /// Compares target run `first` with each later one.
  std::vector<Found> compare_with(std::size_t first, const std::vector<Histories>& histories,
                                  Compared& compared) {
    std::vector<Found> found;
    for (std::size_t i = first + 1; i < target_runs_.size(); ++i) {
      for (std::size_t robot = 0; robot < observer_.robots(); ++robot) {
        const std::string& name = target_runs_[0].name(robot);
        analysis::Comparison comparison = analysis::compare(histories[first][robot], histories[i][robot]);
        for (analysis::KnownDifference& known : comparison.known)
          compared.known.push_back(
              {std::move(known), name, {target_runs_[first].target, target_runs_[i].target}});
        if (comparison.first)
          found.push_back({std::move(*comparison.first),
                           {first, i},
                           {robot,
                            {&target_runs_[first], &target_runs_[i]},
                            {&histories[first][robot], &histories[i][robot]},
                            {}}});
      }
    }
    return found;
  }

  /// Looks past a difference that a tick of the host's clock decides: delays the sketch on the host, so that
  /// it behaves like the other target. Returns the next difference, or nothing. Stores the host's history in
  /// `more`.
  std::optional<Found> behind_tick(const Compared& compared, const Found& at,
                                   std::deque<analysis::History>& more) {
    if (compared.edges.empty()) return std::nullopt;
    for (std::size_t side = 0; side < 2; ++side) {
      const std::vector<result::Lateness>& late = compared.edges[0].late[1 - side];
      if (!at.pair.target_runs[side]->is_on_host(at.pair.robot) || late.empty() || more.size() == kMostTicks)
        continue;
      Found next = at;
      next.pair.late[side] = late;
      const TargetRun& target_run = *at.pair.target_runs[side];
      more.push_back(observer_.run(*at.pair.target_runs[side],
                                   {at.pair.robot, compared.seed, target_run.run.request.for_ns, late}));
      next.pair.histories[side] = &more.back();
      auto difference = analysis::compare(*next.pair.histories[0], *next.pair.histories[1]).first;
      if (!difference) continue;
      next.difference = std::move(*difference);
      return next;
    }
    return std::nullopt;
  }

  std::vector<Histories> run_lanes(std::uint64_t seed, Compared& compared) {
    std::vector<std::vector<analysis::HistoryRecorder>> recorders(target_runs_.size());
    std::vector<wire::RunRequest> requests;
    std::vector<wire::OnEvent> listeners;
    std::vector<TargetRun*> target_runs;
    for (std::size_t i = 0; i < target_runs_.size(); ++i) {
      for (std::size_t robot = 0; robot < observer_.robots(); ++robot)
        recorders[i].push_back(observer_.recorder_of(target_runs_[i], robot));
      requests.push_back(Observer::request_of(target_runs_[i], seed));
      listeners.emplace_back([&of_lane = recorders[i]](const wire::Event& event) {
        of_lane.at(static_cast<std::size_t>(wire::agent_of(event))).add(event);
      });
      target_runs.push_back(&target_runs_[i]);
    }
    const std::vector<Results> results = run_all(target_runs, requests, listeners);
    std::vector<Histories> histories(target_runs_.size());
    for (std::size_t i = 0; i < target_runs_.size(); ++i) {
      ComparedTarget& target_run =
          compared.target_runs.emplace_back(ComparedTarget{target_runs_[i].target, {}});
      for (std::size_t robot = 0; robot < observer_.robots(); ++robot) {
        histories[i].push_back(recorders[i][robot].finish(results[i][robot]));
        target_run.robots.push_back(
            {target_runs_[i].name(robot), target_runs_[i].inputs(robot), results[i][robot]});
      }
    }
    return histories;
  }

  /// Repeats both runs up to the difference, and records the source lines of all events near it.
  void look_closer(Compared& compared, const Pair& pair) {
    const analysis::Difference& d = *compared.difference;
    std::vector<analysis::PinLog> pins;
    std::vector<wire::RunRequest> requests;
    std::vector<wire::OnEvent> listeners;
    std::vector<TargetRun*> both;
    pins.reserve(2);
    for (std::size_t side = 0; side < 2; ++side) {
      TargetRun& target_run = *pair.target_runs[side];
      pins.emplace_back(d.t_ns[side]);
      wire::RunRequest request = target_run.run.request;
      request.seed = compared.seed;
      TargetRun::late(request, pair.robot) = pair.late[side];
      const std::int64_t end = d.t_ns[side] + kBehind_ns;
      request.for_ns = std::min(request.for_ns, (end / 1'000'000 + 1) * 1'000'000);
      request.pins = request.io = true;
      request.source_ns.emplace(std::max<std::int64_t>(0, d.t_ns[side] - kBefore_ns), end);
      requests.push_back(std::move(request));
      listeners.emplace_back([&seen = pins.back(), robot = pair.robot](const wire::Event& event) {
        if (Observer::is_of(event, robot)) seen.add(event);
      });
      both.push_back(&target_run);
    }
    run_all(both, requests, listeners);
    for (std::size_t side = 0; side < 2; ++side)
      compared.sides[side] = describe(compared, side, pair, pins[side]);
  }

  ComparedSide describe(const Compared& compared, std::size_t side, const Pair& pair,
                        const analysis::PinLog& pins) {
    const analysis::Difference& d = *compared.difference;
    const analysis::History& history = *pair.histories[side];
    ComparedSide result;
    result.target = pair.target_runs[side]->target;
    result.t_ns = d.t_ns[side];
    result.text = d.sides[side];
    result.reads = pins.reads();
    result.writes = pins.writes();
    const std::size_t line = d.line[side].value_or(0);
    for (std::size_t i = 0; i < history.lines.size(); ++i) {
      const analysis::TimedText& said = history.lines[i];
      const bool near = d.line[side]
                            ? i + kSaid >= line && i <= line
                            : said.t_ns <= d.t_ns[side] && said.t_ns > d.t_ns[side] - kLongestPart_ns;
      if (near)
        result.said.push_back(fmt::format("{:.4f} s  {}", 1e-9 * static_cast<double>(said.t_ns), said.text));
    }
    const result::RunResult& run = result_of(compared, side, pair);
    if (d.line[side]) {
      const std::string& text = history.lines[line].text;
      result.source = pins.source_of(text, first_difference(compared, side, text));
    } else if (d.kind == analysis::Difference::Kind::verdict && run.crash) {
      result.source = run.crash->where;
    } else if (d.kind == analysis::Difference::Kind::motors || d.kind == analysis::Difference::Kind::speed) {
      if (const auto use = pins.last_write()) result.source = use->source;
    }
    result.finding = look_with_checks(compared, side, pair);
    return result;
  }

  std::optional<result::Finding> look_with_checks(const Compared& compared, std::size_t side,
                                                  const Pair& pair) {
    TargetRun& target_run = *pair.target_runs[side];
    const launch::Prepared& with = target_run.run.members[pair.robot];
    if (with.target == "stm32") return std::nullopt;
    wire::RunRequest request = target_run.run.request;
    request.seed = compared.seed;
    TargetRun::late(request, pair.robot) = pair.late[side];
    request.for_ns = std::min(request.for_ns, compared.difference->t_ns[side] + kLongestPart_ns);
    progress_.say("running it again on " + with.target + ", with checks …");
    return rerun_with_sanitizers(target_run.runner, request, with.wanted, result_of(compared, side, pair),
                                 pair.robot)
        .finding;
  }

  const result::RunResult& result_of(const Compared& compared, std::size_t side, const Pair& pair) const {
    return compared.target_runs[static_cast<std::size_t>(pair.target_runs[side] - target_runs_.data())]
        .robots[pair.robot]
        .result;
  }

  /// Prepares the robots for the host, if the host is not a compared target. Returns null if that fails.
  TargetRun* make_host() {
    try {
      if (!host_) host_ = target_run_of(options_, "host", {});
    } catch (const InputError&) {
    } catch (const ToolMissing&) {
    }
    return host_ ? &*host_ : nullptr;
  }

  const CompareOptions& options_;
  Progress& progress_;
  std::vector<TargetRun> target_runs_;
  std::optional<TargetRun> host_;
  Observer observer_{target_runs_[0].run.request};
  JitterProbe edges_{observer_, progress_, [this] { return make_host(); }};
};

Comparer::Comparer(const CompareOptions& options, Progress& progress, const launch::Listener& listener)
    : work_(std::make_unique<Work>(options, progress, listener)) {}

Comparer::~Comparer() = default;

Compared Comparer::compare(std::uint64_t seed) { return work_->compare(seed); }

}  // namespace robosim::campaign
