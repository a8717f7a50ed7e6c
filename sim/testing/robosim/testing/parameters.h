// Provides values for TEST_P: INSTANTIATE_TEST_SUITE_P(On, MyTest, AllTargets(), Named());
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace robosim::testing {

/// Returns the names of all targets, "host" first. The environment variable ROBOSIM_TARGETS="host" selects
/// some of them.
std::vector<std::string> target_names();
inline auto AllTargets() { return ::testing::ValuesIn(target_names()); }

/// Returns seeds from `first` to `last`. The environment variable ROBOSIM_TEST_SEEDS=N overrides the number
/// of seeds.
std::vector<std::uint64_t> seeds(std::uint64_t first, std::uint64_t last);
/// Returns seeds from 1 to `count`.
inline std::vector<std::uint64_t> seeds(std::uint64_t count) { return seeds(1, count); }
inline auto Seeds(std::uint64_t first, std::uint64_t last) { return ::testing::ValuesIn(seeds(first, last)); }

/// Returns values for these targets.
template <typename... Names>
auto Targets(Names... names) {
  return ::testing::ValuesIn(std::vector<std::string>{names...});
}

/// Returns values for these maps, given by name or path.
template <typename... Names>
auto Maps(Names... names) {
  return ::testing::ValuesIn(std::vector<std::string>{names...});
}

/// Returns the test's name for a parameter value: letters, digits and _.
std::string word_of(const std::string& value);
inline std::string word_of(std::uint64_t value) { return std::to_string(value); }

struct Named {
  template <typename Info>
  std::string operator()(const Info& info) const {
    return word_of(info.param);
  }
};

}  // namespace robosim::testing
