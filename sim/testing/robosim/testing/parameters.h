// Values for TEST_P: INSTANTIATE_TEST_SUITE_P(On, MyTest, AllTargets(), Named());
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace robosim::testing {

/// The names of all targets, "host" first; ROBOSIM_TARGETS="host" leaves the others out.
std::vector<std::string> target_names();
inline auto AllTargets() { return ::testing::ValuesIn(target_names()); }

/// Seeds from `first` to `last`. ROBOSIM_TEST_SEEDS=N makes them N, from `first` on.
std::vector<std::uint64_t> seeds(std::uint64_t first, std::uint64_t last);
/// 1 to `count`, likewise.
inline std::vector<std::uint64_t> seeds(std::uint64_t count) { return seeds(1, count); }
inline auto Seeds(std::uint64_t first, std::uint64_t last) { return ::testing::ValuesIn(seeds(first, last)); }

/// Some targets only.
template <typename... Names>
auto Targets(Names... names) {
  return ::testing::ValuesIn(std::vector<std::string>{names...});
}

/// Maps by name or path.
template <typename... Names>
auto Maps(Names... names) {
  return ::testing::ValuesIn(std::vector<std::string>{names...});
}

/// A name for the test made of its parameter: letters, digits and _.
std::string word_of(const std::string& value);
inline std::string word_of(std::uint64_t value) { return std::to_string(value); }

struct Named {
  template <typename Info>
  std::string operator()(const Info& info) const {
    return word_of(info.param);
  }
};

}  // namespace robosim::testing
