// Where to count the rounds of a program's endless loop: those of loop(), or of the for (;;) of a main() of
// its own.
//
// A round is a way through the loop's code and back. Loops within share that code, and often even its first
// instruction: `for (;;) { while (!ready) {} work(); }` jumps to the same place from two. So an instruction
// is looked for that runs exactly once in each round:
//
//   where loop() is inlined    one that each way over main()'s own code passes, and no way that stays inside
//                              loop(). That code is told by its calls and branches: what is only computed
//                              inside loop() may be laid to main() by the compiler. Loops that never come
//                              back to main()'s code are a part of the round that they end
//   otherwise                  the head of the loop, if one jump leads back there, and by the lines of the
//                              source no loop within is as long as the whole
//
// Where there is none, nothing is counted: `if (a) { …; continue; }` and `while (a) { … }` may be the same
// machine code, and only debug information tells them apart.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace robosim::exec {

/// An instruction, as far as the order of execution goes.
struct Step {
  std::vector<std::uint32_t> next;  ///< where it goes on within the function; calls come back
  enum class Kind { other, jump, call_or_branch };
  Kind kind = Kind::other;  ///< jump: nothing but that
};
using Steps = std::map<std::uint32_t, Step>;  ///< by address

/// Addresses of instructions.
struct Rounds {
  std::vector<std::uint32_t> first;  ///< with one of these the first round begins
  std::vector<std::uint32_t> each;   ///< one of these runs in each round; empty = that cannot be told
};

/// Whether an instruction is a part of loop().
using Inside = std::function<bool(std::uint32_t)>;
/// Of the function itself, which may have called an inlined one there; 0 = not known.
using LineOf = std::function<int(std::uint32_t)>;

/// Of the endless loops of a function that begins at `entry`: those that run instructions `inside` loop(), or
/// without `inside` all that never end.
Rounds rounds_of(const Steps& function, std::uint32_t entry, const Inside& inside, const LineOf& line);

}  // namespace robosim::exec
