// Describes a delay that is injected into a sketch, as if the sketch's code took longer. A negative delay
// shortens the sketch's next delay().
#pragma once

#include <cstdint>

#include "sim/result/fields.h"

namespace robosim::result {

struct Lateness {
  std::int64_t from_ns = 0;
  std::int64_t by_ns = 0;
};

template <class V>
void fields(V& v, Same<V, Lateness>& l) {
  v("from_ns", l.from_ns,
    "time of the sketch's clock; the delay comes at the next end of `loop()` or beginning of `delay()`; 0: "
    "before `setup()`",
    {.unit = "ns", .least = 0});
  v("by_ns", l.by_ns,
    "duration of the delay, in which only interrupts are served; if negative, it shortens the next `delay()`",
    {.unit = "ns"});
}

}  // namespace robosim::result
