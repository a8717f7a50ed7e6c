#include "sim/run/scenario/spread.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "sim/base/parse_unsigned.h"
#include "sim/base/units.h"

namespace robosim::scenario {
namespace {

constexpr std::array<std::string_view, 2> kSigns = {"+-", "±"};

struct Unit {
  Dimension dimension;
  const char* name;  ///< name of the SI unit
};
// The units in which drawn() writes numbers that are neither integers nor times.
constexpr Unit kUnits[] = {{Dimension::length, "m"},  {Dimension::angle, "rad"}, {Dimension::voltage, "V"},
                           {Dimension::current, "A"}, {Dimension::speed, "m/s"}, {Dimension::ratio, ""}};

/// Returns the texts before and after the sign of a spread.
std::optional<std::pair<std::string, std::string>> split(const std::string& word) {
  for (const std::string_view sign : kSigns)
    if (const std::size_t at = word.find(sign); at != word.npos && at > 0)
      return std::pair(word.substr(0, at), word.substr(at + sign.size()));
  return std::nullopt;
}

std::string drawn(const std::string& value, const std::string& spread, double share) {
  const auto whole = parse_unsigned(value), wide = parse_unsigned(spread);
  if (whole && wide && *whole <= INT32_MAX && *wide <= INT32_MAX) {
    const auto most = static_cast<double>(*wide);
    const double step = std::floor((share + 1.0) * 0.5 * (2.0 * most + 1.0)) - most;  // uniform integer
    return fmt::format("{}", static_cast<std::int64_t>(*whole) + std::llround(std::min(step, most)));
  }
  const auto time = parse_duration_ns(value), around = parse_duration_ns(spread);
  const bool is_share = spread.ends_with('%');
  if (time && (around || is_share)) {
    const double amount =
        around ? static_cast<double>(*around)
               : static_cast<double>(*time) * parse_quantity(spread, Dimension::ratio).value_or(-1.0);
    if (amount >= 0.0) return fmt::format("{}ns", *time + std::llround(share * amount));
  }
  for (const auto& [dimension, unit] : kUnits) {
    const auto middle = parse_quantity(value, dimension);
    if (!middle) continue;
    auto amount = parse_quantity(spread, dimension);
    if (is_share && !value.ends_with('%'))
      if ((amount = parse_quantity(spread, Dimension::ratio))) *amount *= std::fabs(*middle);
    if (amount && *amount >= 0.0) return fmt::format("{:.9g}{}", *middle + share * *amount, unit);
  }
  return "";
}

}  // namespace

bool has_spread(const std::string& word) {
  return split(word).has_value() && (word[0] == '-' || (word[0] >= '0' && word[0] <= '9'));
}

std::string with_shares(const std::string& word, const Share& share, std::size_t& first, const Place& place) {
  std::string all;
  for (std::size_t from = 0; from <= word.size();) {
    const std::size_t end = std::min(word.find(',', from), word.size());
    std::string part = word.substr(from, end - from);
    if (const auto both = split(part)) {
      const std::string figure = drawn(both->first, both->second, share(first++));
      if (figure.empty())
        throw InputError(
            place, fmt::format("invalid value with a spread: expected an amount in a unit of the same kind, "
                               "or a share, after +-, as in 2s+-500ms, 2s+-10% or 12+-2, got \"{}\"",
                               part));
      if (figure[0] == '-' && part[0] != '-')
        throw InputError(place, fmt::format("the spread of \"{}\" reaches below 0", part));
      part = figure;
    }
    all += part;
    if (end < word.size()) all += ',';
    from = end + 1;
  }
  return all;
}

}  // namespace robosim::scenario
