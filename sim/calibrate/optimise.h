// Minimises a function of a few numbers, by NLopt; and finds the uncertainty of the minimum.
#pragma once

#include <functional>
#include <vector>

namespace robosim::calibrate {

struct Range {
  double low, high;
  double start;
  double step;  ///< of the initial search
};

/// Returns where `f` is smallest within the ranges, as far as a search from their starts finds it. The method
/// is NLopt's BOBYQA, or Nelder-Mead for a single number. `f` must be finite and not throw. Deterministic.
std::vector<double> minimise(const std::function<double(const std::vector<double>&)>& f,
                             const std::vector<Range>& ranges, int most_calls);

/// Returns the inverse of a symmetric positive definite matrix (rows of a square). Returns nothing if it is
/// not one: then the data do not determine a value.
std::vector<std::vector<double>> inverse(std::vector<std::vector<double>> matrix);

}  // namespace robosim::calibrate
