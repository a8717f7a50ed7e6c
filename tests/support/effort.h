// How often a test repeats itself with other random numbers.
#pragma once

#if defined(__SANITIZE_ADDRESS__)
#define ROBOSIM_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define ROBOSIM_SANITIZED 1
#endif
#endif

namespace robosim::test {

/// `times`; under the sanitizers, where a run takes tens of times as long, a tenth of it, rounded up: the
/// optimised build shows that the results are right, this one that no line misbehaves on the way.
template <typename Count>
constexpr Count rounds(Count times) {
#if defined(ROBOSIM_SANITIZED)
  return (times + 9) / 10;
#else
  return times;
#endif
}

}  // namespace robosim::test
