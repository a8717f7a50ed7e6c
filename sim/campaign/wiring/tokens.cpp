#include "sim/campaign/wiring/tokens.h"

#include <cctype>

namespace robosim::wiring {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

class Lexer {
 public:
  explicit Lexer(const std::string& source) : source_(source) {}

  std::vector<Token> run() {
    while (at_ < source_.size()) step();
    end_define();
    return std::move(tokens_);
  }

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
    } else if (c == '/' && peek(1) == '/') {
      skip_line();
    } else if (c == '/' && peek(1) == '*') {
      skip_comment();
    } else if (c == '#' && fresh_) {
      directive();
    } else {
      fresh_ = false;
      token(c);
    }
  }

  void token(char c) {
    const std::size_t begin = at_;
    if (is_letter(c) || is_digit(c)) {
      while (is_letter(peek()) || is_digit(peek())) ++at_;
      add(is_letter(c) ? Token::Kind::word : Token::Kind::number, source_.substr(begin, at_ - begin));
    } else if (c == '"' || c == '\'') {
      quoted(c);
    } else {
      ++at_;
      add(Token::Kind::punctuation, std::string(1, c));
    }
  }

  void quoted(char quote) {
    const std::size_t begin = ++at_;
    while (at_ < source_.size() && peek() != quote && peek() != '\n') at_ += peek() == '\\' ? 2 : 1;
    at_ = std::min(at_, source_.size());
    add(Token::Kind::text, source_.substr(begin, at_ - begin));
    if (peek() == quote) ++at_;
  }

  void directive() {
    static const std::string kDefine = "define";
    fresh_ = false;
    ++at_;
    while (peek() == ' ' || peek() == '\t') ++at_;
    if (source_.compare(at_, kDefine.size(), kDefine) != 0 || is_letter(peek(kDefine.size()))) {
      skip_line();
      return;
    }
    at_ += kDefine.size();
    while (peek() == ' ' || peek() == '\t') ++at_;
    const std::size_t begin = at_;
    while (is_letter(peek()) || is_digit(peek())) ++at_;
    add(Token::Kind::define, source_.substr(begin, at_ - begin));
    in_define_ = true;
  }

  void end_define() {
    if (in_define_) add(Token::Kind::punctuation, kEndOfDefine);
    in_define_ = false;
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

  void skip_comment() {
    at_ += 2;
    while (at_ < source_.size() && !(peek() == '*' && peek(1) == '/')) {
      if (peek() == '\n') ++line_;
      ++at_;
    }
    at_ = std::min(at_ + 2, source_.size());
  }

  void add(Token::Kind kind, std::string text) { tokens_.push_back({kind, std::move(text), line_}); }

  const std::string& source_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int line_ = 1;
  bool fresh_ = true;  // only spaces since the line began
  bool in_define_ = false;
};

}  // namespace

std::vector<Token> tokens_of(const std::string& source) { return Lexer(source).run(); }

std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (!is_letter(c) && !is_digit(c)) continue;
    if (c == '_') continue;
    const char before = i > 0 ? name[i - 1] : '_';
    const bool turns = is_upper(c) && (!is_upper(before) || (i + 1 < name.size() && is_letter(name[i + 1]) &&
                                                             name[i + 1] != '_' && !is_upper(name[i + 1])));
    if (before == '_' || is_digit(c) != is_digit(before) || turns) words.emplace_back();
    if (words.empty()) words.emplace_back();
    words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return words;
}

}  // namespace robosim::wiring
