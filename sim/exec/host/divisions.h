// Records the first few source lines that have divided by zero, sorted by the time of the first division.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "hal/board/board.h"
#include "sim/exec/core/executor.h"

namespace robosim::exec {

class Divisions {
 public:
  /// Drops the code addresses, because the image will be loaded at another address.
  void forget_addresses() { at_.clear(); }
  /// Counts a division at a code address. Returns false if the address is new: add() must then be called.
  bool count(const void* address);
  /// Adds the first division at a code address. `place` is the source line of the address, and `t` is the
  /// present time.
  void add(const void* address, const SourceLine& place, SimTime t);
  const std::vector<DivisionByZero>& lines() const { return lines_; }

 private:
  std::vector<DivisionByZero> lines_;
  std::map<const void*, std::size_t> at_;  ///< indices into lines_; past its end if lines_ was full
};

}  // namespace robosim::exec
