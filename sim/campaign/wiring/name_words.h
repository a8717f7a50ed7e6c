// Finds left, right, forward and backward in the words of a pin's name, in the languages of published
// sketches.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

namespace robosim::wiring {

enum class Side { unknown, left, right };

/// Returns the side that the words spell out, also as an abbreviation: left, rm, izquierda, esq, gauche,
/// rechts, sx, sag …
Side spelled_side(const std::vector<std::string>& words);
/// Returns the side that the words spell out, or unknown if they spell out both.
Side only_side(const std::vector<std::string>& words);
/// Returns spelled_side(), or a side by convention for other names: the first of numbered motors and channels
/// counts as left (ENA, IN3, motorB, M2, m21). Only a run can confirm a convention.
Side side_of(const std::vector<std::string>& words);

/// Returns whether any of the words starts with any of the beginnings.
bool says(const std::vector<std::string>& words, std::initializer_list<const char*> beginnings);

bool says_forward(const std::vector<std::string>& words);
bool says_backward(const std::vector<std::string>& words);

/// Returns whether a function of this name drives forward: moveForward, adelante, ileri.
bool function_goes_forward(const std::vector<std::string>& words);
bool function_goes_backward(const std::vector<std::string>& words);
/// Returns the side to which a function of this name turns: turnLeft, derecha, sola.
Side turn_of_function(const std::vector<std::string>& words);

/// Returns whether any word means a motor or a wheel.
bool names_motor(const std::vector<std::string>& words);

}  // namespace robosim::wiring
