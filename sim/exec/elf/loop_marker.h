// Finds the instructions at which to count rounds of a program's endless loop: of loop(), or of the for (;;)
// in a sketch's own main().
//
// A round is a path through the loop's code and back. Inner loops share that code, and often even its first
// instruction: `for (;;) { while (!ready) {} work(); }` jumps to the same place from two loops. Therefore an
// instruction is chosen that runs exactly once in each round:
//
//   if loop() is inlined   an instruction on each path through main()'s own code, and on no path that stays
//                          inside loop(). main()'s code is identified by its calls and branches, since the
//                          compiler may attribute computations inside loop() to main(). A loop that never
//                          returns to main()'s code is not counted: it is a part of the last round
//   otherwise              the head of the loop, if only one jump leads back to it, and no inner loop spans
//                          the same source lines as the whole loop
//
// If no such instruction is found, nothing is counted. Source lines are compared because `if (a) { …;
// continue; }` and `while (a) { … }` may be the same machine code.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace robosim::exec {

/// An instruction, reduced to its effect on the order of execution.
struct Step {
  std::vector<std::uint32_t> next;  ///< possible next instructions in the function, also after a call
  enum class Kind { other, jump, call_or_branch };
  Kind kind = Kind::other;  ///< `jump`: has no effect except the jump
};
using Steps = std::map<std::uint32_t, Step>;  ///< indexed by address

/// Addresses of instructions that mark rounds of a loop.
struct LoopMarks {
  std::vector<std::uint32_t> first;  ///< the first round begins with one of them
  std::vector<std::uint32_t> each;   ///< one of them runs in each round; empty = unknown
};

/// Returns whether an instruction belongs to loop().
using Inside = std::function<bool(std::uint32_t)>;
/// Returns an instruction's line in the function itself: for inlined code, the line of the call. 0 = unknown.
using LineOf = std::function<int(std::uint32_t)>;

/// Returns the marks of the endless loops of a function that begins at `entry`. With `inside`, these are the
/// loops that run instructions of loop(). Without it, these are the loops that never end and have an effect.
LoopMarks loop_marks_of(const Steps& function, std::uint32_t entry, const Inside& inside, const LineOf& line);

}  // namespace robosim::exec
