#include "hal/host/coverage.h"

#ifdef ROBOSIM_COVERAGE

struct gcov_info;

extern "C" {
// The records that gcc generates for each source file. The linker collects them (-fprofile-info-section).
extern const gcov_info* const __start_robosim_gcov[] __attribute__((weak, visibility("hidden")));
extern const gcov_info* const __stop_robosim_gcov[] __attribute__((weak, visibility("hidden")));

// Declares a function of libgcov for programs without a file system.
void __gcov_info_to_gcda(const gcov_info* info, void (*name)(const char*, void*),
                         void (*dump)(const void*, unsigned, void*), void* (*allocate)(unsigned, void*),
                         void* argument);

// gcc's records refer to this function, which would add counts to a file. It is never called here.
void __gcov_merge_add(int64_t*, unsigned) {}
}

namespace robosim {
namespace host {
namespace {

void name(const char* file, void* sink) { static_cast<CounterSink*>(sink)->begin(file); }

void dump(const void* bytes, unsigned count, void* sink) {
  static_cast<CounterSink*>(sink)->add(bytes, count);
}

// Allocates nothing: -fprofile-arcs has no counters that need memory.
void* allocate(unsigned, void*) { return nullptr; }

}  // namespace

void give_counters(CounterSink& sink) {
  for (const gcov_info* const* info = __start_robosim_gcov; info != __stop_robosim_gcov; ++info)
    __gcov_info_to_gcda(*info, name, dump, allocate, &sink);
}

}  // namespace host
}  // namespace robosim

#endif  // ROBOSIM_COVERAGE
