#include "sim/build/indentation_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/build/tokens.h"

namespace robosim::build {
namespace {

class IndentationCheck {
 public:
  explicit IndentationCheck(const std::string& source) : source_(source), words_(tokens_of(source)) {}

  std::string warnings() {
    for (std::size_t i = 0; i < words_.size(); ++i) check(i);
    return std::move(text_);
  }

 private:
  std::string_view word(std::size_t at) const { return at < words_.size() ? words_[at].text : ""; }

  /// Returns the spaces and tabs before a word; nothing if the word is not the first of its line.
  std::optional<std::string_view> indentation(std::size_t at) const {
    const std::size_t place = words_[at].text.data() - source_.data();
    const std::size_t begin = place == 0 ? 0 : source_.rfind('\n', place - 1) + 1;
    const std::string_view before = source_.substr(begin, place - begin);
    return before.find_first_not_of(" \t") == before.npos ? std::optional(before) : std::nullopt;
  }

  /// Returns the index after the statement's head: after "else", or after "if (…)". Returns 0 if no head
  /// begins here.
  std::size_t after_head(std::size_t at) const {
    if (word(at) == "else") return word(at + 1) == "if" ? after_head(at + 1) : at + 1;
    if (word(at) != "if" && word(at) != "for" && word(at) != "while") return 0;
    if (word(at + 1) != "(") return 0;
    int open = 0;
    for (std::size_t i = at + 1; i < words_.size() && i < at + kMostWords; ++i) {
      open += word(i) == "(" ? 1 : word(i) == ")" ? -1 : 0;
      if (open == 0) return i + 1;
    }
    return 0;
  }

  /// Returns the index after a statement that ends with `;` and has no braces; 0 for other statements.
  std::size_t after_statement(std::size_t at) const {
    constexpr std::array<std::string_view, 8> kOthers = {"if",     "for",  "while", "do",
                                                         "switch", "else", "{",     ";"};
    if (std::find(kOthers.begin(), kOthers.end(), word(at)) != kOthers.end()) return 0;
    for (std::size_t i = at; i < words_.size() && i < at + kMostWords; ++i) {
      if (word(i) == ";") return i + 1;
      if (word(i) == "{" || word(i) == "}" || words_[i].kind == Token::Kind::define) return 0;
    }
    return 0;
  }

  void check(std::size_t at) {
    const std::size_t body = after_head(at);
    if (body == 0 || body >= words_.size()) return;
    const std::size_t next = after_statement(body);
    if (next == 0 || next >= words_.size()) return;
    // A macro may contain braces, and a preprocessor's condition may remove one of the lines.
    if (word(next) == "else" || word(next) == "}" || word(next) == "case" || word(next) == "default" ||
        words_[next].kind == Token::Kind::define || has_directive(at, next))
      return;
    const auto head_space = indentation(at), body_space = indentation(body), next_space = indentation(next);
    if (!head_space || !body_space || !next_space || *body_space != *next_space) return;
    if (words_[at].file != words_[next].file || words_[body].line != words_[at].line + 1) return;
    if (body_space->size() <= head_space->size() || !body_space->starts_with(*head_space)) return;
    text_ += fmt::format(
        "{}{}:{}: warning: this line does not belong to the '{}' of line {}, which ends before it: put both "
        "lines "
        "into {{ }}, or indent this one less",
        text_.empty() ? "" : "\n", words_[next].file, words_[next].line, word(at), words_[at].line);
  }

  bool has_directive(std::size_t from, std::size_t to) const {
    const std::size_t begin = words_[from].text.data() - source_.data();
    const std::size_t end = words_[to].text.data() - source_.data();
    return source_.substr(begin, end - begin).find('#') != std::string_view::npos;
  }

  static constexpr std::size_t kMostWords = 200;

  const std::string_view source_;
  const std::vector<Token> words_;
  std::string text_;
};

}  // namespace

std::string indentation_warnings(const std::string& source) { return IndentationCheck(source).warnings(); }

}  // namespace robosim::build
