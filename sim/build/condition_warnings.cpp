#include "sim/build/condition_warnings.h"

#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/build/tokens.h"

namespace robosim::build {
namespace {

/// An operand such as `s[4] == 1`.
struct Comparison {
  std::string subject;
  long value = 0;
  bool is_equal = true;  ///< ==, not !=
  bool has_call = false;
};

/// Successive operands that && joins. Stores only operands that are comparisons.
struct Chain {
  std::vector<Comparison> comparisons;
  int operands = 0;
};

/// An open parenthesis, or the code outside of all parentheses.
struct Level {
  std::size_t begin = 0;                 ///< index of the operand's first word
  Chain chain;                           ///< since the last ||
  std::vector<Comparison> alternatives;  ///< operands of || that are single comparisons
  int alternative_count = 0;
};

class ConditionCheck {
 public:
  explicit ConditionCheck(const std::vector<Token>& words)
      : words_(words), constants_(constants_in(words)), levels_(1) {}

  std::string warnings() {
    for (at_ = 0; at_ < words_.size(); ++at_) read_word();
    return std::move(text_);
  }

 private:
  std::string_view word(std::size_t at) const { return at < words_.size() ? words_[at].text : ""; }
  bool is_pair(std::size_t at, std::string_view one) const { return word(at) == one && word(at + 1) == one; }
  Level& level() { return levels_.back(); }

  void read_word() {
    constexpr std::size_t kMostLevels = 1000;
    const std::string_view now = word(at_);
    if (now == "(" && levels_.size() < kMostLevels) {
      levels_.emplace_back().begin = at_ + 1;
    } else if (now == ")") {
      end_condition(at_);
      if (levels_.size() > 1) levels_.pop_back();
    } else if (is_pair(at_, "&") || is_pair(at_, "|")) {
      end_operand(at_);
      if (now == "|") end_alternative();
      level().begin = ++at_ + 1;
    } else if (now == ";" || now == "{" || now == "}") {
      end_condition(at_);
      levels_.resize(1);
      level().begin = at_ + 1;
    } else if (now == "," || now == "?" || now == ":" || now == "return") {
      end_condition(at_);
      level().begin = at_ + 1;
    }
  }

  void end_operand(std::size_t end) {
    ++level().chain.operands;
    if (std::optional<Comparison> one = comparison(level().begin, end))
      level().chain.comparisons.push_back(std::move(*one));
  }

  void end_alternative() {
    Level& now = level();
    ++now.alternative_count;
    check_all(now.chain);
    if (now.chain.operands == 1 && !now.chain.comparisons.empty())
      now.alternatives.push_back(now.chain.comparisons.front());
    now.chain = {};
  }

  void end_condition(std::size_t end) {
    end_operand(end);
    end_alternative();
    Level& now = level();
    for (std::size_t i = 0; i < now.alternatives.size(); ++i)
      for (std::size_t k = i + 1; k < now.alternatives.size(); ++k) {
        const Comparison &one = now.alternatives[i], &other = now.alternatives[k];
        if (one.subject != other.subject || one.is_equal || other.is_equal || one.value == other.value)
          continue;
        if (now.alternative_count > 2 || one.has_call)
          warn("'{}' differs from {} or from {} at any time, so this condition is always true", one, other);
      }
    now.alternatives.clear();
    now.alternative_count = 0;
  }

  /// Checks operands that must all be true.
  void check_all(const Chain& chain) {
    for (std::size_t i = 0; i < chain.comparisons.size(); ++i)
      for (std::size_t k = i + 1; k < chain.comparisons.size(); ++k) {
        const Comparison &one = chain.comparisons[i], &other = chain.comparisons[k];
        if (one.subject != other.subject || !one.is_equal || !other.is_equal) continue;
        if (one.value != other.value && (chain.operands > 2 || one.has_call))
          warn("'{}' cannot be {} and {} at once, so this condition is never true", one, other);
        else if (one.value == other.value && chain.operands > 2)
          warn("'{}' is compared with {} twice in this condition: is another one meant?", one, other);
      }
  }

  /// Reads the operand from `begin` to `end`, with or without parentheses around it.
  std::optional<Comparison> comparison(std::size_t begin, std::size_t end) const {
    constexpr std::size_t kMostWords = 24;
    if (end - begin > kMostWords) return std::nullopt;
    while (begin < end && word(begin) == "(" && closes_at(begin, end) == end - 1) ++begin, --end;
    int open = 0;
    for (std::size_t i = begin; i + 2 < end; ++i) {
      open += word(i) == "(" || word(i) == "[" ? 1 : word(i) == ")" || word(i) == "]" ? -1 : 0;
      const bool is_equal = is_pair(i, "=");
      if (open != 0 || i == begin || word(i + 1) != "=" || (!is_equal && word(i) != "!")) continue;
      std::optional<long> value = constant(i + 2, end);
      const bool is_first = !value;  // `0 == x`
      if (is_first) value = constant(begin, i);
      const std::optional<Comparison> subject = is_first ? subject_of(i + 2, end) : subject_of(begin, i);
      if (!value || !subject) return std::nullopt;
      return Comparison{subject->subject, *value, is_equal, subject->has_call};
    }
    return std::nullopt;
  }

  /// Returns the index of the parenthesis that closes the one at `at`; `end` if it is not before `end`.
  std::size_t closes_at(std::size_t at, std::size_t end) const {
    int open = 0;
    for (std::size_t i = at; i < end; ++i) {
      open += word(i) == "(" ? 1 : word(i) == ")" ? -1 : 0;
      if (open == 0) return i;
    }
    return end;
  }

  std::optional<long> constant(std::size_t begin, std::size_t end) const {
    if (end != begin + 1) return std::nullopt;
    if (word(begin) == "true" || word(begin) == "false") return word(begin) == "true";
    if (words_[begin].kind == Token::Kind::number) {
      const std::string text = words_[begin].str();
      char* rest = nullptr;
      const long value = std::strtol(text.c_str(), &rest, 0);
      return *rest == '\0' ? std::optional(value) : std::nullopt;
    }
    const auto known = constants_.find(word(begin));
    return known == constants_.end() ? std::nullopt : std::optional<long>(known->second);
  }

  /// Reads a variable, an element, or a call of digitalRead() or analogRead(). Returns nothing for an
  /// expression whose value may differ between two evaluations.
  std::optional<Comparison> subject_of(std::size_t begin, std::size_t end) const {
    Comparison found;
    if (begin >= end || !is_name(word(begin))) return std::nullopt;
    for (std::size_t i = begin; i < end; ++i) {
      const std::string_view now = word(i);
      const bool is_open = now == "(";
      if (is_open && (i == begin || (word(i - 1) != "digitalRead" && word(i - 1) != "analogRead")))
        return std::nullopt;
      if (now == "=" || now == "<" || now == "!" || is_pair(i, "+") || is_pair(i, "-")) return std::nullopt;
      found.has_call |= is_open;
      found.subject += now;
    }
    return found;
  }

  void warn(fmt::format_string<const std::string&, const long&, const long&> text, const Comparison& one,
            const Comparison& other) {
    const Token& here = words_[at_];
    if (here.line == last_line_ && here.file == last_file_) return;
    last_line_ = here.line;
    last_file_ = here.file;
    text_ += fmt::format("{}{}:{}: warning: ", text_.empty() ? "" : "\n", here.file, here.line);
    text_ += fmt::format(text, one.subject, one.value, other.value);
  }

  const std::vector<Token>& words_;
  const std::map<std::string_view, int> constants_;
  std::vector<Level> levels_;
  std::size_t at_ = 0;
  int last_line_ = 0;
  std::string_view last_file_;
  std::string text_;
};

}  // namespace

std::string condition_warnings(const std::string& own_lines) {
  const std::vector<Token> words = tokens_of(own_lines);
  return ConditionCheck(words).warnings();
}

}  // namespace robosim::build
