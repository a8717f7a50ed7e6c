// Which branch decides that an instruction runs: with the branch's other way the program may come back to
// it, or leave the function, without having run that instruction. And what a branch has left out.
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

  /// Places are in words.
  bool is_branch(std::uint32_t pc) const;
  /// Registers, a bit each.
  std::uint32_t writes_of(std::uint32_t pc) const { return writes_[pc]; }
  /// `next`: where the branch, which is in the same function, has led.
  bool decides(std::uint32_t branch, std::uint32_t next, std::uint32_t pc);

  /// What the branch's other way would have written before it comes to where both ways meet.
  struct LeftOut {
    static constexpr std::uint32_t kInCaller = ~0u;
    std::uint32_t meets = kInCaller;
    std::uint32_t registers = 0;       ///< a bit each
    std::vector<std::uint16_t> bytes;  ///< of data memory; what it calls is with it. In order
    /// By the pair of registers that points there, as at the branch: how far behind. Not of what it calls.
    std::map<std::uint8_t, std::vector<std::uint8_t>> bytes_by_pointer;
  };
  /// `next`: where the branch has led.
  const LeftOut& left_out(std::uint32_t branch, std::uint32_t next);

 private:
  std::uint32_t led_to(std::uint32_t pc, std::int32_t by) const;
  /// The function that is called there; none where no call is, or where it is not known.
  std::optional<std::uint32_t> called_at(std::uint32_t pc) const;
  /// Where it goes on in the same function; none behind a return, or where it is not known.
  std::vector<std::uint32_t> ways_on(std::uint32_t pc) const;
  bool avoids(std::uint32_t from, std::uint32_t branch, std::uint32_t pc) const;
  /// What can run from there before `end` and `stop`, the nearest first.
  std::vector<std::uint32_t> reached(std::uint32_t from, std::uint32_t end, std::uint32_t stop) const;
  bool leaves(std::uint32_t from, std::uint32_t branch, std::uint32_t pc) const;
  std::uint32_t meeting(std::uint32_t branch, std::uint32_t next, std::uint32_t other) const;
  void add_writes(const std::vector<std::uint32_t>& places, LeftOut& left_out);
  void add_bytes_by_pointer(const std::vector<std::uint32_t>& places, LeftOut& left_out);
  const std::vector<std::uint16_t>& bytes_of(std::uint32_t function);

  const robosim::avr::Cpu& cpu_;
  std::vector<std::uint32_t> writes_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, bool> known_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, LeftOut> left_out_;
  std::map<std::uint32_t, std::vector<std::uint16_t>> bytes_of_;  ///< by where a function begins
};

}  // namespace robosim::exec::avr
