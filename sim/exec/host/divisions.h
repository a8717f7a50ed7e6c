// Records the first few lines where firmware divided by zero, sorted by time.
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
  /// Counts a division at a known code address; returns false if the address is not known yet.
  bool count(const void* address);
  /// Adds the first division at this address, on a line of the firmware. `t` is the present time.
  void add(const void* address, const SourceLine& place, SimTime t);
  const std::vector<DivisionByZero>& lines() const { return lines_; }

 private:
  std::vector<DivisionByZero> lines_;
  std::map<const void*, std::size_t> at_;  ///< indices into lines_; past its end if there was no room
};

}  // namespace robosim::exec
