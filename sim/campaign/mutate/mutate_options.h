// The options of a mutation test.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace robosim::mutate {

struct MutateOptions {
  std::string sketch;
  std::string checks;              ///< a file; empty = the sketch's checks.toml
  std::vector<std::string> tests;  ///< GoogleTest programs, used instead of checks
  std::uint64_t seed = 1;
  std::size_t count = 20;  ///< number of bugs
  std::size_t jobs = 1;    ///< simultaneous runs
};

}  // namespace robosim::mutate
