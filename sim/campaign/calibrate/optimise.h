// Minimises a function of a few numbers by NLopt, and inverts matrices to find the minimum's uncertainty.
#pragma once

#include <functional>
#include <vector>

namespace robosim::calibrate {

struct Range {
  double low, high;
  double start;
  double step;  ///< step of the initial search
};

/// Returns the point within the ranges at which `f` is smallest, as far as a search from `start` finds it.
/// The method is NLopt's BOBYQA, or Nelder-Mead for a single number. `f` must be finite and must not throw.
/// The result is deterministic.
std::vector<double> minimise(const std::function<double(const std::vector<double>&)>& f,
                             const std::vector<Range>& ranges, int most_calls);

/// Returns the inverse of a symmetric positive definite matrix, given as rows. Returns nothing for any other
/// matrix. For a fit, this means that its data do not determine a value.
std::vector<std::vector<double>> inverse(std::vector<std::vector<double>> matrix);

}  // namespace robosim::calibrate
