// Splits names and texts into words. Finds left, right, forward and backward in them, in the languages of
// published sketches.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::wiring {

using WordList = std::vector<std::string>;  ///< words of a name or of a comment, in lower case

/// Returns the words of a text in lower case, without accents: "Sağ motor" is sag, motor.
WordList words_of_text(std::string_view text);
/// Returns the words of a name, in lower case: "leftMotor_EN1" is left, motor, en, 1. Also separates `pin` if
/// no capital letter or `_` marks its end: PINENA is pin, ena.
WordList words_of(std::string_view name);

enum class Side { unknown, left, right };

/// Returns the side that the words spell out, also as an abbreviation: left, rm, izquierda, esq, gauche,
/// rechts, sx, sag …
Side spelled_side(const WordList& words);
/// Returns the side that the words spell out, or unknown if they spell out both.
Side only_side(const WordList& words);
/// Returns spelled_side(). For other names, returns a side by convention. The first motor or channel counts
/// as left (ENA, motor1), the second as right (motorB, IN3, m21). Only a run can confirm a convention.
Side side_of(const WordList& words);

/// Returns whether any of the words starts with any of the beginnings.
bool says(const WordList& words, std::initializer_list<const char*> beginnings);

bool says_forward(const WordList& words);
bool says_backward(const WordList& words);

/// Returns whether a function of this name drives forward: moveForward, adelante, ileri.
bool function_goes_forward(const WordList& words);
bool function_goes_backward(const WordList& words);
/// Returns the side to which a function of this name turns: turnLeft, derecha, sola.
Side turn_of_function(const WordList& words);

/// Returns whether any word means a motor or a wheel.
bool names_motor(const WordList& words);

}  // namespace robosim::wiring
