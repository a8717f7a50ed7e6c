// Where firmware divided by zero: the first lines of it, in the order of time.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "hal/board/board.h"
#include "sim/exec/core/executor.h"

namespace robosim::exec {

class Divisions {
 public:
  /// The image lies elsewhere from now on.
  void forget_addresses() { at_.clear(); }
  /// Once more at this code address; false if it is not known yet.
  bool count(const void* address);
  /// The first time at this address, a line of the firmware; `t` is now.
  void add(const void* address, const SourceLine& place, SimTime t);
  const std::vector<DivisionByZero>& lines() const { return lines_; }

 private:
  std::vector<DivisionByZero> lines_;
  std::map<const void*, std::size_t> at_;  ///< indices of lines_; past its end: there was no room
};

}  // namespace robosim::exec
