#include "sim/campaign/sweep/figures.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <type_traits>
#include <utility>

namespace robosim::campaign {
namespace {

using Values = std::vector<double>;

/// Collects the numbers among a message's fields.
class Numbers {
 public:
  static constexpr bool kReads = false;
  static constexpr bool kDescribes = false;

  template <class T>
  void operator()(const char* key, const T& value, const char*, const result::Rules& rules = {}) {
    if constexpr (std::is_arithmetic_v<T>)
      found.emplace_back(key, rules.presence.written ? Values{static_cast<double>(value)} : Values{});
    else if constexpr (std::is_same_v<T, Values>)
      found.emplace_back(key, value);
  }

  std::vector<std::pair<const char*, Values>> found;
};

template <class Message>
auto numbers_of(const Message& message) {
  Numbers numbers;
  fields(numbers, message);
  return numbers.found;
}

constexpr const char* kTimeName = "time_s";

}  // namespace

Values Figure::values(const result::RunResult& result) const {
  if (name == std::string_view(kTimeName)) return {result.time_s};
  if (chip_only && !result.resources) return {};
  for (auto& [key, values] : chip_only ? numbers_of(*result.resources) : numbers_of(result.metrics))
    if (name == std::string_view(key)) return values;
  return {};
}

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all = [] {
    std::vector<Figure> made{{kTimeName, false}};
    for (const auto& number : numbers_of(result::Metrics())) made.push_back({number.first, false});
    for (const auto& number : numbers_of(result::Resources())) made.push_back({number.first, true});
    return made;
  }();
  return all;
}

std::string figure_text(double value) {
  constexpr double kAllDigitsFrom = 1000.0;
  if (value == std::floor(value) || std::abs(value) >= kAllDigitsFrom) return fmt::format("{:.0f}", value);
  return fmt::format("{:.4g}", value);
}

}  // namespace robosim::campaign
