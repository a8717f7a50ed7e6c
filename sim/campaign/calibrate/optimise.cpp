#include "sim/campaign/calibrate/optimise.h"

#include <nlopt.h>

#include <cmath>
#include <memory>

namespace robosim::calibrate {
namespace {

struct Search {
  const std::function<double(const std::vector<double>&)>& f;
  std::vector<double> at, best;
  double least;
};

double call(unsigned count, const double* x, double*, void* data) {
  Search& search = *static_cast<Search*>(data);
  search.at.assign(x, x + count);
  const double value = search.f(search.at);
  if (value < search.least) {
    search.least = value;
    search.best = search.at;
  }
  return value;
}

}  // namespace

std::vector<double> minimise(const std::function<double(const std::vector<double>&)>& f,
                             const std::vector<Range>& ranges, int most_calls) {
  const auto count = static_cast<unsigned>(ranges.size());
  const nlopt_algorithm algorithm = count == 1 ? NLOPT_LN_NELDERMEAD : NLOPT_LN_BOBYQA;
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimiser(nlopt_create(algorithm, count),
                                                                         nlopt_destroy);
  std::vector<double> low, high, step, x;
  for (const Range& range : ranges) {
    low.push_back(range.low);
    high.push_back(range.high);
    step.push_back(range.step);
    x.push_back(range.start);
  }
  Search search{f, x, x, f(x)};
  nlopt_set_lower_bounds(optimiser.get(), low.data());
  nlopt_set_upper_bounds(optimiser.get(), high.data());
  nlopt_set_initial_step(optimiser.get(), step.data());
  nlopt_set_min_objective(optimiser.get(), call, &search);
  nlopt_set_maxeval(optimiser.get(), most_calls);
  nlopt_set_ftol_rel(optimiser.get(), 1e-10);
  nlopt_set_xtol_rel(optimiser.get(), 1e-6);
  double least = 0.0;
  nlopt_optimize(optimiser.get(), x.data(), &least);  // an early stop returns the best result so far
  return search.best;
}

std::vector<std::vector<double>> inverse(std::vector<std::vector<double>> matrix) {
  const std::size_t n = matrix.size();
  std::vector<std::vector<double>> result(n, std::vector<double>(n, 0.0));
  for (std::size_t i = 0; i < n; ++i) result[i][i] = 1.0;
  for (std::size_t i = 0; i < n; ++i) {  // Gauss-Jordan: a positive definite matrix needs no pivoting
    const double pivot = matrix[i][i];
    if (!(pivot > 0.0) || !std::isfinite(pivot)) return {};
    for (std::size_t k = 0; k < n; ++k) {
      matrix[i][k] /= pivot;
      result[i][k] /= pivot;
    }
    for (std::size_t row = 0; row < n; ++row) {
      if (row == i) continue;
      const double factor = matrix[row][i];
      for (std::size_t k = 0; k < n; ++k) {
        matrix[row][k] -= factor * matrix[i][k];
        result[row][k] -= factor * result[i][k];
      }
    }
  }
  return result;
}

}  // namespace robosim::calibrate
