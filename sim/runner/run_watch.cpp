#include "sim/runner/run_watch.h"

#include <algorithm>
#include <ctime>

#include "sim/base/process_state.h"
#include "sim/base/wall_clock.h"

namespace robosim::runner {
namespace {

std::int64_t processor_ns(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0;
  return std::int64_t{time.tv_sec} * kSecond + time.tv_nsec;
}

/// Returns whether a run may be silent: a debugger has halted it, or it is waiting for a processor. A run
/// that is silent for another reason, such as a blocking call in its sketch, is not excused.
bool is_excused(pid_t process) {
  const char state = process_state(process);
  return state == 't' || state == 'R';
}

constexpr std::int64_t kLongest_us = std::int64_t{kLongestSleep_s} * 1'000'000;
/// A working run gets at least 1 / kBusyMachine of the time of a processor, even on a busy machine.
constexpr std::int64_t kBusyMachine = 20;
/// If more time passes between two checks, the runner itself was stopped. The time above this limit does not
/// count.
constexpr std::int64_t kLongestLook_us = 1'000'000;

}  // namespace

RunWatch::State& RunWatch::state() {
  static const Shared<State> shared;
  return *shared.get();
}

// Returns a flag on a memory page of its own. The run's process unmaps this page before it loads firmware.
const Shared<std::atomic<bool>>& RunWatch::closed() {
  static const Shared<std::atomic<bool>> shared;
  return shared;
}

void RunWatch::close() const {
  *closed().get() = true;
  closed().leave();
}

RunWatch::RunWatch() : state_(state()) {
  *closed().get() = false;
  state_.reached = kNotBegun;
  state_.acting = 0;
  state_.waits = false;
}

void RunWatch::follow(pid_t run, const Limits& limits) {
  run_ = run;
  limits_ = limits;
}

SimTime RunWatch::time() const {
  return std::clamp<SimTime>(state_.reached.load(std::memory_order_relaxed), 0, limits_.until);
}

RunWatch::Reading RunWatch::read() const {
  // Detecting a debugger requires reading a file, so it is done only during a long silence.
  return {processor_ns(run_), wall_us(), silent_us_ >= kLongest_us / 2 && is_excused(run_)};
}

RunWatch::Found RunWatch::look(const Reading& now) {
  const SimTime reached = state_.reached.load(std::memory_order_relaxed);
  const int acting = state_.acting.load(std::memory_order_relaxed);
  if (looked_.wall_us >= 0) {
    const std::int64_t passed_us = std::min(now.wall_us - looked_.wall_us, kLongestLook_us);
    const std::int64_t worked_us = (now.processor_ns - looked_.processor_ns) / 1000;
    silent_us_ = std::max<std::int64_t>(silent_us_ + passed_us - kBusyMachine * worked_us, 0);
  }
  // Firmware that writes kNotBegun to `reached` gains time only once, and at most the time of a whole run.
  const bool begins = !has_begun_ && reached != kNotBegun;
  if (begins) begun_ns_ = looked_.processor_ns;
  looked_ = now;
  has_begun_ |= begins;
  const bool prepares = !has_begun_ && !*closed().get();
  if (prepares || reached != seen_ || acting != seen_acting_) heard();
  if (!has_begun_ || reached != seen_ || acting != seen_acting_) processor_ns_ = now.processor_ns;
  if (prepares) begun_ns_ = now.processor_ns;
  seen_ = reached;
  seen_acting_ = acting;
  if (now.is_excused || (limits_.may_wait && state_.waits)) heard();
  if (now.processor_ns - processor_ns_ >= kLongestTick_s * kSecond) return Found::loops;
  const auto simulated = static_cast<std::int64_t>(limits_.share * static_cast<double>(time()));
  if (now.processor_ns - begun_ns_ >= kLongestRun_s * kSecond + simulated) return Found::exhausts;
  return silent_us_ >= kLongest_us ? Found::sleeps : Found::nothing;
}

}  // namespace robosim::runner
