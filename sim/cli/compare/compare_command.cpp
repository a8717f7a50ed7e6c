#include "sim/cli/compare/compare_command.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

#include "sim/analysis/edge.h"
#include "sim/base/error.h"
#include "sim/build/sketch.h"
#include "sim/cli/compare/compare_report.h"
#include "sim/cli/launching.h"
#include "sim/cli/output.h"
#include "sim/client/runner.h"
#include "sim/grid/places.h"
#include "sim/launch/launch.h"
#include "sim/tui/progress.h"

namespace robosim::cli {
namespace {

constexpr std::int64_t kBefore_ns = 500'000'000, kBehind_ns = 100'000'000;  // round a difference
// A clock is off from the beginning on, or so long before a difference, and until it shows.
constexpr std::int64_t kClockOff_ns[] = {3'000'000'000, 5'000'000'000, 8'000'000'000, 12'000'000'000};
constexpr std::int64_t kUntilItShows_ns = 5'000'000'000;
constexpr std::int64_t kLongestPart_ns = 1'000'000'000;
// An Uno's resonator (Murata CSTCE16M0V53) may be 0.5 % off, so two Unos differ by as much as this.
constexpr int kClocksOff_ppm[] = {200, -200, 500, -500, 1000, -1000, 2000, -2000, 3000, -3000, 5000, -5000};
// Where both sides differ from themselves, but not in one way: how often do they go each?
constexpr int kMoreClocksOff_ppm[] = {100,  -100,  300,  -300,  700,  -700,  1500, -1500,
                                      2500, -2500, 3500, -3500, 4000, -4000, 4500, -4500};
// Where that is rare, these, and as many slow.
constexpr int kFirstOfMany_ppm = 50, kStepOfMany_ppm = 80, kLastOfMany_ppm = 5000;
// The robot's axle is so far from the square line, and the middle of its sensors from the line with its
// bends.
constexpr double kOff_cells = 0.75, kOff_mm = 50.0;
constexpr std::size_t kSaid = 3;  // lines before the one that differs

/// One target: what it runs, and who runs it.
struct Lane {
  client::Runner runner;
  launch::Prepared run;
};

/// Runs one request on each lane, all at a time.
std::vector<wire::RunResult> run_all(std::vector<Lane*> lanes, const std::vector<wire::RunRequest>& requests,
                                     const std::vector<wire::OnEvent>& listeners) {
  std::vector<std::optional<wire::RunResult>> results(lanes.size());
  for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i]->runner.begin(requests[i]);
  for (;;) {
    std::vector<pollfd> waiting;
    for (std::size_t i = 0; i < lanes.size(); ++i)
      if (!results[i] && !(results[i] = lanes[i]->runner.take(listeners[i])))
        waiting.push_back({lanes[i]->runner.descriptor(), POLLIN, 0});
    if (waiting.empty()) break;
    ::poll(waiting.data(), waiting.size(), -1);
  }
  std::vector<wire::RunResult> all;
  for (auto& result : results) all.push_back(std::move(*result));
  return all;
}

class CompareCommand {
 public:
  CompareCommand(const CompareArguments& arguments, tui::Progress& progress)
      : arguments_(arguments), progress_(progress) {
    launch::Launch launch = launch_of(arguments.each);
    launch.sketch = arguments.sketch;
    launch.map = arguments.map;
    launch.robot = arguments.robot;
    const launch::SketchChoice sketch = launch::choose_sketch(launch.sketch, launch.environment);
    if (!sketch.elf_target.empty())
      throw InputError({sketch.name, 0, 0}, "is a finished image for one target; compare needs the sketch");
    launch::Launcher launcher(listener_of(progress, {true, false}));
    for (const std::string& target : arguments.targets) {
      launch.target = target;
      launch.request.clock_ns = target == "host" ? 0 : arguments.each.request.clock_ns;
      launch::Chosen chosen = choose(launch);
      client::Runner runner(target);
      launch::Prepared run = launcher.prepare(
          launch, std::move(chosen), [&](const std::string& name) { return runner.describe_robot(name); },
          runner.hello());
      lanes_.push_back({std::move(runner), std::move(run)});
    }
    map_.emplace(grid::read_map(lanes_[0].run.request.map));
    const std::string& start = arguments.each.request.start;
    places_.emplace(*map_, start.empty() ? grid::default_start(*map_) : grid::parse_start(*map_, start));
  }

  Compared compare(std::uint64_t seed) {
    progress_.say(fmt::format("{} targets, seed {} …", lanes_.size(), seed));
    Compared compared;
    compared.seed = seed;
    const std::vector<analysis::History> histories = run_lanes(seed, compared);
    std::vector<std::pair<analysis::Difference, std::size_t>> found;
    for (std::size_t i = 1; i < lanes_.size(); ++i) {
      analysis::Comparison comparison = analysis::compare(histories[0], histories[i]);
      for (analysis::KnownDifference& known : comparison.known) {
        compared.known.push_back(std::move(known));
        compared.known_targets.push_back({arguments_.targets[0], arguments_.targets[i]});
      }
      if (comparison.first) found.emplace_back(std::move(*comparison.first), i);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first.first_ns() < b.first.first_ns(); });
    // The earliest, but for those on the edge.
    std::optional<Compared> on_edge;
    for (auto& [difference, other] : found) {
      compared.difference = std::move(difference);
      const std::array<std::size_t, 2> lanes{0, other};
      look_closer(compared, lanes, {&histories[0], &histories[other]});
      find_edges(compared, lanes, {&histories[0], &histories[other]});
      if (compared.edges.empty()) break;
      if (!on_edge) on_edge = compared;
    }
    if (compared.same() && on_edge) compared = std::move(*on_edge);
    progress_.clear();
    return compared;
  }

 private:
  std::string place_of(const wire::Sample& sample) const {
    const Vec2 axle{1e-3 * sample.x_mm, 1e-3 * sample.y_mm};
    const bool off = places_->cells_off(axle) > kOff_cells && sample.cross_track_mm > kOff_mm;
    return off ? analysis::kOffTheLine : places_->at(axle);
  }

  analysis::HistoryRecorder recorder_of(const Lane& lane) const {
    return {lane.run.target, [this](const wire::Sample& sample) { return place_of(sample); }};
  }

  static wire::RunRequest request_of(const Lane& lane, std::uint64_t seed) {
    wire::RunRequest request = lane.run.request;
    request.seed = seed;
    request.samples_every_ns = analysis::HistoryRecorder::kSampleEvery_ns;
    request.serial = request.notes = true;
    return request;
  }

  /// What one target alone does, such as by a race of its interrupts, is its own doing: so one must do what
  /// the other did there, and the other, too, or differ from itself in a like way.
  void find_edges(Compared& compared, const std::array<std::size_t, 2>& lanes,
                  const std::array<const analysis::History*, 2>& histories) {
    compared.edges.clear();
    if (!analysis::is_of_driving(*compared.difference) || compared.sides[0].finding ||
        compared.sides[1].finding)
      return;
    from_start_ = {};
    bool there = false;
    for (std::size_t side = 0; side < 2 && compared.edges.size() == side; ++side) {
      std::optional<Edge> edge = find_edge(compared, side, lanes[side], histories);
      if (!edge) break;
      there |= edge->does_as_other;
      compared.edges.push_back(std::move(*edge));
    }
    if (there && compared.edges.size() == 2) return;
    compared.edges = weigh(compared, lanes, histories);
  }

  /// Where chance has decided from the beginning on, each side differs from itself in many ways. Then both
  /// must go both ways, and about as often, with one clock or another.
  std::vector<Edge> weigh(const Compared& compared, const std::array<std::size_t, 2>& lanes,
                          const std::array<const analysis::History*, 2>& histories) {
    const auto choice = analysis::Choice::of(*compared.difference, *histories[0], *histories[1]);
    if (!choice) return {};
    std::array<analysis::Share, 2> shares{{{1, 1}, {1, 0}}};
    std::array<std::optional<Edge>, 2> examples;
    const auto look = [&](std::size_t side, int ppm, const analysis::History& run) {
      const bool as_first = choice->is_as_first(run);
      ++shares[side].runs;
      shares[side].as_first += as_first ? 1 : 0;
      const bool does = as_first != (side == 0);
      if (examples[side] && (!does || examples[side]->does_as_other)) return;
      if (auto itself = analysis::compare(*histories[side], run).first)
        examples[side] = Edge{lanes_[lanes[side]].run.target, ppm, 0, std::move(*itself), does};
    };
    for (std::size_t side = 0; side < 2; ++side) {
      say_weighing(lanes[side]);
      for (const int ppm : kClocksOff_ppm) look(side, ppm, run_from_start(compared, side, lanes[side], ppm));
      for (const int ppm : kMoreClocksOff_ppm)
        look(side, ppm, run_from_start(compared, side, lanes[side], ppm));
    }
    analysis::Alikeness alikeness = analysis::alikeness(shares[0], shares[1]);
    if (alikeness == analysis::Alikeness::rare) {
      for (std::size_t side = 0; side < 2; ++side) {
        say_weighing(lanes[side]);
        for (int ppm = kFirstOfMany_ppm; ppm < kLastOfMany_ppm; ppm += kStepOfMany_ppm)
          for (const int off : {ppm, -ppm})
            look(side, off,
                 run_with_clock_off(lanes_[lanes[side]], compared.seed, {0, shows_by(compared), off}));
      }
      alikeness = analysis::alikeness(shares[0], shares[1]);
    }
    if (alikeness == analysis::Alikeness::apart || !examples[0] || !examples[1]) return {};
    for (std::size_t side = 0; side < 2; ++side) {
      const analysis::Share& share = shares[side];
      examples[side]->clocks = share.runs;
      examples[side]->as_other = side == 0 ? share.runs - share.as_first : share.as_first;
    }
    return {std::move(*examples[0]), std::move(*examples[1])};
  }

  void say_weighing(std::size_t lane) {
    progress_.say(fmt::format("how often does {} so, with other clocks? …", lanes_[lane].run.target));
  }

  /// A place to which the other has not come it may come to later.
  static std::int64_t shows_by(const Compared& compared) {
    const analysis::Difference& d = *compared.difference;
    const std::int64_t later = std::max(d.t_ns[0], d.t_ns[1]);
    const bool waits = d.place[0].has_value() != d.place[1].has_value();
    const analysis::Tolerance tolerance;
    return later + kUntilItShows_ns +
           (waits ? static_cast<std::int64_t>(tolerance.time * static_cast<double>(later)) : 0);
  }

  const analysis::History& run_from_start(const Compared& compared, std::size_t side, std::size_t lane,
                                          int ppm) {
    auto& runs = from_start_[side];
    if (const auto known = runs.find(ppm); known != runs.end()) return known->second;
    return runs.emplace(ppm, run_with_clock_off(lanes_[lane], compared.seed, {0, shows_by(compared), ppm}))
        .first->second;
  }

  /// Where this lane, with its clock a little off, does as the other lane did; or, if it never does,
  /// differs from itself in a like way.
  std::optional<Edge> find_edge(const Compared& compared, std::size_t side, std::size_t number,
                                const std::array<const analysis::History*, 2>& histories) {
    const Lane& lane = lanes_[number];
    progress_.say(fmt::format("does {} so, too, its clock a little off? …", lane.run.target));
    const std::int64_t until = shows_by(compared);
    std::optional<Edge> found;
    std::vector<std::int64_t> starts{0};
    for (const std::int64_t before : kClockOff_ns)
      if (compared.difference->t_ns[side] > before)
        starts.push_back(compared.difference->t_ns[side] - before);
    for (const std::int64_t from : starts)
      for (const int ppm : kClocksOff_ppm) {
        const analysis::History history =
            from == 0 ? run_from_start(compared, side, number, ppm)
                      : run_with_clock_off(lanes_[number], compared.seed, {from, until, ppm});
        analysis::Comparison itself = analysis::compare(*histories[side], history);
        if (!itself.first || itself.first->first_ns() >= until || !analysis::is_of_driving(*itself.first))
          continue;
        const bool does = analysis::does_as(history, *histories[1 - side], *compared.difference);
        if (!does && (found || !analysis::is_alike(*itself.first, *compared.difference))) continue;
        found = Edge{lane.run.target, ppm, from, std::move(*itself.first), does};
        if (does) return found;
      }
    return found;
  }

  struct ClockOff {
    std::int64_t from_ns;
    std::int64_t until_ns;
    int ppm;
  };

  analysis::History run_with_clock_off(Lane& lane, std::uint64_t seed, const ClockOff& off) {
    wire::RunRequest request = request_of(lane, seed);
    request.script += fmt::format("\nat {}ms fault clock drift {}ppm\n", off.from_ns / 1'000'000, off.ppm);
    request.for_ns = std::min(request.for_ns, off.until_ns / 1'000'000 * 1'000'000);
    analysis::HistoryRecorder recorder = recorder_of(lane);
    const wire::RunResult result =
        lane.runner.run(request, [&](const wire::Event& event) { recorder.add(event); });
    return recorder.finish(result);
  }

  std::vector<analysis::History> run_lanes(std::uint64_t seed, Compared& compared) {
    std::vector<analysis::HistoryRecorder> recorders;
    std::vector<wire::RunRequest> requests;
    std::vector<wire::OnEvent> listeners;
    std::vector<Lane*> lanes;
    recorders.reserve(lanes_.size());
    for (Lane& lane : lanes_) {
      recorders.push_back(recorder_of(lane));
      requests.push_back(request_of(lane, seed));
      listeners.emplace_back(
          [&recorder = recorders.back()](const wire::Event& event) { recorder.add(event); });
      lanes.push_back(&lane);
    }
    const std::vector<wire::RunResult> results = run_all(lanes, requests, listeners);
    std::vector<analysis::History> histories;
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
      histories.push_back(recorders[i].finish(results[i]));
      compared.runs.push_back({inputs_of(lanes_[i].run, lanes_[i].runner.hello().version), results[i]});
    }
    return histories;
  }

  /// Once more, to the difference only, with the sources of all that happens near it.
  void look_closer(Compared& compared, const std::array<std::size_t, 2>& lanes,
                   const std::array<const analysis::History*, 2>& histories) {
    const analysis::Difference& d = *compared.difference;
    std::vector<analysis::PinLog> pins;
    std::vector<wire::RunRequest> requests;
    std::vector<wire::OnEvent> listeners;
    std::vector<Lane*> both;
    pins.reserve(2);
    for (std::size_t side = 0; side < 2; ++side) {
      Lane& lane = lanes_[lanes[side]];
      pins.emplace_back(d.t_ns[side]);
      wire::RunRequest request = lane.run.request;
      request.seed = compared.seed;
      const std::int64_t end = d.t_ns[side] + kBehind_ns;
      request.for_ns = std::min(request.for_ns, (end / 1'000'000 + 1) * 1'000'000);
      request.pins = request.io = true;
      request.source_ns.emplace(std::max<std::int64_t>(0, d.t_ns[side] - kBefore_ns), end);
      requests.push_back(std::move(request));
      listeners.emplace_back([&seen = pins.back()](const wire::Event& event) { seen.add(event); });
      both.push_back(&lane);
    }
    run_all(both, requests, listeners);
    for (std::size_t side = 0; side < 2; ++side)
      compared.sides[side] = describe(compared, side, lanes[side], *histories[side], pins[side]);
  }

  ComparedSide describe(const Compared& compared, std::size_t side, std::size_t lane,
                        const analysis::History& history, const analysis::PinLog& pins) {
    const analysis::Difference& d = *compared.difference;
    ComparedSide result;
    result.target = arguments_.targets[lane];
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
    const wire::RunResult& run = compared.runs[lane].result;
    if (d.line[side]) {
      const std::string& text = history.lines[line].text;
      result.source = pins.source_of(text, first_difference(compared, side, text));
    } else if (d.kind == analysis::Difference::Kind::verdict && run.crash) {
      result.source = run.crash->where;
    } else if (d.kind == analysis::Difference::Kind::motors || d.kind == analysis::Difference::Kind::speed) {
      if (const auto use = pins.last_write()) result.source = use->source;
    }
    result.finding = look_with_checks(compared, side, lane);
    return result;
  }

  /// Where the text of this side begins to differ from that of the other.
  static std::size_t first_difference(const Compared& compared, std::size_t side, const std::string& text) {
    const std::string& own = compared.difference->sides[side];
    const std::string& other = compared.difference->sides[1 - side];
    const std::size_t begin = own.find('"');
    if (begin == own.npos) return 0;
    const auto apart = std::mismatch(own.begin(), own.end(), other.begin(), other.end());
    const auto at = static_cast<std::size_t>(apart.first - own.begin());
    return at > begin ? std::min(at - begin - 1, text.size()) : 0;
  }

  std::optional<Finding> look_with_checks(const Compared& compared, std::size_t side, std::size_t lane) {
    const std::string& target = arguments_.targets[lane];
    if (target == "stm32") return std::nullopt;
    const wire::RunResult& run = compared.runs[lane].result;
    Lane& with = lanes_[lane];
    wire::RunRequest request = with.run.request;
    request.seed = compared.seed;
    request.for_ns = std::min(request.for_ns, compared.difference->t_ns[side] + kLongestPart_ns);
    progress_.say("running it again on " + target + ", with checks …");
    return look_again(with.runner, request, with.run.wanted, run);
  }

  const CompareArguments& arguments_;
  tui::Progress& progress_;
  std::vector<Lane> lanes_;
  std::optional<grid::Map> map_;
  std::optional<grid::Places> places_;
  std::array<std::map<int, analysis::History>, 2> from_start_;  ///< by clock: of both sides of a difference
};

}  // namespace

int compare_command(const CompareArguments& arguments) {
  tui::Progress progress(true);
  CompareCommand command(arguments, progress);
  for (std::uint64_t seed = arguments.first_seed;; ++seed) {
    const Compared compared = command.compare(seed);
    print(arguments.json ? compare_json(compared) : compare_text(compared));
    if (!compared.same()) return static_cast<int>(ExitStatus::failed);
    if (seed == arguments.last_seed) return static_cast<int>(ExitStatus::ok);
  }
}

}  // namespace robosim::cli
