// Finds instructions that mark the rounds of a program's endless loop. The loop is loop(), or the for (;;) in
// a main() that the sketch defines.
//
// A round is a path through the loop's code and back to the loop's beginning. An inner loop may begin at the
// same instruction: in `for (;;) { while (!ready) {} work(); }`, two loops jump to the first instruction.
// Therefore the mark is an instruction that runs exactly once in each round:
//
//   if loop() is inlined   an instruction that is on each path through main()'s own code, but on no path that
//                          stays inside loop(). main()'s code is identified by its calls and branches, since
//                          the compiler may attribute computations inside loop() to main(). A loop inside
//                          loop() that never returns to main()'s code is a part of the last round
//   otherwise              the head of the loop. Only one jump may lead back to the head, and no inner loop
//                          may span the same source lines as the whole loop
//
// If no such instruction is found, rounds are not counted. Source lines are compared because `if (a) { …;
// continue; }` and `while (a) { … }` may be the same machine code.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace robosim::exec {

/// The effect of an instruction on the control flow.
struct Step {
  std::vector<std::uint32_t> next;  ///< possible next instructions in the function; calls are stepped over
  enum class Kind { other, jump, call_or_branch };
  Kind kind = Kind::other;  ///< `jump` = an unconditional jump without any other effect
};
using Steps = std::map<std::uint32_t, Step>;  ///< indexed by address

/// Addresses of instructions that mark rounds of a loop.
struct LoopMarks {
  std::vector<std::uint32_t> first;  ///< the first round begins at one of these instructions
  std::vector<std::uint32_t> each;   ///< one of these instructions runs in each round; empty = unknown
};

/// Returns whether an instruction belongs to loop().
using Inside = std::function<bool(std::uint32_t)>;
/// Returns an instruction's line in the function itself; 0 = unknown. For inlined code, returns the line of
/// the inlined call.
using LineOf = std::function<int(std::uint32_t)>;

/// Returns the marks of the endless loops in a function that begins at `entry`. With `inside`, these are the
/// loops that run instructions of loop(). Without `inside`, these are the loops that never end and have an
/// effect.
LoopMarks loop_marks_of(const Steps& function, std::uint32_t entry, const Inside& inside, const LineOf& line);

}  // namespace robosim::exec
