#include "sim/build/tokens.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <set>
#include <string>
#include <utility>

#include "sim/build/lexing.h"

namespace robosim::build {
namespace {

class Lexer {
 public:
  explicit Lexer(std::string_view source) : source_(source), quote_ends_(source) {
    while (at_ < source_.size()) step();
    end_define();
  }

  std::vector<Token> take_tokens() { return std::move(tokens_); }
  std::vector<Comment> take_comments() { return std::move(comments_); }

 private:
  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0';
  }

  void step() {
    const char c = peek();
    if (c == '\\' && peek(1) == '\n') {
      ++line_;
      at_ += 2;
    } else if (c == '\n') {
      end_define();
      ++line_;
      ++at_;
      fresh_ = true;
    } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++at_;
    } else if (c == '/' && (peek(1) == '/' || peek(1) == '*')) {
      read_comment();
    } else if (c == '#' && fresh_) {
      directive();
    } else {
      fresh_ = false;
      token(c);
    }
  }

  void token(char c) {
    if (is_of_name(c)) {
      add(is_digit(c) ? Token::Kind::number : Token::Kind::word, end_of_name());
    } else {
      const std::size_t end = c == '"' || c == '\'' ? quote_ends_.of(at_) : at_ + 1;
      add(end - at_ > 1 ? Token::Kind::text : Token::Kind::punctuation, end);
    }
  }

  void directive() {
    constexpr std::string_view kDefine = "define";
    fresh_ = false;
    const auto marker = line_marker(source_.substr(at_, source_.find('\n', at_) - at_));
    if (marker) line_ = marker->line - 1, file_ = marker->file;
    ++at_;
    skip_blanks();
    if (source_.substr(at_, end_of_name() - at_) != kDefine) return skip_line();
    at_ += kDefine.size();
    skip_blanks();
    add(Token::Kind::define, end_of_name());
    in_define_ = true;
  }

  void end_define() {
    if (in_define_) tokens_.push_back({kEndOfDefine, file_, line_});
    in_define_ = false;
  }

  void skip_blanks() {
    while (peek() == ' ' || peek() == '\t') ++at_;
  }

  void skip_line() {
    while (at_ < source_.size() && peek() != '\n') {
      if (peek() == '\\' && peek(1) == '\n') {
        ++line_;
        ++at_;
      }
      ++at_;
    }
  }

  // Records each line of a comment.
  void read_comment() {
    bool is_alone = fresh_;
    int line = line_;
    const bool is_block = peek(1) == '*';
    std::size_t begin = at_ += 2;
    if (is_block) {
      at_ = std::min(source_.find("*/", at_), source_.size());
      line_ += static_cast<int>(std::count(source_.begin() + begin, source_.begin() + at_, '\n'));
    } else {
      skip_line();
    }
    const std::size_t end = std::min(at_, source_.size());
    while (begin < end) {
      const std::size_t stop = std::min(end, source_.find('\n', begin));
      comments_.push_back({source_.substr(begin, stop - begin), line++, is_alone});
      is_alone = true;
      begin = stop + 1;
    }
    if (is_block) at_ = std::min(at_ + 2, source_.size());
  }

  static bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

  std::size_t end_of_name() const {
    std::size_t end = at_;
    while (end < source_.size() && is_of_name(source_[end])) ++end;
    return end;
  }

  void add(Token::Kind kind, std::size_t end) {
    tokens_.push_back({source_.substr(at_, end - at_), file_, line_, kind});
    at_ = end;
  }

  std::string_view source_, file_;
  QuoteEnds quote_ends_;
  std::vector<Token> tokens_;
  std::vector<Comment> comments_;
  std::size_t at_ = 0;
  int line_ = 1;
  bool fresh_ = true;  // only spaces since the line began
  bool in_define_ = false;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view source) { return Lexer(source).take_tokens(); }

std::vector<Comment> comments_of(std::string_view source) { return Lexer(source).take_comments(); }

std::optional<LineMarker> line_marker(std::string_view line) {
  const std::size_t quote = line.find('"'), end = line.rfind('"');
  if (!line.starts_with('#') || quote == line.npos) return std::nullopt;
  std::string_view number = line.substr(std::min(line.find_first_not_of(' ', 1), quote));
  if (number.starts_with("line ")) number.remove_prefix(5);
  LineMarker marker{0, line.substr(quote + 1, end > quote ? end - quote - 1 : line.npos)};
  const auto read = std::from_chars(number.data(), number.data() + number.size(), marker.line);
  return read.ec == std::errc() ? std::optional(marker) : std::nullopt;
}

std::optional<int> number_of(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  if (text.size() > kLongest) return std::nullopt;
  const std::string word(text);
  const bool binary = word.rfind("0b", 0) == 0 || word.rfind("0B", 0) == 0;
  const char* begin = word.c_str() + (binary ? 2 : 0);
  char* end = nullptr;
  const long value = std::strtol(begin, &end, binary ? 2 : 0);
  while (end && (*end == 'u' || *end == 'U' || *end == 'l' || *end == 'L')) ++end;
  if (end == begin || *end || value < 0 || value > 255) return std::nullopt;
  return static_cast<int>(value);
}

bool is_name(std::string_view word) {
  return is_of_name(word[0]) && !std::isdigit(static_cast<unsigned char>(word[0]));
}

std::map<std::string_view, int> constants_in(const std::vector<Token>& words) {
  std::map<std::string_view, int> found;
  std::set<std::string_view> several;
  for (std::size_t i = 0; i + 2 < words.size(); ++i) {
    const std::string_view name = words[i].text;
    if (!is_name(name)) continue;
    const std::string_view next = words[i + 1].text;
    const bool compares = next == "=" && words[i + 2].text == "=";
    const bool is_operator = next.size() == 1 && std::string_view("+-*/%&|^").find(next[0]) != next.npos;
    const bool shifts = (next == "<" || next == ">") && words[i + 2].text == next && i + 3 < words.size() &&
                        words[i + 3].text == "=";
    const bool counts = (is_operator && words[i + 2].text == "=") || shifts ||
                        ((next == "+" || next == "-") && words[i + 2].text == next);
    const bool counted = i > 1 && (words[i - 1].text == "+" || words[i - 1].text == "-") &&
                         words[i - 2].text == words[i - 1].text;
    const bool shared = i > 0 && words[i - 1].text == "&";
    // A parameter, a member or a local variable of the same name may have any value.
    const bool declared = i > 0 && is_name(words[i - 1].text) &&
                          (next == "," || next == ")" || next == ";" || next == ":" || next == "[");
    if (counts || counted || shared || declared) several.insert(name);
    if (next != "=" || compares) continue;
    const bool alone = i + 3 < words.size() && (words[i + 3].text == ";" || words[i + 3].text == ",");
    const auto value = alone ? number_of(words[i + 2].text) : std::nullopt;
    if (!value || !found.emplace(name, *value).second) several.insert(name);
  }
  for (const std::string_view name : several) found.erase(name);
  return found;
}

}  // namespace robosim::build
