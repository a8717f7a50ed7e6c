// Compares a sketch, or several robots, on several targets.
#pragma once

#include <cstdint>
#include <memory>

#include "sim/base/progress.h"
#include "sim/campaign/compare/compare_options.h"
#include "sim/campaign/compare/compared.h"

namespace robosim::campaign {

class Comparer {
 public:
  /// Compiles the sketches. `options` and `progress` must outlive this object. Throws InputError and
  /// ToolMissing.
  Comparer(const CompareOptions& options, Progress& progress, const launch::Listener& listener);
  ~Comparer();

  /// Makes the runs of one seed, and explains their first difference.
  Compared compare(std::uint64_t seed);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace robosim::campaign
