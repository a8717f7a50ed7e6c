// The least of a function of a few numbers, by NLopt; and how sure the place of that least is.
#pragma once

#include <functional>
#include <vector>

namespace robosim::calibrate {

struct Range {
  double low, high;
  double start;
  double step;  ///< of the first look around
};

/// The place within the ranges where `f` is least, as far as a search from their starts finds it: NLopt's
/// BOBYQA, or Nelder and Mead's for a single number. `f` must be finite and not throw. Deterministic.
std::vector<double> minimise(const std::function<double(const std::vector<double>&)>& f,
                             const std::vector<Range>& ranges, int most_calls);

/// The inverse of a symmetric positive definite matrix (rows of a square), or nothing if it is none: what
/// the data do not tell.
std::vector<std::vector<double>> inverse(std::vector<std::vector<double>> matrix);

}  // namespace robosim::calibrate
