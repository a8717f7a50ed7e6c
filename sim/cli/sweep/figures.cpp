#include "sim/cli/sweep/figures.h"

#include <fmt/format.h>

#include <cmath>

namespace robosim::cli {
namespace {

using wire::RunResult;
using Values = std::vector<double>;

template <auto Member>
Values metric(const RunResult& result) {
  return {static_cast<double>(result.metrics.*Member)};
}

template <auto Member>
Values resource(const RunResult& result) {
  if (!result.resources) return {};
  return {static_cast<double>((*result.resources).*Member)};
}

/// Of the passes of loop(), which the runner does not always find.
template <auto Member>
Values loop_figure(const RunResult& result) {
  if (!result.resources || result.resources->loops == 0) return {};
  return {(*result.resources).*Member};
}

}  // namespace

const std::vector<Figure>& figures() {
  using wire::Metrics;
  using wire::Resources;
  static const std::vector<Figure> all{
      {"time_s", false, [](const RunResult& result) { return Values{result.time_s}; }},
      {"distance_m", false, metric<&Metrics::distance_m>},
      {"laps_s", false, [](const RunResult& result) { return result.metrics.laps_s; }},
      {"cross_track_rms_mm", false, metric<&Metrics::cross_track_rms_mm>},
      {"cross_track_max_mm", false, metric<&Metrics::cross_track_max_mm>},
      {"off_line_s", false, metric<&Metrics::off_line_s>},
      {"collisions", false, metric<&Metrics::collisions>},
      {"energy_j", false, metric<&Metrics::energy_j>},
      {"junctions", false, metric<&Metrics::junctions>},
      {"flash_bytes", true, resource<&Resources::flash_bytes>},
      {"ram_bytes", true, resource<&Resources::ram_bytes>},
      {"stack_bytes_max", true, resource<&Resources::stack_bytes_max>},
      {"interrupt_share", true, resource<&Resources::interrupt_share>},
      {"cpu_load", true, resource<&Resources::cpu_load>},
      {"loop_us_max", true, loop_figure<&Resources::loop_us_max>},
      {"loop_us_mean", true, loop_figure<&Resources::loop_us_mean>},
  };
  return all;
}

std::string figure_text(double value) {
  constexpr double kAllDigitsFrom = 1000.0;
  if (value == std::floor(value) || std::abs(value) >= kAllDigitsFrom) return fmt::format("{:.0f}", value);
  return fmt::format("{:.4g}", value);
}

}  // namespace robosim::cli
