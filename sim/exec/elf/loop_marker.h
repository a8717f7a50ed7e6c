// Finds where to count the rounds of a program's endless loop: those of loop(), or of the for (;;) of a
// main() in the sketch.
//
// A round is a path through the loop's code and back. Inner loops share that code, and often even its first
// instruction: `for (;;) { while (!ready) {} work(); }` jumps to the same place from two. So this looks for
// an instruction that runs exactly once in each round:
//
//   if loop() is inlined   one on each path over main()'s own code, and on no path that stays inside loop().
//                          That code is identified by its calls and branches: the compiler may attribute to
//                          main() what is only computed inside loop(). Loops that never return to main()'s
//                          code are a part of the round that they end
//   otherwise              the head of the loop, if one jump leads back there, and if by the lines of the
//                          source no inner loop is as long as the whole
//
// If there is none, nothing is counted: `if (a) { …; continue; }` and `while (a) { … }` may be the same
// machine code, and only debug information distinguishes them.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace robosim::exec {

/// An instruction, reduced to its effect on the order of execution.
struct Step {
  std::vector<std::uint32_t> next;  ///< the possible next ones within the function; calls return
  enum class Kind { other, jump, call_or_branch };
  Kind kind = Kind::other;  ///< jump: no other effect
};
using Steps = std::map<std::uint32_t, Step>;  ///< by address

/// Addresses of instructions.
struct LoopMarks {
  std::vector<std::uint32_t> first;  ///< the first round begins with one of these
  std::vector<std::uint32_t> each;   ///< one of these runs in each round; empty = unknown
};

/// Returns whether an instruction is a part of loop().
using Inside = std::function<bool(std::uint32_t)>;
/// Returns the line in the function itself, which may have called an inlined one there; 0 = unknown.
using LineOf = std::function<int(std::uint32_t)>;

/// Returns the endless loops of a function that begins at `entry`: those that run instructions `inside`
/// loop(), or without `inside` all that never end.
LoopMarks loop_marks_of(const Steps& function, std::uint32_t entry, const Inside& inside, const LineOf& line);

}  // namespace robosim::exec
