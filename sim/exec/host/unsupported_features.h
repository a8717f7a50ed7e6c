// Records the chip features that firmware has used and that its image for the host does not have. Each
// feature is recorded once, at the time of its first use.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "hal/board/board.h"
#include "sim/exec/core/executor.h"

namespace robosim::exec {

class UnsupportedFeatures {
 public:
  bool has(const std::string& what) const {
    return std::any_of(all_.begin(), all_.end(), [&](const Lack& one) { return one.what == what; });
  }
  void add(const char* what, const SourceLine& place, SimTime t) {
    all_.push_back({what, place, 1e-9 * static_cast<double>(t)});
  }
  const std::vector<Lack>& all() const { return all_; }

 private:
  std::vector<Lack> all_;
};

}  // namespace robosim::exec
