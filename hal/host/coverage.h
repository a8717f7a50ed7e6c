// Line coverage of the sketch: passes gcc's counters (-fprofile-arcs) on in the format that gcov reads.
#pragma once

#include "hal/host/image.h"

namespace robosim {
namespace host {

#ifdef ROBOSIM_COVERAGE
void give_counters(CounterSink& sink);
constexpr auto kCounters = give_counters;
#else
constexpr void (*kCounters)(CounterSink&) = nullptr;
#endif

}  // namespace host
}  // namespace robosim
