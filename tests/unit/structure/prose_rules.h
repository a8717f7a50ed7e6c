// Checks English, names and commits. Each rule is a function that returns its findings in a text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tests/unit/structure/prose_text.h"

namespace robosim::structure {

/// The longest sentence in words. A colon or semicolon also ends a sentence. The aim for new text is 20
/// words.
constexpr std::size_t kLongestSentence = 22;
/// The longest line of Markdown, in characters.
constexpr std::size_t kLongestLine = 100;
/// The longest subject of a commit, in characters.
constexpr std::size_t kLongestSubject = 72;

/// Returns a message for each phrase that has a plainer form, such as `again` for `anew`.
std::vector<std::string> odd_words(const Passage& passage);

/// Returns a message for each sentence of more than kLongestSentence words. A colon or semicolon also ends a
/// sentence. Numbers and text in parentheses are not counted. Rows and cells of tables are not sentences.
std::vector<std::string> long_sentences(const Passage& passage);

/// Returns a message if a comment opens with a fragment, such as `Whether …` or `The same.`.
std::vector<std::string> bare_openings(const Passage& passage);

/// Returns a message for each phrase of a string literal that error messages express in another form.
std::vector<std::string> odd_messages(const Passage& passage);

/// Returns a message for each line of Markdown that is too long. Does not report tables, code, and lines
/// without a space at which they could be broken.
std::vector<std::string> long_lines(const std::string& file, std::string_view markdown);

/// Returns a message if the name of a C++ file does not describe its content. Such a name is a bare
/// preposition, an adjective or a metaphor. `path` is relative to the checkout.
std::vector<std::string> odd_name(const std::string& path);

/// Returns a message for each fault of a commit's subject. Its form must be `area: Imperative summary`.
std::vector<std::string> odd_subject(const std::string& subject);

}  // namespace robosim::structure
