// Finds the possible changes in a sketch: mutations, which are modelled on typical mistakes, and neutral
// changes.
#pragma once

#include <vector>

#include "sim/campaign/mutate/mutation.h"
#include "sim/campaign/mutate/syntax.h"

namespace robosim::mutate {

/// Returns all mutations, sorted by place. Text in macros is not changed.
///
///   relational  < <= > >= == != one for another      returned   0 or the contrary instead of a result
///   arithmetic  + - * / % & | << >> and += …, ++ --  arguments  two of one type exchanged
///   logic       && || !, true and false              type       16 bits for 32, 8 for 16, int for float
///   constant    one more, one less, twice            storage    volatile, const, PROGMEM or F() removed
///   statement   a call, assignment, break or return removed
std::vector<Mutation> mutations(const Tree& tree);

/// Returns neutral changes, which a test must tolerate. Examples are a short delay at the start of setup(),
/// two independent pinMode() calls exchanged, and a renamed local variable.
std::vector<Mutation> controls(const Tree& tree);

}  // namespace robosim::mutate
