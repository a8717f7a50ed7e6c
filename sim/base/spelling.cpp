#include "sim/base/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace robosim {
namespace {

/// How many letters are wrong, missing or too many; two that are swapped count once, and capitals do not
/// matter.
std::size_t distance(const std::string& a, const std::string& b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  const std::size_t columns = b.size() + 1;
  std::vector<std::size_t> table((a.size() + 1) * columns);
  const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& { return table[i * columns + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        at(i, j) = i + j;
        continue;
      }
      const bool differ = small(a[i - 1]) != small(b[j - 1]);
      at(i, j) = std::min({at(i - 1, j - 1) + differ, at(i - 1, j) + 1, at(i, j - 1) + 1});
      if (i > 1 && j > 1 && small(a[i - 1]) == small(b[j - 2]) && small(a[i - 2]) == small(b[j - 1])) {
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
      }
    }
  }
  return at(a.size(), b.size());
}

}  // namespace

std::string all_of(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return text;
}

std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& candidates) {
  constexpr std::size_t kBeginning = 4;
  std::optional<std::string> best;
  std::size_t least = std::max<std::size_t>(word.size() / 3, 1) + 1;
  for (const std::string& candidate : candidates) {
    const bool begins = word.size() >= kBeginning && candidate.starts_with(word);
    const std::size_t d = begins ? 1 : distance(word, candidate);
    if (d < least) {
      least = d;
      best = candidate;
    }
  }
  return best;
}

std::string guess_and_list(const std::string& name, const std::vector<std::string>& candidates) {
  const auto guess = nearest(name, candidates);
  return fmt::format("{}{} {}", guess ? "did you mean " + *guess + "? There " : "there ",
                     candidates.size() == 1 ? "is" : "are", candidates.empty() ? "none" : all_of(candidates));
}

std::string unknown_name(const std::string& what, const std::string& name,
                         const std::vector<std::string>& candidates) {
  return fmt::format("there is no {} “{}”; {}", what, name, guess_and_list(name, candidates));
}

}  // namespace robosim
