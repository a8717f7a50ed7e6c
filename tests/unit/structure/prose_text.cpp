#include "tests/unit/structure/prose_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace robosim::structure {
namespace {

constexpr std::size_t kRowIndent = 2;  // comment lines with a larger indentation are not prose
constexpr std::size_t kLeastWords = 3;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// Returns whether `c` belongs to a word: it is a letter, a digit, `_`, or a byte of a UTF-8 character.
bool is_word_char(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalnum(byte) || byte >= 0x80 || c == '_';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// Returns whether `text`, which begins with `<` and ends before `>`, is an HTML tag.
bool is_tag(std::string_view text) { return text.find(' ') == text.npos || text.find("=\"") != text.npos; }

/// Replaces `inline code`, and removes the targets of links, web addresses and HTML tags.
std::string without_code(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto skip_past = [&](char end) {
      const std::size_t to = text.find(end, i + 1);
      if (to == text.npos) return false;
      plain.append(static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(i),
                                                       text.begin() + static_cast<std::ptrdiff_t>(to), '\n')),
                   '\n');
      i = to;
      return true;
    };
    const std::size_t before = plain.size();
    if (c == '`' && skip_past('`')) {
      plain.insert(before, kCode);
    } else if (c == ']' && i + 1 < text.size() && text[i + 1] == '(') {
      ++i;
      skip_past(')');
    } else if (c == '<' && i + 1 < text.size() && (is_letter(text[i + 1]) || text[i + 1] == '/') &&
               is_tag(text.substr(i, text.find('>', i) - i)) && skip_past('>')) {
      plain.insert(before, " ");
    } else if (c == ':' && text.substr(i, 3) == "://") {
      while (i + 1 < text.size() && !is_space(text[i + 1])) ++i;
      while (std::string_view(".,:;!?)").find(text[i]) != std::string_view::npos) --i;  // not in the address
    } else {
      plain += c;
    }
  }
  return plain;
}

std::size_t count_words(std::string_view text) {
  std::size_t words = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (is_letter(text[i]) && (i == 0 || !is_word_char(text[i - 1]))) ++words;
  return words;
}

/// Collects lines into paragraphs.
class Collector {
 public:
  explicit Collector(std::string file) : file_(std::move(file)) {}

  void add(Passage::Kind kind, int line, std::string_view text) {
    if (!current_.text.empty() && current_.kind == kind) {
      current_.text += '\n';
      current_.text += text;
      return;
    }
    end();
    current_ = {file_, line, kind, opens_, std::string(text)};
  }
  /// Ends the current paragraph.
  void end() {
    if (current_.text.empty()) return;
    current_.text = without_code(current_.text);
    found.push_back(std::exchange(current_, {}));
    opens_ = false;
  }
  /// Ends the current paragraph, and marks the next one as the first of a comment.
  void end_comment() {
    end();
    opens_ = true;
  }
  void single(Passage::Kind kind, int line, std::string_view text) {
    end();
    found.push_back({file_, line, kind, true, without_code(text)});
  }

  std::vector<Passage> found;

 private:
  std::string file_;
  Passage current_;
  bool opens_ = true;
};

/// Adds a line of a comment. `text` is the line without its marker.
void add_comment_line(Collector& collector, int line, std::string_view text) {
  const std::size_t indent = text.find_first_not_of(' ');
  if (indent == text.npos || text.find_first_of("*=~", indent) == indent) return collector.end();
  if (indent > kRowIndent || text.substr(indent).find("  ") != text.npos) {
    collector.end();
    collector.add(Passage::Kind::row, line, trimmed(text));
    collector.end();
  } else if (text.substr(indent, 2) == "- ") {
    collector.end();
    collector.add(Passage::Kind::comment, line, trimmed(text.substr(indent + 2)));
  } else {
    collector.add(Passage::Kind::comment, line, trimmed(text));
  }
}

/// Reads a source character by character.
class SourceReader {
 public:
  SourceReader(const std::string& file, std::string_view source, bool with_messages)
      : collector_(file), source_(source), with_messages_(with_messages) {}

  std::vector<Passage> read() {
    while (at_ < source_.size()) {
      const char c = source_[at_];
      if (c == '\n') {
        if (!only_space_ || !in_comment_) collector_.end_comment();
        in_comment_ = false;
        only_space_ = true;
        ++line_;
        ++at_;
      } else if (source_.substr(at_, 2) == "//") {
        line_comment();
      } else if (source_.substr(at_, 2) == "/*") {
        skip_to(source_.find("*/", at_ + 2), 2);
      } else if (c == '"') {
        literal();
      } else if (c == '\'') {
        character();
      } else {
        if (!is_space(c)) end_line_of_code();
        ++at_;
      }
    }
    end_literal();
    collector_.end();
    return std::move(collector_.found);
  }

 private:
  void end_line_of_code() {
    only_space_ = false;
    end_literal();
  }
  void line_comment() {
    const std::size_t end = std::min(source_.find('\n', at_), source_.size());
    std::string_view text = source_.substr(at_, end - at_);
    // True if the comment is "///< …", or continues the comment that follows code on the previous line.
    const std::size_t column = at_ - (source_.rfind('\n', at_) + 1);
    const bool continues = (text.find('<') != text.npos && text.find('<') == text.find_first_not_of('/')) ||
                           (column == remark_column_ && line_ == remark_line_ + 1);
    text.remove_prefix(std::min(text.find_first_not_of("/!<"), text.size()));
    const bool is_note = text.find("NOLINT") != text.npos || trimmed(text).substr(0, 10) == "namespace " ||
                         trimmed(text).substr(0, 8) == "extern \"" ||
                         trimmed(text).substr(0, 12) == "clang-format";
    if (is_note) {
      collector_.end_comment();
    } else if (only_space_ && !continues) {
      add_comment_line(collector_, line_, text);
      in_comment_ = true;
    } else {
      collector_.single(Passage::Kind::remark, line_, trimmed(text));
      remark_line_ = line_;
      remark_column_ = column;
    }
    at_ = end;
  }
  void character() {
    only_space_ = false;
    const bool is_separator = at_ > 0 && std::isalnum(static_cast<unsigned char>(source_[at_ - 1])) != 0;
    std::size_t end = at_ + 1;  // the end of a separator, as in 1'000
    if (!is_separator) {
      if (end < source_.size() && source_[end] == '\\') ++end;
      end = std::min(source_.find('\'', end + 1), source_.size() - 1) + 1;
    }
    end_literal();
    at_ = end;
  }
  void literal() {
    only_space_ = false;
    if (at_ > 0 && source_[at_ - 1] == 'R') {
      const std::size_t open = std::min(source_.find('(', at_), source_.size());
      const std::string close = ")" + std::string(source_.substr(at_ + 1, open - at_ - 1)) + "\"";
      end_literal();
      return skip_to(source_.find(close, open), close.size());
    }
    if (literal_.empty()) literal_line_ = line_;
    for (++at_; at_ < source_.size() && source_[at_] != '"'; ++at_) {
      if (source_[at_] == '\\' && at_ + 1 < source_.size()) {
        const char escaped = source_[++at_];
        literal_ += escaped == 'n' ? '\n' : escaped == 't' ? ' ' : escaped;
      } else {
        literal_ += source_[at_];
      }
    }
    ++at_;
  }
  void end_literal() {
    const std::string text = std::exchange(literal_, "");
    if (!with_messages_) return;
    for (const std::string_view line : lines_of(text))
      if (count_words(line) >= kLeastWords) collector_.single(Passage::Kind::message, literal_line_, line);
  }
  void skip_to(std::size_t end, std::size_t size) {
    end = end == source_.npos ? source_.size() : end + size;
    line_ += static_cast<int>(std::count(source_.begin() + static_cast<std::ptrdiff_t>(at_),
                                         source_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    at_ = end;
  }

  Collector collector_;
  std::string_view source_;
  bool with_messages_;
  std::size_t at_ = 0;
  int line_ = 1;
  bool only_space_ = true;   // until here, this line has only spaces
  bool in_comment_ = false;  // the current line is a comment
  int remark_line_ = -1;     // line of the last comment after code
  std::size_t remark_column_ = 0;
  std::string literal_;
  int literal_line_ = 0;
};

/// Replaces quotes, arrows and other symbols that are not ASCII with spaces. Replaces a middle dot, which
/// separates items, with a semicolon. Does not change letters with accents.
std::string without_symbols(std::string_view utf8) {
  std::string text(utf8);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const std::size_t size = byte == 0xC2 ? 2 : byte == 0xE2 ? 3 : 0;  // U+0080 to 00BF, U+2000 to 2FFF
    const bool is_middle_dot = utf8.substr(i, 2) == "\xC2\xB7";
    for (std::size_t k = i; k < std::min(i + size, text.size()); ++k) text[k] = ' ';
    if (is_middle_dot) text[i] = ';';
  }
  return text;
}

/// Returns whether the full stop at `at` belongs to an abbreviation. `last` is the word before the full stop.
/// A single letter is an abbreviation if a lower-case letter follows.
bool is_abbreviation(std::string_view text, const Token* last, std::size_t at) {
  static constexpr std::array<std::string_view, 11> kAll = {"e.g", "i.e", "etc", "vs",  "cf",    "no",
                                                            "rev", "sec", "al",  "fig", "approx"};
  if (!last || !last->is_word || last->at + last->text.size() != at) return false;
  if (last->text.size() == 1 && is_letter(last->text.front())) {
    const std::size_t next = text.find_first_not_of(" \n", at + 1);
    return next != text.npos && std::islower(static_cast<unsigned char>(text[next])) != 0;
  }
  return std::find(kAll.begin(), kAll.end(), last->text) != kAll.end();
}

}  // namespace

std::string Passage::place(std::size_t at) const {
  const auto breaks = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  return fmt::format("{}:{}", file, line + breaks);
}

std::vector<Passage> passages_of_document(const std::string& file, std::string_view markdown) {
  Collector collector(file);
  int number = 0;
  bool in_code = false;
  for (const std::string_view line : lines_of(markdown)) {
    ++number;
    std::string_view text = trimmed(line);
    if (text.substr(0, 3) == "```") {
      in_code = !in_code;
      collector.end();
    } else if (in_code || text.empty() || text.substr(0, 4) == "<!--") {
      collector.end();
    } else if (text[0] == '#') {
      collector.single(Passage::Kind::cell, number, text.substr(text.find_first_not_of('#')));
    } else if (text[0] == '|') {
      for (text.remove_prefix(1); !text.empty();) {
        const std::size_t end = std::min(text.find('|'), text.size());
        collector.single(Passage::Kind::cell, number, trimmed(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
      }
    } else {
      const std::size_t item = text.find(' ');
      const std::string_view mark = text.substr(0, std::min(item, text.size()));
      const bool is_item =
          mark == "-" || mark == "*" || mark == ">" ||
          (mark.size() > 1 && mark.back() == '.' && mark.find_first_not_of("0123456789.") == mark.npos);
      if (is_item) collector.end();
      collector.add(Passage::Kind::document, number, is_item ? trimmed(text.substr(mark.size())) : text);
    }
  }
  collector.end();
  return std::move(collector.found);
}

std::vector<Passage> passages_of_source(const std::string& file, std::string_view source,
                                        bool with_messages) {
  return SourceReader(file, source, with_messages).read();
}

std::vector<Passage> passages_of_script(const std::string& file, std::string_view script) {
  Collector collector(file);
  int number = 0;
  for (const std::string_view line : lines_of(script)) {
    ++number;
    const std::string_view text = trimmed(line);
    if (text.empty() || text[0] != '#' || text.substr(0, 2) == "#!")
      collector.end_comment();
    else
      add_comment_line(collector, number, text.substr(1));
  }
  collector.end();
  return std::move(collector.found);
}

std::vector<std::vector<Token>> sentences(std::string_view utf8) {
  const std::string text = without_symbols(utf8);
  std::vector<std::vector<Token>> all(1);
  const auto end_sentence = [&] {
    if (!all.back().empty()) all.emplace_back();
  };
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (is_space(c)) {
      ++i;
    } else if (is_word_char(c)) {
      std::size_t end = i + 1;
      const auto joins = [&](char mark) {  // marks within words: robot's, cross-track, e.g, 0.5, main.cpp
        return (mark == '\'' || mark == '-' || mark == '.' || mark == '/') && end + 1 < text.size() &&
               is_word_char(text[end + 1]);
      };
      while (end < text.size() && (is_word_char(text[end]) || joins(text[end]))) ++end;
      Token token{text.substr(i, end - i), i, true};
      std::transform(token.text.begin(), token.text.end(), token.text.begin(),
                     [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
      all.back().push_back(std::move(token));
      i = end;
    } else {
      const bool ends =
          c == '!' || c == '?' ||
          (c == '.' && !is_abbreviation(text, all.back().empty() ? nullptr : &all.back().back(), i));
      all.back().push_back({std::string(1, c), i, false});
      ++i;
      if (!ends) continue;
      while (i < text.size() && (text[i] == '"' || text[i] == ')' || text[i] == '*')) ++i;
      if (i == text.size() || is_space(text[i])) end_sentence();
    }
  }
  if (all.back().empty()) all.pop_back();
  return all;
}

}  // namespace robosim::structure
