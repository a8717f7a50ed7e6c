#include "sim/cli/compare/compare_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

#include "sim/analysis/edge.h"
#include "sim/base/error.h"
#include "sim/cli/compare/compare_report.h"
#include "sim/cli/compare/difference.h"
#include "sim/cli/compare/lanes.h"
#include "sim/cli/output.h"
#include "sim/grid/places.h"
#include "sim/tui/progress.h"
#include "sim/wire/agent_of.h"

namespace robosim::cli {
namespace {

constexpr std::int64_t kBefore_ns = 500'000'000, kBehind_ns = 100'000'000;  // round a difference
// A clock is off from the beginning on, or so long before a difference, and until it shows.
constexpr std::int64_t kClockOff_ns[] = {3'000'000'000, 5'000'000'000, 8'000'000'000, 12'000'000'000};
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

class CompareCommand {
 public:
  CompareCommand(const CompareArguments& arguments, tui::Progress& progress)
      : arguments_(arguments), progress_(progress), lanes_(lanes_of(arguments, progress)) {
    const wire::RunRequest& request = lanes_[0].run.request;
    map_.emplace(grid::read_map(request.map));
    add_places(request.start);
    for (const wire::AgentRequest& agent : request.agents) add_places(agent.start);
  }

  Compared compare(std::uint64_t seed) {
    progress_.say(fmt::format("{} targets, seed {} …", lanes_.size(), seed));
    Compared compared;
    compared.seed = seed;
    compared.moves = arguments_.moves;
    compared.sketch = title();
    const std::vector<Histories> histories = run_lanes(seed, compared);
    std::vector<Found> found = compare_with(0, histories, compared);
    // What differs from a target that lacks something says nothing of the others.
    if (lacks_something(compared.lanes[0]))
      for (Found& one : compare_with(1, histories, compared)) found.push_back(std::move(one));
    std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
      return a.difference.first_ns() < b.difference.first_ns();
    });
    // The earliest, but for those that say nothing of the sketch.
    std::optional<Compared> on_edge;
    for (Found& one : found) {
      compared.difference = std::move(one.difference);
      compared.robot = lanes_[0].name(one.robot);
      const auto [a, b] = one.lanes;
      const Pair pair{one.robot, one.lanes, {&histories[a][one.robot], &histories[b][one.robot]}};
      look_closer(compared, pair);
      find_lacks(compared, pair.robot, pair.lanes);
      compared.edges.clear();
      if (compared.lacks.empty()) {
        find_edges(compared, pair);
        if (compared.edges.empty()) break;
      }
      if (!on_edge) on_edge = compared;
    }
    if (compared.same() && on_edge) compared = std::move(*on_edge);
    progress_.clear();
    return compared;
  }

 private:
  /// A sketch, a file of several robots, or how many there are.
  std::string title() const {
    const launch::Fleet& fleet = lanes_[0].fleet;
    if (fleet.members.empty()) return lanes_[0].inputs(0).sketch;
    return fleet.file.empty() ? fmt::format("{} robots", fleet.members.size()) : fleet.file;
  }

  /// Of a lane, one for each robot.
  using Histories = std::vector<analysis::History>;

  struct Found {
    analysis::Difference difference;
    std::array<std::size_t, 2> lanes;
    std::size_t robot;
  };

  /// The lanes behind `first` with that one.
  std::vector<Found> compare_with(std::size_t first, const std::vector<Histories>& histories,
                                  Compared& compared) const {
    std::vector<Found> found;
    for (std::size_t i = first + 1; i < lanes_.size(); ++i) {
      for (std::size_t robot = 0; robot < places_.size(); ++robot) {
        const std::string& name = lanes_[0].name(robot);
        analysis::Comparison comparison = analysis::compare(histories[first][robot], histories[i][robot]);
        for (analysis::KnownDifference& known : comparison.known)
          compared.known.push_back({std::move(known), name, {lanes_[first].target, lanes_[i].target}});
        if (comparison.first) found.push_back({std::move(*comparison.first), {first, i}, robot});
      }
    }
    return found;
  }

  /// One robot in two lanes.
  struct Pair {
    std::size_t robot;
    std::array<std::size_t, 2> lanes;
    std::array<const analysis::History*, 2> histories;
  };

  void add_places(const std::string& start) {
    places_.emplace_back(*map_, start.empty() ? grid::default_start(*map_) : grid::parse_start(*map_, start));
  }

  std::string place_of(std::size_t robot, const wire::Sample& sample) const {
    const Vec2 axle{1e-3 * sample.x_mm, 1e-3 * sample.y_mm};
    const grid::Places& places = places_[robot];
    const bool off = places.cells_off(axle) > kOff_cells && sample.cross_track_mm > kOff_mm;
    return off ? analysis::kOffTheLine : places.at(axle);
  }

  analysis::HistoryRecorder recorder_of(const Lane& lane, std::size_t robot) const {
    return {lane.target, [this, robot](const wire::Sample& sample) { return place_of(robot, sample); }};
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
  void find_edges(Compared& compared, const Pair& pair) {
    compared.edges.clear();
    if (!analysis::is_of_driving(*compared.difference) || compared.sides[0].finding ||
        compared.sides[1].finding)
      return;
    from_start_ = {};
    bool there = false;
    for (std::size_t side = 0; side < 2 && compared.edges.size() == side; ++side) {
      std::optional<Edge> edge = find_edge(compared, side, pair);
      if (!edge) break;
      there |= edge->does_as_other;
      compared.edges.push_back(std::move(*edge));
    }
    if (there && compared.edges.size() == 2) return;
    compared.edges = weigh(compared, pair);
  }

  /// Where chance has decided from the beginning on, each side differs from itself in many ways. Then both
  /// must go both ways, and about as often, with one clock or another.
  std::vector<Edge> weigh(const Compared& compared, const Pair& pair) {
    const auto choice = analysis::Choice::of(*compared.difference, *pair.histories[0], *pair.histories[1]);
    if (!choice) return {};
    std::array<analysis::Share, 2> shares{{{1, 1}, {1, 0}}};
    std::array<std::optional<Edge>, 2> examples;
    const auto look = [&](std::size_t side, int ppm, const analysis::History& run) {
      const bool as_first = choice->is_as_first(run);
      ++shares[side].runs;
      shares[side].as_first += as_first ? 1 : 0;
      const bool does = as_first != (side == 0);
      if (examples[side] && (!does || examples[side]->does_as_other)) return;
      if (auto itself = analysis::compare(*pair.histories[side], run).first)
        examples[side] = Edge{lanes_[pair.lanes[side]].target, ppm, 0, std::move(*itself), does};
    };
    for (std::size_t side = 0; side < 2; ++side) {
      say_weighing(pair.lanes[side]);
      for (const int ppm : kClocksOff_ppm) look(side, ppm, run_from_start(compared, side, pair, ppm));
      for (const int ppm : kMoreClocksOff_ppm) look(side, ppm, run_from_start(compared, side, pair, ppm));
    }
    analysis::Alikeness alikeness = analysis::alikeness(shares[0], shares[1]);
    if (alikeness == analysis::Alikeness::rare) {
      for (std::size_t side = 0; side < 2; ++side) {
        say_weighing(pair.lanes[side]);
        for (int ppm = kFirstOfMany_ppm; ppm < kLastOfMany_ppm; ppm += kStepOfMany_ppm)
          for (const int off : {ppm, -ppm})
            look(side, off, run_with_clock_off(pair, side, compared.seed, {0, shows_by(compared), off}));
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
    progress_.say(fmt::format("how often does {} so, with other clocks? …", lanes_[lane].target));
  }

  const analysis::History& run_from_start(const Compared& compared, std::size_t side, const Pair& pair,
                                          int ppm) {
    auto& runs = from_start_[side];
    if (const auto known = runs.find(ppm); known != runs.end()) return known->second;
    return runs.emplace(ppm, run_with_clock_off(pair, side, compared.seed, {0, shows_by(compared), ppm}))
        .first->second;
  }

  /// Where this lane, with its clock a little off, does as the other lane did; or, if it never does,
  /// differs from itself in a like way.
  std::optional<Edge> find_edge(const Compared& compared, std::size_t side, const Pair& pair) {
    const std::string& target = lanes_[pair.lanes[side]].target;
    progress_.say(fmt::format("does {} so, too, its clock a little off? …", target));
    const std::int64_t until = shows_by(compared);
    std::optional<Edge> found;
    std::vector<std::int64_t> starts{0};
    for (const std::int64_t before : kClockOff_ns)
      if (compared.difference->t_ns[side] > before)
        starts.push_back(compared.difference->t_ns[side] - before);
    for (const std::int64_t from : starts)
      for (const int ppm : kClocksOff_ppm) {
        const analysis::History history =
            from == 0 ? run_from_start(compared, side, pair, ppm)
                      : run_with_clock_off(pair, side, compared.seed, {from, until, ppm});
        analysis::Comparison itself = analysis::compare(*pair.histories[side], history);
        if (!itself.first || itself.first->first_ns() >= until || !analysis::is_of_driving(*itself.first))
          continue;
        const bool does = analysis::does_as(history, *pair.histories[1 - side], *compared.difference);
        if (!does && (found || !analysis::is_alike(*itself.first, *compared.difference))) continue;
        found = Edge{target, ppm, from, std::move(*itself.first), does};
        if (does) return found;
      }
    return found;
  }

  struct ClockOff {
    std::int64_t from_ns;
    std::int64_t until_ns;
    int ppm;
  };

  /// Where there are several, the others' clocks are as far off the other way: who comes first where ways
  /// cross may be chance, too.
  analysis::History run_with_clock_off(const Pair& pair, std::size_t side, std::uint64_t seed,
                                       const ClockOff& off) {
    Lane& lane = lanes_[pair.lanes[side]];
    wire::RunRequest request = request_of(lane, seed);
    for (std::size_t robot = 0; robot < places_.size(); ++robot)
      lane.script(request, robot) +=
          fmt::format("\nat {}ms fault clock drift {}ppm\n", off.from_ns / 1'000'000,
                      robot == pair.robot ? off.ppm : -off.ppm);
    request.for_ns = std::min(request.for_ns, off.until_ns / 1'000'000 * 1'000'000);
    analysis::HistoryRecorder recorder = recorder_of(lane, pair.robot);
    const Results results = launch::results_of(lane.runner.run(request, [&](const wire::Event& event) {
      if (is_of(event, pair.robot)) recorder.add(event);
    }));
    return recorder.finish(results[pair.robot]);
  }

  static bool is_of(const wire::Event& event, std::size_t robot) {
    return static_cast<std::size_t>(wire::agent_of(event)) == robot;
  }

  std::vector<Histories> run_lanes(std::uint64_t seed, Compared& compared) {
    std::vector<std::vector<analysis::HistoryRecorder>> recorders(lanes_.size());
    std::vector<wire::RunRequest> requests;
    std::vector<wire::OnEvent> listeners;
    std::vector<Lane*> lanes;
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
      for (std::size_t robot = 0; robot < places_.size(); ++robot)
        recorders[i].push_back(recorder_of(lanes_[i], robot));
      requests.push_back(request_of(lanes_[i], seed));
      listeners.emplace_back([&of_lane = recorders[i]](const wire::Event& event) {
        of_lane.at(static_cast<std::size_t>(wire::agent_of(event))).add(event);
      });
      lanes.push_back(&lanes_[i]);
    }
    const std::vector<Results> results = run_all(lanes, requests, listeners);
    std::vector<Histories> histories(lanes_.size());
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
      ComparedLane& lane = compared.lanes.emplace_back(ComparedLane{lanes_[i].target, {}});
      for (std::size_t robot = 0; robot < places_.size(); ++robot) {
        histories[i].push_back(recorders[i][robot].finish(results[i][robot]));
        lane.robots.push_back({lanes_[i].name(robot), lanes_[i].inputs(robot), results[i][robot]});
      }
    }
    return histories;
  }

  /// Once more, to the difference only, with the sources of all that happens near it.
  void look_closer(Compared& compared, const Pair& pair) {
    const analysis::Difference& d = *compared.difference;
    std::vector<analysis::PinLog> pins;
    std::vector<wire::RunRequest> requests;
    std::vector<wire::OnEvent> listeners;
    std::vector<Lane*> both;
    pins.reserve(2);
    for (std::size_t side = 0; side < 2; ++side) {
      Lane& lane = lanes_[pair.lanes[side]];
      pins.emplace_back(d.t_ns[side]);
      wire::RunRequest request = lane.run.request;
      request.seed = compared.seed;
      const std::int64_t end = d.t_ns[side] + kBehind_ns;
      request.for_ns = std::min(request.for_ns, (end / 1'000'000 + 1) * 1'000'000);
      request.pins = request.io = true;
      request.source_ns.emplace(std::max<std::int64_t>(0, d.t_ns[side] - kBefore_ns), end);
      requests.push_back(std::move(request));
      listeners.emplace_back([&seen = pins.back(), robot = pair.robot](const wire::Event& event) {
        if (is_of(event, robot)) seen.add(event);
      });
      both.push_back(&lane);
    }
    run_all(both, requests, listeners);
    for (std::size_t side = 0; side < 2; ++side)
      compared.sides[side] = describe(compared, side, pair, pins[side]);
  }

  ComparedSide describe(const Compared& compared, std::size_t side, const Pair& pair,
                        const analysis::PinLog& pins) {
    const analysis::Difference& d = *compared.difference;
    const std::size_t lane = pair.lanes[side];
    const analysis::History& history = *pair.histories[side];
    ComparedSide result;
    result.target = lanes_[lane].target;
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
    const wire::RunResult& run = compared.lanes[lane].robots[pair.robot].result;
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

  std::optional<Finding> look_with_checks(const Compared& compared, std::size_t side, const Pair& pair) {
    Lane& lane = lanes_[pair.lanes[side]];
    const launch::Prepared& with = lane.run.members[pair.robot];
    if (with.target == "stm32") return std::nullopt;
    wire::RunRequest request = lane.run.request;
    request.seed = compared.seed;
    request.for_ns = std::min(request.for_ns, compared.difference->t_ns[side] + kLongestPart_ns);
    progress_.say("running it again on " + with.target + ", with checks …");
    return look_again(lane.runner, request, with.wanted,
                      compared.lanes[pair.lanes[side]].robots[pair.robot].result, pair.robot);
  }

  const CompareArguments& arguments_;
  tui::Progress& progress_;
  std::vector<Lane> lanes_;
  std::optional<grid::Map> map_;
  std::vector<grid::Places> places_;  ///< as each robot meets them, from its start on
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
