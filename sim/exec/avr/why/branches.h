// Finds the branch that decides that an instruction runs. By the branch's other way, the program may return
// to it, or leave the function, without that instruction. Also finds what a branch has skipped.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "sim/avr/cpu.h"

namespace robosim::exec::avr {

class Branches {
 public:
  explicit Branches(const robosim::avr::Cpu& cpu);

  /// Returns whether there is a branch; addresses are in words.
  bool is_branch(std::uint32_t pc) const;
  /// Returns the registers that it writes, one bit each.
  std::uint32_t writes_of(std::uint32_t pc) const { return writes_[pc]; }
  /// Returns whether the branch decides about `pc`. `next`: where the branch, in the same function, has led.
  bool decides(std::uint32_t branch, std::uint32_t next, std::uint32_t pc);

  /// Effects of the branch's other way before it reaches the point where both ways meet.
  struct SkippedWrites {
    static constexpr std::uint32_t kInCaller = ~0u;
    std::uint32_t meets = kInCaller;
    std::uint32_t registers = 0;       ///< one bit each
    std::vector<std::uint16_t> bytes;  ///< of data memory, including writes of called functions; sorted
    /// Offsets by the pair of registers that points there, as at the branch. Called functions are not
    /// included.
    std::map<std::uint8_t, std::vector<std::uint8_t>> bytes_by_pointer;
  };
  /// Returns the effects of the other way. `next`: where the branch has led.
  const SkippedWrites& skipped_writes(std::uint32_t branch, std::uint32_t next);

 private:
  std::uint32_t led_to(std::uint32_t pc, std::int32_t by) const;
  /// Returns the function that is called there; nothing if there is no call, or its target is unknown.
  std::optional<std::uint32_t> called_at(std::uint32_t pc) const;
  /// Returns where execution continues in the same function; empty after a return, or if unknown.
  std::vector<std::uint32_t> ways_on(std::uint32_t pc) const;
  bool avoids(std::uint32_t from, std::uint32_t branch, std::uint32_t pc) const;
  /// Returns what can run from there before `end` and `stop`, the nearest first.
  std::vector<std::uint32_t> reached(std::uint32_t from, std::uint32_t end, std::uint32_t stop) const;
  bool leaves(std::uint32_t from, std::uint32_t branch, std::uint32_t pc) const;
  std::uint32_t meeting(std::uint32_t branch, std::uint32_t next, std::uint32_t other) const;
  void add_writes(const std::vector<std::uint32_t>& places, SkippedWrites& skipped_writes);
  void add_bytes_by_pointer(const std::vector<std::uint32_t>& places, SkippedWrites& skipped_writes);
  const std::vector<std::uint16_t>& bytes_of(std::uint32_t function);

  const robosim::avr::Cpu& cpu_;
  std::vector<std::uint32_t> writes_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, bool> known_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, SkippedWrites> skipped_writes_;
  std::map<std::uint32_t, std::vector<std::uint16_t>> bytes_of_;  ///< by the start of a function
};

}  // namespace robosim::exec::avr
