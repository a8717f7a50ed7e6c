// Defines times, lengths and speeds with their units: 2_s, 1.5_s, 100_ms, 15_mm, 0.4_m_per_s.
#pragma once

#include <chrono>
#include <cstdint>

namespace robosim::testing {

/// Simulated time. The literals of std::chrono (2s, 100ms) work, too.
using Duration = std::chrono::nanoseconds;

struct Length {
  double mm = 0.0;
};

struct Speed {
  double mm_per_s = 0.0;
};

constexpr Length mm(double value) { return {value}; }

/// An upper limit of a duration or a distance.
template <typename Quantity>
struct Within {
  Quantity most;
};
constexpr Within<Duration> within(Duration most) { return {most}; }
constexpr Within<Length> within(Length most) { return {most}; }

inline namespace literals {

constexpr Duration operator""_s(unsigned long long v) {
  return std::chrono::seconds(static_cast<std::int64_t>(v));
}
constexpr Duration operator""_s(long double v) {
  return Duration(static_cast<std::int64_t>(v * 1e9L + 0.5L));
}
constexpr Duration operator""_ms(unsigned long long v) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(v));
}
constexpr Duration operator""_ms(long double v) {
  return Duration(static_cast<std::int64_t>(v * 1e6L + 0.5L));
}
constexpr Duration operator""_us(unsigned long long v) {
  return std::chrono::microseconds(static_cast<std::int64_t>(v));
}
constexpr Duration operator""_min(unsigned long long v) {
  return std::chrono::minutes(static_cast<std::int64_t>(v));
}
constexpr Length operator""_mm(unsigned long long v) { return {static_cast<double>(v)}; }
constexpr Length operator""_mm(long double v) { return {static_cast<double>(v)}; }
constexpr Length operator""_m(unsigned long long v) { return {1e3 * static_cast<double>(v)}; }
constexpr Length operator""_m(long double v) { return {1e3 * static_cast<double>(v)}; }
constexpr Speed operator""_mm_per_s(unsigned long long v) { return {static_cast<double>(v)}; }
constexpr Speed operator""_m_per_s(long double v) { return {1e3 * static_cast<double>(v)}; }

}  // namespace literals
}  // namespace robosim::testing
