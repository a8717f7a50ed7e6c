#include "sim/base/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>
#include <thread>

#include "sim/base/did_you_mean.h"
#include "sim/base/error.h"
#include "sim/base/profile.h"
#include "sim/base/units.h"

namespace robosim {
namespace {

constexpr std::uint64_t kMostJobs = 1024;
constexpr std::uint64_t kMostSeeds = 1'000'000;

}  // namespace

void refuse_value(const char* option, const std::string& value, const std::string& allowed,
                  const std::string& hint) {
  throw InputError(fmt::format("{}: expected {}, got “{}”{}", option, allowed, value, hint));
}

std::int64_t simulated_time(const char* option, const std::string& text) {
  const auto ns = parse_duration_ns(text);
  if (!ns || *ns <= 0) {
    refuse_value(option, text,
                 fmt::format("a time above 0 with its unit, as in 60s ({})", unit_names(Dimension::time)));
  }
  return *ns;
}

std::uint64_t whole_number(const char* option, const std::string& text, std::uint64_t least,
                           std::uint64_t most) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < least || value > most) {
    refuse_value(option, text, fmt::format("a whole number from {} to {}", least, most));
  }
  return value;
}

std::uint64_t seed_number(const std::string& text) { return whole_number("--seed", text, 0, kMostSeed); }

void check_choice(const char* option, const std::string& value, const std::vector<std::string>& allowed) {
  if (std::find(allowed.begin(), allowed.end(), value) == allowed.end())
    throw InputError(fmt::format("{}: {}", option, expected_one_of(value, allowed)));
}

void check_profile(const std::string& value) {
  check_choice("--profile", value, {kProfileNames.begin(), kProfileNames.end()});
}

void read_seeds(const std::string& text, std::uint64_t& first, std::uint64_t& last) {
  constexpr const char* kForms = "one seed or a range FIRST..LAST, as in 1..100";
  const std::size_t dots = text.find("..");
  const auto number = [](const std::string& digits) -> std::optional<std::uint64_t> {
    std::uint64_t value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
  };
  const auto from = number(text.substr(0, dots));
  const auto to = dots == text.npos ? from : number(text.substr(dots + 2));
  if (!from || !to) {
    // Recognizes ranges in the notation of other tools: 1-30, 1:30, 1...30.
    const std::size_t other = text.find_first_not_of("0123456789");
    const std::size_t second = other == text.npos ? text.npos : text.find_first_of("0123456789", other);
    const bool is_range = other != 0 && second != text.npos && number(text.substr(second)).has_value();
    refuse_value("--seeds", text, kForms,
                 is_range ? fmt::format("; did you mean {}..{}?", text.substr(0, other), text.substr(second))
                          : fmt::format("; seeds are whole numbers up to {}", kMostSeed));
  }
  first = *from;
  last = *to;
  if (last < first) refuse_value("--seeds", text, kForms, "; the first seed is greater than the last");
  if (last - first >= kMostSeeds) refuse_value("--seeds", text, fmt::format("at most {} seeds", kMostSeeds));
}

std::vector<std::string> split_at_commas(const std::vector<std::string>& words) {
  std::vector<std::string> parts;
  for (const std::string& word : words) {
    for (std::size_t at = 0; at <= word.size();) {
      parts.push_back(word.substr(at, word.find(',', at) - at));
      at += parts.back().size() + 1;
    }
  }
  return parts;
}

std::size_t number_of_jobs(const std::string& text) {
  if (text.empty()) return std::max(1u, std::thread::hardware_concurrency());
  return whole_number("--jobs", text, 1, kMostJobs);
}

}  // namespace robosim
