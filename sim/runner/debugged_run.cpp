#include "sim/runner/debugged_run.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace robosim::runner {
namespace {

using exec::gdb::Edge;
using exec::gdb::LeftRun;
using exec::gdb::Place;
using exec::gdb::Search;

constexpr SimTime kStretch = 10 * kMillisecond;  // time between two checks whether a snapshot is due
constexpr SimTime kClose = 2 * kTick;            // a Place's tick begins at most this long before Place::t

}  // namespace

DebuggedRun::DebuggedRun(const run::Setup& setup, exec::gdb::Server& server)
    : server_(server),
      told_(*setup.agents.front().listener),
      interrupted_(setup.interrupted),
      setup_([&] {
        run::Setup own = setup;
        own.agents.front().listener = &told_;
        return own;
      }()),
      simulation_(setup_) {
  try {
    static_cast<void>(simulation_.save());
    server_.go_back_in(*this);
  } catch (const InputError&) {
    // Ignored: without a history, gdb itself reports that it cannot go back.
  }
}

judge::Outcome DebuggedRun::go() {
  for (;;) {
    try {
      run_on();
      judge::Outcome outcome = std::move(simulation_.end().front());
      if (!halts_at_end(outcome)) return outcome;
    } catch (const LeftRun&) {
      end_shown_ = false;
      go_back();
    }
  }
}

void DebuggedRun::run_on() {
  while (!simulation_.is_over()) {
    const SimTime t = simulation_.now();
    if (!server_.attached()) moments_.clear();
    const bool can_go_back = server_.history() && server_.attached();
    if (can_go_back && t >= moments_.next()) moments_.add({t, simulation_.save(), told_.count()});
    // Defers an interruption while the run repeats an earlier part. Otherwise the run could end at a time
    // before the last reports that the listener already has.
    setup_.interrupted = told_.is_at_front() ? interrupted_ : nullptr;
    simulation_.run_until(t + kStretch);
  }
}

void DebuggedRun::restore(std::size_t moment) {
  setup_.interrupted = nullptr;
  simulation_.restore(moments_[moment].snapshot);
  told_.go_back(moments_[moment].told);
}

bool DebuggedRun::look(std::size_t moment, SimTime closely_from) {
  restore(moment);
  search.goal = Search::Goal::look;
  search.closely_from = closely_from;
  search.found.reset();
  search.before.reset();
  const bool is_last = moment + 1 == moments_.size() || moments_[moment + 1].t > search.present;
  try {
    simulation_.run_until(is_last ? search.present + kClose : moments_[moment + 1].t);
  } catch (const LeftRun&) {
  }
  return search.found.has_value();
}

void DebuggedRun::seek(std::size_t moment, const Place& place) {
  restore(moment);
  search.goal = Search::Goal::seek;
  search.closely_from = place.t - kClose;
  search.target = place;
}

/// Searches backward, from snapshot to snapshot, for the last place that matches the search. Returns the
/// number of the snapshot before this place.
std::optional<std::size_t> DebuggedRun::find() {
  const std::size_t last = moments_.before(search.present);
  if (search.steps && look(last, search.present - kClose)) return last;
  for (std::size_t moment = last + 1; moment-- > 0;) {
    if (is_left_alone()) break;
    if (look(moment, search.steps ? 0 : kNever)) return moment;
  }
  return std::nullopt;
}

void DebuggedRun::go_back() {
  const std::optional<std::size_t> moment = find();
  if (moment) {
    seek(*moment, Place(*search.found));
  } else if (is_left_alone()) {
    search.goal = Search::Goal::none;
  } else {
    seek(0, {.stop = {.edge = Edge::begin}});
  }
}

/// Halts at the end of a run as after a crash, so that the user can go back from there. Returns false if the
/// run does not halt.
bool DebuggedRun::halts_at_end(const judge::Outcome& outcome) {
  using judge::Verdict;
  const Verdict verdict = outcome.verdict;
  if (verdict == Verdict::reached || verdict == Verdict::crashed || verdict == Verdict::interrupted)
    return false;
  if (moments_.empty() || is_left_alone() || std::exchange(end_shown_, true)) return false;
  search = {.present = simulation_.now(), .steps = true, .depth = std::numeric_limits<std::size_t>::max()};
  const std::optional<std::size_t> moment = find();
  if (!moment) return false;  // the power was always off
  Place place = *search.found;
  place.stop.edge = Edge::end;
  server_.say("The run is over: " + outcome.why +
              " This is its last instruction. Enter “continue” to end the run.");
  seek(*moment, place);
  return true;
}

}  // namespace robosim::runner
