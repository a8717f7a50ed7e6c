#include "sim/runner/event_batcher.h"

#include "sim/runner/answers.h"

namespace robosim::runner {

void EventBatcher::tell(wire::Event event) {
  if (waiting_.add(event)) return look();
  flush();
  tell_(std::move(event));
}

void EventBatcher::sample(int agent, const run::Sample& sample) {
  if (sample.at_station.empty() &&
      waiting_.add_sample(agent, sample.t / kMicrosecond, numbers_of(sample), sample.readings))
    return look();
  flush();
  wire::Sample told = to_wire(sample);
  told.agent = agent;
  tell_(std::move(told));
}

void EventBatcher::flush() {
  flushed_ns_ = waiting_.latest_ns();
  if (waiting_.size() == 0) return;
  hand_on_ ? waiting_.go_on_in(*hand_on_()) : tell_(waiting_.take());
}

}  // namespace robosim::runner
