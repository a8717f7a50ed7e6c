// Splits documents, sources and scripts into passages of prose, and passages into sentences of tokens.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::structure {

/// A paragraph of a document or comment, or a line of a string literal. kCode replaces inline code.
struct Passage {
  enum class Kind {
    document,  ///< a paragraph of a Markdown file
    cell,      ///< a table's cell or a heading of a Markdown file
    comment,   ///< a paragraph of a comment on lines of its own
    row,       ///< an indented line of a comment: a table, formula, list or picture
    remark,    ///< a comment after code on the same line
    message    ///< a line of a string literal, of three words or more
  };

  std::string file;
  int line = 0;  ///< line of the first character
  Kind kind = Kind::document;
  bool opens = false;  ///< the passage is the first paragraph of a comment
  std::string text;    ///< with the line breaks of the file

  /// Returns "file:line" of a position in the text.
  std::string place(std::size_t at) const;
};

constexpr std::string_view kCode = "_";

std::vector<Passage> passages_of_document(const std::string& file, std::string_view markdown);

/// Returns the comments of a C++ source. If `with_messages` is true, also returns string literals. Joins
/// adjacent literals. Skips raw literals, and comments that disable lints.
std::vector<Passage> passages_of_source(const std::string& file, std::string_view source, bool with_messages);

/// Returns the comments of a script, which begin with `#`.
std::vector<Passage> passages_of_script(const std::string& file, std::string_view script);

/// A word in lower case, or a punctuation mark.
struct Token {
  std::string text;
  std::size_t at = 0;  ///< position in the passage's text
  bool is_word = false;
};

/// Returns the tokens of each sentence. A sentence ends at `.`, `!` or `?` before a space or the end of the
/// text, except after abbreviations.
std::vector<std::vector<Token>> sentences(std::string_view text);

}  // namespace robosim::structure
