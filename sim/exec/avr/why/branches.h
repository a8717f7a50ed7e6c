// Finds the branches that decide whether an instruction runs (control dependence). One path of such a branch
// leads to the instruction. Another path skips it, and then returns to the branch or leaves the function.
// Also finds the writes that a branch has skipped.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "sim/mcu/avr/cpu.h"

namespace robosim::exec::avr {

class Branches {
 public:
  explicit Branches(const robosim::avr::Cpu& cpu);

  /// Returns whether the instruction at word address `pc` is a branch.
  bool is_branch(std::uint32_t pc) const;
  /// Returns the registers that the instruction at `pc` writes, one bit each.
  std::uint32_t writes_of(std::uint32_t pc) const { return writes_[pc]; }
  /// Returns whether the branch has decided that the instruction at `pc` runs. `next` is the address to which
  /// the branch has led, in the same function.
  bool decides(std::uint32_t branch, std::uint32_t next, std::uint32_t pc);

  /// The writes on the path that a branch has not taken, up to the address `meets`, where the paths meet.
  /// kInCaller = the paths meet after the function has returned.
  struct SkippedWrites {
    static constexpr std::uint32_t kInCaller = ~0u;
    std::uint32_t meets = kInCaller;
    std::uint32_t registers = 0;       ///< written registers, one bit each
    std::vector<std::uint16_t> bytes;  ///< sorted addresses of bytes that the path or its calls write
    /// The bytes that are written through pointers, as offsets from the pointer's value at the branch. The
    /// key is the pointer register. Writes by called functions are not included.
    std::map<std::uint8_t, std::vector<std::uint8_t>> bytes_by_pointer;
  };
  /// Returns the writes that the branch has skipped. `next` is the address to which the branch has led.
  const SkippedWrites& skipped_writes(std::uint32_t branch, std::uint32_t next);

 private:
  std::uint32_t words() const { return static_cast<std::uint32_t>(cpu_.flash().size() / 2); }
  /// Returns the address of the function that is called at `pc`. Returns nullopt if the instruction is not a
  /// call, or if the function is unknown.
  std::optional<std::uint32_t> called_at(std::uint32_t pc) const;
  /// Returns the addresses at which execution can continue in the same function. The result is empty for a
  /// return, and if the addresses are unknown.
  std::vector<std::uint32_t> ways_on(std::uint32_t pc) const;
  bool avoids(std::uint32_t from, std::uint32_t branch, std::uint32_t pc) const;
  /// Returns the addresses that execution can reach from `from` without passing `end` or `stop`, the nearest
  /// first.
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
  std::map<std::uint32_t, std::vector<std::uint16_t>> bytes_of_;  ///< by function
};

}  // namespace robosim::exec::avr
