#include "sim/runner/run_watch.h"

#include <fmt/format.h>

#include <ctime>
#include <fstream>
#include <iterator>
#include <string>

#include "sim/base/wall_clock.h"

namespace robosim::runner {
namespace {

std::int64_t processor_ns(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0;
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

RunWatch::State& RunWatch::state() {
  static const Shared<State> shared;
  return *shared.get();
}

RunWatch::RunWatch() : state_(state()) {
  state_.reached = kNotBegun;
  state_.acting = 0;
  state_.waits = false;
}

void RunWatch::follow(pid_t run) {
  run_ = run;
  heard();
}

void RunWatch::heard() { wall_us_ = wall_us(); }

RunWatch::Found RunWatch::look() {
  const SimTime reached = state_.reached.load(std::memory_order_relaxed);
  const std::int64_t processor = processor_ns(run_);
  const int acting = state_.acting.load(std::memory_order_relaxed);
  if (reached != seen_ || acting != seen_acting_ || reached == kNotBegun) {
    seen_ = reached;
    seen_acting_ = acting;
    processor_ns_ = processor;
    heard();
    return Found::nothing;
  }
  if (processor - processor_ns_ >= std::int64_t{kLongestTick_s} * 1'000'000'000) return Found::loops;
  constexpr std::int64_t kLongest_us = std::int64_t{kLongestSleep_s} * 1'000'000;
  const std::int64_t silent_us = wall_us() - wall_us_;
  // Whether it is stopped takes a file to be read: that is asked of long silences alone.
  if (state_.waits || (silent_us >= kLongest_us / 2 && is_stopped())) heard();
  return wall_us() - wall_us_ >= kLongest_us ? Found::sleeps : Found::nothing;
}

/// By a debugger, say.
bool RunWatch::is_stopped() const {
  std::ifstream file(fmt::format("/proc/{}/stat", run_));
  const std::string facts((std::istreambuf_iterator<char>(file)), {});
  const std::size_t name_end = facts.rfind(") ");
  const char state = name_end == facts.npos ? 'R' : facts[name_end + 2];
  return state == 'T' || state == 't';
}

}  // namespace robosim::runner
