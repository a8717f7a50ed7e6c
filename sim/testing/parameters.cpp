#include "robosim/testing/parameters.h"

#include <algorithm>
#include <cstdlib>

#include "sim/launch/client/runner.h"

// Returns the targets that were passed to robosim_add_test() (toolchain/cmake); "" = all.
extern "C" const char* robosim_test_targets() __attribute__((weak));

namespace robosim::testing {

std::vector<std::string> target_names() {
  const std::vector<std::string>& all = client::available_targets();
  const char* chosen = std::getenv("ROBOSIM_TARGETS");
  if ((!chosen || !*chosen) && robosim_test_targets) chosen = robosim_test_targets();
  if (!chosen || !*chosen) return all;
  std::vector<std::string> some;
  for (const std::string& target : all)
    if (("," + std::string(chosen) + ",").find("," + target + ",") != std::string::npos)
      some.push_back(target);
  return some;
}

std::vector<std::uint64_t> seeds(std::uint64_t first, std::uint64_t last) {
  if (const char* count = std::getenv("ROBOSIM_TEST_SEEDS"))
    last = first + std::max<std::uint64_t>(std::strtoull(count, nullptr, 10), 1) - 1;
  std::vector<std::uint64_t> values;
  for (std::uint64_t seed = first; seed <= last; ++seed) values.push_back(seed);
  return values;
}

std::string word_of(const std::string& value) {
  std::string word;
  for (const char c : value)
    word += (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ? c : '_';
  return word.empty() ? "_" : word;
}

}  // namespace robosim::testing
