// Line coverage of the sketch: passes gcc's counters (-fprofile-arcs) to the executor, in gcov's file format.
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
