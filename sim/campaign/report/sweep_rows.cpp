#include "sim/campaign/report/sweep_rows.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>

#include "sim/base/csv.h"
#include "sim/base/error.h"

namespace robosim::campaign {
namespace {

template <class Number>
Number number_of(const std::string& text, const char* column, const Place& place) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_finite = std::isfinite(static_cast<double>(value));
  if (error != std::errc() || end != text.data() + text.size() || !is_finite)
    throw InputError(place, fmt::format("{}: expected a number, got “{}”", column, text.substr(0, 40)));
  return value;
}

}  // namespace

std::vector<SweptRun> read_swept_runs(std::string_view text, const std::string& file) {
  std::map<std::string, std::size_t> columns;
  std::vector<SweptRun> runs;
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = text.find('\n');
    const auto fields = csv_fields(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    const Place place{file, line};
    if (!fields) throw InputError(place, "unterminated text: expected a closing quote");
    if (line == 1) {
      for (std::size_t i = 0; i < fields->size(); ++i) columns[(*fields)[i]] = i;
      for (const char* needed : {"sketch", "map", "robot", "target", "seed", "verdict", "time_s",
                                 "cross_track_max_mm", "trace_hash", "why"})
        if (!columns.contains(needed))
          throw InputError(
              place,
              fmt::format("expected a table of robosim sweep --csv or JUnit's XML: the column {} is missing",
                          needed));
      continue;
    }
    if (fields->size() != columns.size())
      throw InputError(place, fmt::format("expected {} fields, as in the first line, got {}", columns.size(),
                                          fields->size()));
    const auto at = [&](const char* name) { return (*fields)[columns[name]]; };
    SweptRun& run = runs.emplace_back();
    run.sketch = at("sketch");
    run.map = at("map");
    run.robot = at("robot");
    run.target = at("target");
    run.seed = number_of<std::uint64_t>(at("seed"), "seed", place);
    run.verdict = at("verdict");
    run.trace_hash = at("trace_hash");
    run.why = at("why");
    if (columns.contains("command")) run.command = at("command");
    if (run.verdict == "error") continue;
    const auto figure = [&](const char* name) { return number_of<double>(at(name), name, place); };
    run.time_s = figure("time_s");
    run.cross_track_max_mm = figure("cross_track_max_mm");
    const auto figure_or_0 = [&](const char* name) {
      return columns.contains(name) && !at(name).empty() ? figure(name) : 0.0;
    };
    run.distance_m = figure_or_0("distance_m");
    run.laps = figure_or_0("laps");
    run.stations = figure_or_0("stations");
  }
  if (runs.empty()) throw InputError({file}, "expected at least one run");
  return runs;
}

}  // namespace robosim::campaign
