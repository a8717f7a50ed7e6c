// What can be changed in a sketch: the operators of mutation testing, each as people's mistakes have it, and
// changes that must not matter.
#pragma once

#include <vector>

#include "sim/mutate/mutation.h"
#include "sim/mutate/syntax.h"

namespace robosim::mutate {

/// All of them, in the order of their places. What stands in a macro is left as it is.
///
///   relational  < <= > >= == != one for another      returned   0 or the contrary in place of a result
///   arithmetic  + - * / % & | << >> and += …, ++ --  arguments  two of one type in each other's place
///   logic       && || !, true and false              type       16 bits for 32, 8 for 16, int for float
///   constant    one more, one less, twice            storage    volatile, const, PROGMEM or F() lost
///   statement   a call, assignment, break or return left out
std::vector<Mutation> mutations(const Tree& tree);

/// Neutral ones, which a test must not mind: a delay of some ms at the start of setup(), two independent
/// pinMode() in each other's place, a local variable with another name.
std::vector<Mutation> controls(const Tree& tree);

}  // namespace robosim::mutate
