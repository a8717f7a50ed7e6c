// Between who tells what happens in a run and who hears it: what there is much of goes on many at a time
// (wire/batch.h), and in its order with all else.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>

#include "hal/board/board.h"
#include "hal/board/sim_time.h"
#include "sim/wire/batch.h"

namespace robosim::runner {

/// Who hears of what happens.
using Tell = std::function<void(wire::Event)>;

class Bundler {
 public:
  explicit Bundler(Tell tell) : tell_(std::move(tell)) {}
  void tell(wire::Event event);
  // The same as events; these there are most of.
  void sample(const wire::Sample& sample);
  void pin(int agent, SimTime t, std::string_view pin, const PinDrive& drive);
  void level(int agent, SimTime t, std::string_view pin, bool level);
  void volts(int agent, SimTime t, std::string_view pin, double volts);
  /// Tells what waits.
  void flush();

 private:
  void look();

  Tell tell_;
  wire::BatchWriter waiting_;
};

}  // namespace robosim::runner
