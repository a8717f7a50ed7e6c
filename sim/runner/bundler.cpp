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
  const bool is_late = std::holds_alternative<wire::Columns>(event);
  if (!waiting_.add(event)) {
    flush();
    tell_(std::move(event));
  } else if (is_late) {
    flush();
  } else {
    look();
  }
}

void Bundler::sample(const wire::Sample& sample) { waiting_.add(sample) ? look() : tell(sample); }

void Bundler::pin(int agent, SimTime t, std::string_view pin, const PinDrive& drive) {
  waiting_.add_pin(agent, t, pin, static_cast<int>(drive.mode), drive.level, drive.pwm, drive.duty,
                   drive.tone_hz);
  look();
}

void Bundler::level(int agent, SimTime t, std::string_view pin, bool level) {
  waiting_.add_level(agent, t, pin, level);
  look();
}

void Bundler::volts(int agent, SimTime t, std::string_view pin, double volts) {
  waiting_.add_volts(agent, t, pin, volts);
  look();
}

void Bundler::look() {
  if (waiting_.size() >= kMost_bytes || waiting_.latest_ns() - waiting_.since_ns() >= kLongest) flush();
}

void Bundler::flush() {
  if (waiting_.size() > 0) tell_(waiting_.take());
}

}  // namespace robosim::runner
