#include "sim/runner/bundler.h"

#include <cstddef>
#include <utility>

#include "hal/board/sim_time.h"

namespace robosim::runner {
namespace {

// What is lost if firmware takes its process down; a line of its own costs as much as some ten events in it.
constexpr SimTime kLongest = 100 * kMillisecond;
constexpr std::size_t kMost_bytes = 32'768;

}  // namespace

void Bundler::tell(wire::Event event) {
  if (!waiting_.add(event)) {
    flush();
    tell_(std::move(event));
  } else if (waiting_.size() >= kMost_bytes || waiting_.latest_ns() - waiting_.since_ns() >= kLongest) {
    flush();
  }
}

void Bundler::flush() {
  if (waiting_.size() > 0) tell_(waiting_.take());
}

}  // namespace robosim::runner
