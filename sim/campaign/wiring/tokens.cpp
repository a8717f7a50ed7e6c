#include "sim/campaign/wiring/tokens.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>
#include <utility>

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

  std::vector<Comment> comments() {
    run();
    return std::move(comments_);
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
      const std::size_t begin = at_ + 2;
      const int line = line_;
      skip_line();
      add_comment(begin, at_, line);
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
    const std::size_t begin = at_;
    const int line = line_;
    while (at_ < source_.size() && !(peek() == '*' && peek(1) == '/')) {
      if (peek() == '\n') ++line_;
      ++at_;
    }
    add_comment(begin, at_, line);
    at_ = std::min(at_ + 2, source_.size());
  }

  // Records each line of a comment.
  void add_comment(std::size_t begin, std::size_t end, int line) {
    bool is_alone = fresh_;
    while (begin < end) {
      const std::size_t stop = std::min(end, source_.find('\n', begin));
      comments_.push_back({source_.substr(begin, stop - begin), line++, is_alone});
      is_alone = true;
      begin = stop + 1;
    }
  }

  void add(Token::Kind kind, std::string text) { tokens_.push_back({kind, std::move(text), line_}); }

  const std::string& source_;
  std::vector<Token> tokens_;
  std::vector<Comment> comments_;
  std::size_t at_ = 0;
  int line_ = 1;
  bool fresh_ = true;  // only spaces since the line began
  bool in_define_ = false;
};

// Splits the word pin off a word that begins or ends with it: pinena, enapin.
void split_pin(std::vector<std::string>& words) {
  static const std::set<std::string> kWhole = {"ping",   "pinza", "pink", "pins",
                                               "pinion", "spin",  "pino", "pini"};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string word = words[i];
    if (word.size() <= 3 || kWhole.count(word) != 0) continue;
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i);
    if (word.starts_with("pin")) {
      words[i] = word.substr(3);
      words.insert(words.begin() + at, "pin");
      ++i;
    } else if (word.ends_with("pin")) {
      words[i] = word.substr(0, word.size() - 3);
      words.insert(words.begin() + at + 1, "pin");
      ++i;
    }
  }
}

}  // namespace

std::vector<Token> tokens_of(const std::string& source) { return Lexer(source).run(); }

std::vector<std::string> words_of_text(const std::string& text) {
  // Letters with accents in UTF-8, and the plain letters.
  static const std::vector<std::pair<const char*, const char*>> kAccents = {
      {"á", "a"}, {"à", "a"}, {"â", "a"}, {"ã", "a"}, {"ä", "a"}, {"é", "e"}, {"è", "e"}, {"ê", "e"},
      {"í", "i"}, {"ì", "i"}, {"ı", "i"}, {"ó", "o"}, {"ò", "o"}, {"ô", "o"}, {"õ", "o"}, {"ö", "o"},
      {"ú", "u"}, {"ù", "u"}, {"ü", "u"}, {"ñ", "n"}, {"ç", "c"}, {"ğ", "g"}, {"ş", "s"}, {"ß", "ss"},
      {"É", "e"}, {"Ç", "c"}, {"İ", "i"}, {"Ş", "s"}, {"Ö", "o"}, {"Ü", "u"}, {"Í", "i"}, {"Ó", "o"}};
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < text.size();) {
    const auto accent = std::find_if(kAccents.begin(), kAccents.end(), [&](const auto& one) {
      return text.compare(i, std::string_view(one.first).size(), one.first) == 0;
    });
    if (accent != kAccents.end()) {
      words.back() += accent->second;
      i += std::string_view(accent->first).size();
    } else {
      if (is_letter(text[i]) || is_digit(text[i]))
        words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(text[i])));
      else if (!words.back().empty())
        words.emplace_back();
      ++i;
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::vector<std::string> includes_of(const std::string& source) {
  static const std::string kInclude = "#include \"";
  std::vector<std::string> names;
  for (std::size_t at = source.find(kInclude); at != std::string::npos; at = source.find(kInclude, at + 1)) {
    const std::size_t begin = at + kInclude.size(), end = source.find_first_of("\"\n", begin);
    const bool is_first = at == 0 || source[at - 1] == '\n';
    if (is_first && end != std::string::npos && source[end] == '"')
      names.push_back(source.substr(begin, end - begin));
  }
  return names;
}

std::vector<Comment> comments_of(const std::string& source) { return Lexer(source).comments(); }

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
  split_pin(words);
  return words;
}

}  // namespace robosim::wiring
