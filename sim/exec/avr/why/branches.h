// Which branch decides that an instruction runs: with the branch's other way the program may come back to
// it, or leave the function, without having run that instruction.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "sim/avr/cpu.h"

namespace robosim::exec::avr {

class Branches {
 public:
  explicit Branches(const robosim::avr::Cpu& cpu) : cpu_(cpu) {}

  /// Places are in words.
  bool is_branch(std::uint32_t pc) const;
  /// `next`: where the branch, which is in the same function, has led.
  bool decides(std::uint32_t branch, std::uint32_t next, std::uint32_t pc);
  /// What would have run next if the branch, which has led to `next`, had gone its other way: the first few
  /// instructions, one behind the other.
  const std::vector<std::uint32_t>& left_out(std::uint32_t branch, std::uint32_t next);

 private:
  /// Where it goes on in the same function; none behind a return, or where it is not known.
  std::vector<std::uint32_t> ways_on(std::uint32_t pc) const;
  bool avoids(std::uint32_t from, std::uint32_t branch, std::uint32_t pc) const;

  const robosim::avr::Cpu& cpu_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, bool> known_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> left_out_;
};

}  // namespace robosim::exec::avr
