#include "sim/campaign/compare/jitter_probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "sim/campaign/compare/difference.h"

namespace robosim::campaign {
namespace {

// A clock error begins one of these times before a difference, or at the start of the run. It ends when the
// difference shows.
constexpr std::int64_t kClockOff_ns[] = {3'000'000'000, 5'000'000'000, 8'000'000'000, 12'000'000'000};
// An Uno's resonator (Murata CSTCE16M0V53) may be 0.5 % off, so two Unos differ by up to twice that.
constexpr int kClocksOff_ppm[] = {200, -200, 500, -500, 1000, -1000, 2000, -2000, 3000, -3000, 5000, -5000};
// More clock errors, used to measure how often each behaviour occurs. They are needed if the runs of one side
// differ from each other in several ways.
constexpr int kMoreClocksOff_ppm[] = {100,  -100,  300,  -300,  700,  -700,  1500, -1500,
                                      2500, -2500, 3500, -3500, 4000, -4000, 4500, -4500};
// If one behaviour is rare, fast clocks with these errors are tried, and slow clocks with the same errors.
constexpr int kFirstOfMany_ppm = 50, kStepOfMany_ppm = 80, kLastOfMany_ppm = 5000;
// Delays of the sketch on the host; negative = sooner. An Uno's millis() may lag by two of its ticks,
// 2.048 ms. Between two calls of delay(), targets differ by some milliseconds. Up to 2.08 ms, the steps are a
// quarter of a tick.
constexpr std::int64_t kLate_us[] = {260,   520,  -260,  780,   -520, 1040,  -780, 1300, -1040, 1560,
                                     -1300, 1820, -1560, -1820, 2080, -2080, 3000, 5000, 10000};
// A delay begins one of these times before the difference, or at the start of the run.
constexpr std::int64_t kLateBefore_ns[] = {100'000'000, 1'500'000'000, 5'000'000'000};

constexpr std::int64_t kSoon_ns = 100'000'000;

}  // namespace

std::vector<Edge> JitterProbe::find(const Compared& compared, const Pair& pair) {
  from_start_.clear();
  if (!compared.difference->cause.empty() || compared.sides[0].finding || compared.sides[1].finding)
    return {};
  if (analysis::is_of_driving(*compared.difference))
    if (std::vector<Edge> edges = find_of_clocks(compared, pair); !edges.empty()) return edges;
  return find_of_ticks(compared, pair);
}

/// Finds, for each side, a clock with which this side behaves like the other side. For one of the two sides,
/// it is enough that a clock changes the behaviour in a way that resembles the difference. A behaviour that
/// only one target shows, such as a race of its interrupts, is not chance.
std::vector<Edge> JitterProbe::find_of_clocks(const Compared& compared, const Pair& pair) {
  std::vector<Edge> edges;
  bool there = false;
  for (std::size_t side = 0; side < 2 && edges.size() == side; ++side) {
    std::optional<Edge> edge = find_of_clock(compared, side, pair);
    if (!edge) break;
    there |= edge->does_as_other;
    edges.push_back(std::move(*edge));
  }
  if (there && edges.size() == 2) return edges;
  return weigh(compared, pair);
}

/// Compares how often each side shows each of the two behaviours with varied clocks. If chance decides
/// between the behaviours, both sides show each of them about equally often.
std::vector<Edge> JitterProbe::weigh(const Compared& compared, const Pair& pair) {
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
      examples[side] = Edge{pair.target_runs[side]->target, ppm, 0, std::move(*itself), does};
  };
  const auto say = [&](std::size_t side) {
    progress_.say(fmt::format("measuring how often {} behaves differently with other clocks …",
                              pair.target_runs[side]->target));
  };
  for (std::size_t side = 0; side < 2; ++side) {
    say(side);
    TargetRun& target_run = *pair.target_runs[side];
    const ObservedRobot observed = observed_robot_of(compared, side, pair);
    for (const int ppm : kClocksOff_ppm) look(side, ppm, run_from_start(target_run, observed, ppm));
    for (const int ppm : kMoreClocksOff_ppm) look(side, ppm, run_from_start(target_run, observed, ppm));
  }
  analysis::Alikeness alikeness = analysis::alikeness(shares[0], shares[1]);
  if (alikeness == analysis::Alikeness::rare) {
    for (std::size_t side = 0; side < 2; ++side) {
      say(side);
      for (int ppm = kFirstOfMany_ppm; ppm < kLastOfMany_ppm; ppm += kStepOfMany_ppm)
        for (const int off : {ppm, -ppm})
          look(side, off,
               observer_.run(*pair.target_runs[side], observed_robot_of(compared, side, pair), {0, off}));
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

/// Returns a clock with which this target run behaves like the other target run. Without such a clock,
/// returns one with which this target run changes in a way similar to the difference.
std::optional<Edge> JitterProbe::find_of_clock(const Compared& compared, std::size_t side, const Pair& pair) {
  TargetRun& target_run = *pair.target_runs[side];
  progress_.say(
      fmt::format("checking whether {} behaves differently with another clock …", target_run.target));
  const ObservedRobot observed = observed_robot_of(compared, side, pair);
  std::optional<Edge> found;
  std::vector<std::int64_t> starts{0};
  for (const std::int64_t before : kClockOff_ns)
    if (compared.difference->t_ns[side] > before) starts.push_back(compared.difference->t_ns[side] - before);
  for (const std::int64_t from : starts)
    for (const int ppm : kClocksOff_ppm) {
      const analysis::History history = from == 0 ? run_from_start(target_run, observed, ppm)
                                                  : observer_.run(target_run, observed, {from, ppm});
      analysis::Comparison itself = analysis::compare(*pair.histories[side], history);
      if (!itself.first || itself.first->first_ns() >= observed.until_ns ||
          !analysis::is_of_driving(*itself.first))
        continue;
      const bool does = analysis::does_as(history, *pair.histories[1 - side], *compared.difference);
      if (!does && (found || !analysis::is_alike(*itself.first, *compared.difference))) continue;
      found = Edge{target_run.target, ppm, from, std::move(*itself.first), does};
      if (does) return found;
    }
  return found;
}

/// Finds out whether the program on the host shows both behaviours, depending on a delay of a few
/// milliseconds. In that case, the cause is chance. Returns no edge if a wrong clock has the same effect,
/// because find_of_clocks() handles that case.
std::vector<Edge> JitterProbe::find_of_ticks(const Compared& compared, const Pair& pair) {
  TargetRun* host = nullptr;
  std::array<bool, 2> done{};
  std::size_t as = 0;  // the host's runs begin with the delays of this side
  for (std::size_t side = 0; side < 2; ++side)
    if (pair.target_runs[side]->is_on_host(pair.robot))
      host = pair.target_runs[side], done[side] = true, as = side;
  if (!host) host = make_host_();
  if (!host) return {};
  progress_.say("checking whether the host shows both behaviours when slightly delayed …");
  const analysis::Difference& difference = *compared.difference;
  const bool drives = analysis::is_of_driving(difference);
  // A difference in output is checked only for a short time, because Comparer (behind_tick() in comparer.cpp)
  // compares the later output.
  const std::int64_t behind_ns = drives || pair.target_runs[as] != host ? analysis::kBehindEdge_ns : kSoon_ns;
  ObservedRobot observed = observed_robot_of(compared, as, pair);
  std::array<std::vector<result::Lateness>, 2> late{observed.late, observed.late};
  std::array<analysis::History, 2> ways{*pair.histories[0], *pair.histories[1]};
  std::optional<analysis::Difference> itself;
  // The run that shows one behaviour must clearly differ from the run that shows the other behaviour.
  // Otherwise a stream of similar lines would match both behaviours.
  const auto look = [&] {
    const analysis::History run = observer_.run(*host, observed);
    for (std::size_t side = 0; side < 2; ++side) {
      if (done[side] || !analysis::does_as(run, *pair.histories[side], difference, behind_ns)) continue;
      if (done[1 - side]) {
        itself = analysis::compare(side == 0 ? run : ways[0], side == 0 ? ways[1] : run).first;
        if (!itself || itself->first_ns() > difference.first_ns() + behind_ns) continue;
      }
      done[side] = true, late[side] = observed.late, ways[side] = run;
    }
    return done[0] && done[1];
  };
  const auto find = [&] {
    const std::vector<result::Lateness> so_far = observed.late;
    std::vector<std::int64_t> starts;
    for (const std::int64_t before : kLateBefore_ns)
      if (difference.first_ns() > before) starts.push_back(difference.first_ns() - before);
    starts.push_back(0);
    for (const std::int64_t from : starts) {
      for (const std::int64_t late_us : kLate_us) {
        observed.late = so_far;
        observed.late.insert(
            std::upper_bound(observed.late.begin(), observed.late.end(), from,
                             [](std::int64_t t, const result::Lateness& l) { return t < l.from_ns; }),
            {from, 1000 * late_us});
        if (look()) return true;
      }
    }
    return false;
  };
  if ((done[0] || done[1] || !look()) && !find()) return {};
  if (drives)
    for (const int ppm : kClocksOff_ppm) {
      const analysis::History& run = run_from_start(*host, observed_robot_of(compared, as, pair), ppm);
      for (std::size_t side = 0; side < 2; ++side)
        if (pair.target_runs[side] != host && analysis::does_as(run, *pair.histories[side], difference))
          return {};
    }
  Edge edge{host->target, 0, 0, std::move(*itself), true};
  edge.late = std::move(late);
  return {std::move(edge)};
}

const analysis::History& JitterProbe::run_from_start(TargetRun& target_run, const ObservedRobot& observed,
                                                     int ppm) {
  FromStart& runs = from_start_[&target_run];
  if (const auto known = runs.find(ppm); known != runs.end()) return known->second;
  return runs.emplace(ppm, observer_.run(target_run, observed, {0, ppm})).first->second;
}

ObservedRobot JitterProbe::observed_robot_of(const Compared& compared, std::size_t side, const Pair& pair) {
  return {pair.robot, compared.seed, shows_by(compared), pair.late[side]};
}

}  // namespace robosim::campaign
