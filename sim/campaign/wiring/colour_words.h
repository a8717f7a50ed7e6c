// Finds black, white and the line in words, in the languages of published sketches.
#pragma once

#include "sim/campaign/wiring/name_words.h"

namespace robosim::wiring {

bool is_black(const std::string& word);
bool is_white(const std::string& word);
bool is_line(const std::string& word);

/// Returns 1 for black, -1 for white, 0 for neither or both.
int colour_of(const WordList& words);
/// Returns 1 if the words name the line, -1 if they negate it: off line, perdida.
int line_of(const WordList& words);
/// Returns line_of() of a sentence, or 0 unless it says that something is on the line, sees it, or loses it.
int line_in_sentence(const WordList& words);
/// Returns whether the words contain "white line", in either order.
bool has_white_line(const WordList& words);
bool has_black_line(const WordList& words);
/// Returns whether the words tell the reader what to change: "use HIGH for a white line".
bool is_instruction(const WordList& words);
/// Returns whether the words state a condition: "if the line is white".
bool is_condition(const WordList& words);
/// Returns 1 for HIGH, alto, 1; -1 for LOW, bajo, 0; 0 for other words.
int level_of_word(const std::string& word);

}  // namespace robosim::wiring
