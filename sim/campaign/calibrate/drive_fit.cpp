#include "sim/campaign/calibrate/drive_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/base/error.h"
#include "sim/campaign/calibrate/drive_bench.h"
#include "sim/campaign/calibrate/optimise.h"

namespace robosim::calibrate {
namespace {

constexpr double kAlike = 10.0;      // number of neighbouring samples that count as one
constexpr double kMostUnsure = 0.5;  // with a larger sd of its logarithm, a parameter is undetermined
// Relative errors (standard deviations) of the model in speeds and in forces. Causes are its ticks, and a PWM
// duty cycle that is known only to half a step.
constexpr double kSpeedModel = 0.005, kForceModel = 0.02;
constexpr int kMostCalls = 500;

/// Returns the parameter's spread in the file as a relative standard deviation.
double held_sd(const Parameter& number) {
  const Spread now = number.in(Profile::typical_2);
  return now.value > 0.0 ? now.spread / (now.value * std::numbers::sqrt3) : 0.0;
}

double sum_of_squares(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return sum;
}

/// Returns the covariance of the free and the fixed parameters. `held` are the standard deviations of the
/// fixed parameters.
std::vector<std::vector<double>> covariance(const Bench& bench, const Factors& x, const std::vector<int>& all,
                                            const Factors& held, double variance) {
  constexpr double kStep = 0.01;
  std::vector<Factors> around;
  for (const int figure : all)
    for (const double step : {kStep, -kStep}) {
      around.push_back(x);
      around.back()[static_cast<std::size_t>(figure)] += step;
    }
  const std::vector<std::vector<double>> beside = bench.residuals(around);
  std::vector<std::vector<double>> slopes;
  for (std::size_t figure = 0; figure < all.size(); ++figure) {
    const std::vector<double>&above = beside[2 * figure], &below = beside[2 * figure + 1];
    slopes.emplace_back();
    for (std::size_t i = 0; i < above.size(); ++i)
      slopes.back().push_back((above[i] - below[i]) / (2.0 * kStep));
  }
  std::vector<std::vector<double>> information(all.size(), std::vector<double>(all.size(), 0.0));
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = 0; b < all.size(); ++b)
      for (std::size_t i = 0; i < slopes[a].size(); ++i)
        information[a][b] += slopes[a][i] * slopes[b][i] / variance;
    const double sd = held[static_cast<std::size_t>(all[a])];
    information[a][a] += sd > 0.0 ? 1.0 / (sd * sd) : 1e-6;
  }
  return inverse(information);
}

}  // namespace

std::optional<DriveFit> fit_drives(const std::vector<Log>& logs, const std::vector<Timed>& timed,
                                   const robot::Description& robot, Found measured_supply) {
  const bool counted =
      std::any_of(logs.begin(), logs.end(), [](const Log& log) { return !log.drives.empty(); });
  if (!counted && timed.empty()) return std::nullopt;
  Bench bench(logs, timed, robot, measured_supply.value);
  if (!bench.has_motors())
    throw InputError({robot.file.string()}, "drives require a part of type motor on each wheel");
  bench.check();

  std::vector<int> free{no_load_left};
  if (counted) free.push_back(no_load_right);
  if (counted || timed.size() >= 2) free.push_back(friction);
  if (counted || timed.size() >= 3) free.push_back(torque);
  if (bench.spins()) free.push_back(inertia);
  std::vector<Range> ranges;
  for (const int figure : free)
    ranges.push_back(figure == friction ? Range{-4.0, 2.5, 0.0, 0.3} : Range{-2.5, 2.5, 0.0, 0.15});
  const auto factors = [&](const std::vector<double>& values) {
    Factors x{};
    for (std::size_t i = 0; i < free.size(); ++i) x[static_cast<std::size_t>(free[i])] = values[i];
    if (!counted) x[no_load_right] = x[no_load_left];
    return x;
  };
  const Factors x = factors(minimise(
      [&](const std::vector<double>& values) { return sum_of_squares(bench.residuals(factors(values))); },
      ranges, kMostCalls));

  DriveFit fit;
  const std::vector<double> left = bench.residuals(x, &fit.curves);
  const double samples = static_cast<double>(left.size());
  const double spare = std::max(samples - static_cast<double>(free.size()), 1.0);
  fit.rms = std::sqrt(sum_of_squares(left) / samples);
  const double variance =
      counted ? kAlike * sum_of_squares(left) / spare : std::max(sum_of_squares(left) / spare, 1.0);

  Factors held{};
  held[supply] =
      measured_supply.value > 0.0 ? measured_supply.sd / measured_supply.value : held_sd(robot.motors.supply);
  held[mass] = held_sd(robot.chassis.mass);
  held[stall] = held_sd(robot.motors.stall_current);
  held[rolling] = held_sd(robot.chassis.rolling);
  std::vector<int> all = free;
  for (const int figure : {supply, mass, stall, rolling})
    if (held[static_cast<std::size_t>(figure)] > 0.0) all.push_back(figure);
  const auto spread = covariance(bench, x, all, held, variance);
  const auto sd_of = [&](int figure) {
    const auto place = std::find(all.begin(), all.end(), figure);
    if (spread.empty() || place == all.end()) return 10.0 * kMostUnsure;
    const auto i = static_cast<std::size_t>(place - all.begin());
    return std::sqrt(std::max(spread[i][i], 0.0));
  };
  const world::BodyParams body = with(bench.body(), x);
  const auto found = [&](double value, int figure) {
    return Found{value,
                 value * std::hypot(sd_of(figure), figure <= no_load_right ? kSpeedModel : kForceModel)};
  };
  fit.no_load = {found(body.wheel[0].no_load_rate, no_load_left),
                 found(body.wheel[1].no_load_rate, counted ? no_load_right : no_load_left)};
  fit.stall_torque = found(body.wheel[0].stall_torque, torque);
  fit.no_load_current = found(body.wheel[0].no_load_current, friction);
  if (bench.spins() && sd_of(inertia) < kMostUnsure) fit.inertia = found(body.yaw_inertia_kgm2, inertia);
  fit.torque_told = sd_of(torque) < kMostUnsure;
  fit.friction_told = sd_of(friction) < kMostUnsure;

  const world::WheelParams& w = body.wheel[0];
  const double ohms = w.nominal_volts / w.stall_current;
  const double k_t = w.stall_torque / (w.stall_current - w.no_load_current);
  const double k_e =
      (w.nominal_volts - ohms * w.no_load_current) / (0.5 * (w.no_load_rate + body.wheel[1].no_load_rate));
  const double turning = w.wheel_inertia_kgm2 + w.rotor_inertia_kgm2 * w.gear_ratio * w.gear_ratio +
                         0.5 * body.mass_kg * w.radius_m * w.radius_m;
  const double tau = turning * (ohms + body.driver_ohms) / (k_t * k_e);
  fit.time_constant = {tau, tau * (counted ? 0.02 : 0.1)};
  return fit;
}

}  // namespace robosim::calibrate
