// Between who tells what happens in a run and who hears it: what there is much of goes on many at a time
// (wire/batch.h), and in its order with all else.
#pragma once

#include <utility>

#include "sim/runner/narrator.h"
#include "sim/wire/batch.h"

namespace robosim::runner {

class Bundler {
 public:
  explicit Bundler(Tell tell) : tell_(std::move(tell)) {}
  void tell(wire::Event event);
  /// Tells what waits.
  void flush();

 private:
  Tell tell_;
  wire::BatchWriter waiting_;
};

}  // namespace robosim::runner
