#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "sim/base/markup.h"
#include "sim/campaign/analysis/success_rate.h"
#include "sim/campaign/report/page_parts.h"
#include "sim/campaign/report/report_page.h"
#include "sim/launch/names.h"

namespace robosim::campaign {
namespace {

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

std::string verdicts(const std::vector<SweptRun>& runs, const std::vector<std::size_t>& which) {
  std::map<std::string, std::size_t> counts;
  for (const std::size_t i : which)
    if (!runs[i].reached()) ++counts[runs[i].verdict];
  std::string text;
  for (const auto& [verdict, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, markup_text(verdict));
  return text;
}

std::string what_is_worst(const SweptRun& run, const std::vector<double>& times) {
  if (run.reached()) {
    const bool equal = times.size() > 1 && *std::min_element(times.begin(), times.end()) == run.time_s;
    return equal ? "farthest off" : "slowest";
  }
  std::string text = fmt::format("{} after {:.1f} m", markup_text(run.verdict), run.distance_m);
  for (const auto& [count, what] : {std::pair{run.laps, "lap"}, std::pair{run.stations, "station"}})
    if (count > 0.0) text += fmt::format(", {} {}{}", count, what, count == 1.0 ? "" : "s");
  return text;
}

}  // namespace

std::string sweep_page(const std::string& file, const std::vector<SweptRun>& runs,
                       const ReportExtras& extras) {
  auto combinations = combinations_of(runs);
  const std::string shown = rows_shown(combinations.size(), kMostRows);
  combinations.resize(std::min(combinations.size(), kMostRows));
  std::vector<double> times, errors;
  std::size_t reached = 0;
  for (const SweptRun& run : runs) {
    if (!run.reached()) continue;
    ++reached;
    times.push_back(run.time_s);
    errors.push_back(run.cross_track_max_mm);
  }
  const double longest_s = std::max(most_of(times), 1e-3), widest_mm = std::max(most_of(errors), 1e-3);
  std::string body = fmt::format("<h1>{}</h1>\n<p>{} runs, {} reached their goal.</p>\n", markup_text(file),
                                 runs.size(), reached);
  if (!shown.empty()) body += fmt::format("<h2>Combinations{}</h2>\n", shown);
  body += fmt::format(
      "<div class=\"wide\" tabindex=\"0\"><table>\n<tr><th class=\"left\">sketch</th><th "
      "class=\"left\">map</th><th "
      "class=\"left\">robot</th>"
      "<th class=\"left\">target</th><th>reached</th><th class=\"left\">look at</th><th>mean time</th>"
      "<th>times, 0&nbsp;to&nbsp;{:.1f}&nbsp;s</th><th>off the line, 0&nbsp;to&nbsp;{:.0f}&nbsp;mm</th><th "
      "class=\"left\">failed</th>"
      "<th>95 % interval</th></tr>\n",
      longest_s, widest_mm);
  for (const auto& which : combinations) {
    const SweptRun& first = runs[which[0]];
    std::vector<double> own_times, own_errors;
    for (const std::size_t i : which)
      if (runs[i].reached())
        own_times.push_back(runs[i].time_s), own_errors.push_back(runs[i].cross_track_max_mm);
    const auto [low, high] = analysis::wilson(static_cast<std::int64_t>(own_times.size()),
                                              static_cast<std::int64_t>(which.size()));
    const std::size_t worst = worst_of(runs, which);
    const std::string name =
        fmt::format("{}, seed {}", what_is_worst(runs[worst], own_times), runs[worst].seed);
    body += fmt::format(
        "<tr><td class=\"left\">{}</td><td class=\"left\">{}</td><td class=\"left\">{}</td><td "
        "class=\"left\">{}</td><td>{}</td>"
        "<td class=\"left\">{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"left bad\">{}</td>"
        "<td>{:.2f} .. {:.2f}</td></tr>\n",
        markup_text(launch::title_of(first.sketch, first.sketch)), markup_text(first.map),
        markup_text(first.robot), markup_text(first.target), share_bar(own_times.size(), which.size()),
        linked(extras, worst, name), own_times.empty() ? "–" : fmt::format("{:.2f} s", mean_of(own_times)),
        bars(own_times, longest_s, "s"), bars(own_errors, widest_mm, "mm"), verdicts(runs, which), low, high);
  }
  body += "</table></div>\n";
  body +=
      "<p class=\"dim\">Each row links its worst run. Among failed runs, this is the one with the fewest "
      "laps and stations, then the shortest distance. Without failures, it is the slowest run, then the one "
      "farthest off the line.</p>\n";
  body += places_left(extras);
  std::string failures;
  std::size_t told = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SweptRun& run = runs[i];
    if (!run.reached() && told++ < kMostFailures)
      failures += fmt::format(
          "<tr><td class=\"left\">{}</td><td class=\"left\">{}</td><td class=\"left\">{}</td><td>{}</td><td "
          "class=\"left bad\">{}</td><td>{:.2f} s</td><td class=\"why\">{}</td></tr>\n",
          markup_text(launch::title_of(run.sketch, run.sketch)), markup_text(run.map),
          markup_text(run.target), run.seed, linked(extras, i, markup_text(run.verdict)), run.time_s,
          markup_text(run.why));
  }
  if (!failures.empty())
    body += fmt::format(
        "<h2>Runs that failed{}</h2>\n<div class=\"wide\" tabindex=\"0\"><table class=\"list\">\n<tr><th "
        "class=\"left\">sketch</th><th "
        "class=\"left\">map</th><th class=\"left\">target</th><th>seed</th><th "
        "class=\"left\">verdict</th><th>time</th><th class=\"left\">why</th></tr>\n{}</table></div>\n",
        rows_shown(told, kMostFailures), failures);
  return page_of(file + ": report", body);
}

}  // namespace robosim::campaign
