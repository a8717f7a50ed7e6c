#include "sim/base/did_you_mean.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "sim/base/error.h"

namespace robosim {
namespace {

/// Returns the number of wrong, missing or additional letters. Two swapped letters count once, and case is
/// ignored.
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

namespace {

/// Replaces the parameter of a form by the parameter of a word: "laps:N" and "lap:3" give "laps:3".
std::string filled_in(const std::string& form, const std::string& word) {
  const std::size_t colon = form.find(':'), given = word.find(':');
  if (colon == form.npos || given == word.npos) return form;
  return form.substr(0, colon) + word.substr(given);
}

/// Returns the length of the common prefix of two words.
std::size_t same_beginning(const std::string& a, const std::string& b) {
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
}

std::string head_of(const std::string& form) { return form.substr(0, form.find(':')); }

}  // namespace

std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& candidates) {
  constexpr std::size_t kBeginning = 4;
  std::optional<std::string> best;
  std::size_t least = std::max<std::size_t>(word.size() / 3, 1) + 1;
  for (const std::string& candidate : candidates) {
    const bool begins = word.size() >= kBeginning && candidate.starts_with(word);
    const bool is_form = candidate.find(':') != candidate.npos;
    const std::size_t d = begins    ? 1
                          : is_form ? distance(head_of(word), head_of(candidate))
                                    : distance(word, candidate);
    if (d >= std::max(word.size(), candidate.size())) continue;
    const bool is_nearer =
        d < least || (best && d == least && same_beginning(word, candidate) > same_beginning(word, *best));
    if (is_nearer) {
      least = d;
      best = filled_in(candidate, word);
    }
  }
  return best == word ? std::nullopt : best;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  const auto guess = nearest(word, candidates);
  return guess ? fmt::format("; did you mean {}?", *guess) : "";
}

std::string expected_one_of(const std::string& word, const std::vector<std::string>& allowed) {
  return fmt::format("expected {}, got “{}”{}", one_of(allowed), word, did_you_mean(word, allowed));
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
