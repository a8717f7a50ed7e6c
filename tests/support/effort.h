// Sets the number of repetitions of tests with random numbers.
#pragma once

#if defined(ROBOSIM_EMULATED)  // cross-built: programs run under qemu-user
#define ROBOSIM_SLOW 1
#elif defined(__SANITIZE_ADDRESS__)
#define ROBOSIM_SLOW 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define ROBOSIM_SLOW 1
#endif
#endif

namespace robosim::test {

/// Under the sanitizers and under an emulator a run takes tens of times as long. Slow builds therefore try
/// fewer random numbers.
#if defined(ROBOSIM_SLOW)
inline constexpr bool kSlow = true;
#else
inline constexpr bool kSlow = false;
#endif

/// Returns `times`, or in a slow build a tenth of `times`, rounded up.
template <typename Count>
constexpr Count rounds(Count times) {
  return kSlow ? (times + 9) / 10 : times;
}

}  // namespace robosim::test
