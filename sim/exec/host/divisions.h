// Records where firmware divided by zero: the first of such lines, by time.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "hal/board/board.h"
#include "sim/exec/core/executor.h"

namespace robosim::exec {

class Divisions {
 public:
  /// Forgets code addresses, because the image will be loaded elsewhere.
  void forget_addresses() { at_.clear(); }
  /// Counts one more at this code address; returns false if it is not known yet.
  bool count(const void* address);
  /// Adds the first one at this address, a line of the firmware; `t` is now.
  void add(const void* address, const SourceLine& place, SimTime t);
  const std::vector<DivisionByZero>& lines() const { return lines_; }

 private:
  std::vector<DivisionByZero> lines_;
  std::map<const void*, std::size_t> at_;  ///< indices of lines_; past its end: there was no room
};

}  // namespace robosim::exec
