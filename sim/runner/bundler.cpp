#include "sim/runner/bundler.h"

namespace robosim::runner {

void Bundler::tell(wire::Event event) {
  if (waiting_.add(event)) return look();
  flush();
  tell_(std::move(event));
}

void Bundler::sample(const wire::Sample& sample) { waiting_.add(sample) ? look() : tell(sample); }

void Bundler::flush() {
  flushed_ns_ = waiting_.latest_ns();
  if (waiting_.size() == 0) return;
  hand_on_ ? waiting_.go_on_in(*hand_on_()) : tell_(waiting_.take());
}

}  // namespace robosim::runner
