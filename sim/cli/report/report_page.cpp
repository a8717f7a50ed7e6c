#include "sim/cli/report/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include "sim/analysis/success_rate.h"
#include "sim/base/markup.h"
#include "sim/record/record_svg.h"

namespace robosim::cli {
namespace {

constexpr int kBins = 24;
constexpr std::size_t kMostColumns = 12;  // of checks; more are told in words
constexpr std::size_t kMostFailures = 200;

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --text: #1c1f23; --dim: #5d646d; --edge: #d9d7d0; --page: #f3f2ee; --panel: #fff; --good: #00694c; --bad: #a83f00; --bar: #0072b2; }
@media (prefers-color-scheme: dark) { :root { --text: #e8e6e1; --dim: #9da5af; --edge: #343a42; --page: #15181c; --panel: #1e2227; --good: #4fd1a5; --bad: #ff9a5c; --bar: #56b4e9; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 75rem; padding: 1rem; background: var(--page); color: var(--text); font: 15px/1.45 system-ui, sans-serif; }
h1 { font-size: 1.4rem; margin: .2rem 0; } h2 { font-size: 1.1rem; margin: 1.6rem 0 .5rem; }
p { margin: .3rem 0; } .dim { color: var(--dim); }
.wide { overflow-x: auto; background: var(--panel); border: 1px solid var(--edge); border-radius: 8px; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { padding: .35rem .6rem; text-align: right; border-bottom: 1px solid var(--edge); white-space: nowrap; }
th { font-weight: 600; font-size: .85rem; vertical-align: bottom; } tr:last-child td { border-bottom: 0; }
th.left, td.left { text-align: left; } td.why { white-space: normal; text-align: left; min-width: 16rem; }
.good { color: var(--good); } .bad { color: var(--bad); font-weight: 600; }
.share { display: inline-block; width: 5rem; height: .6rem; margin-right: .5rem; border-radius: 3px; background: var(--bad); overflow: hidden; vertical-align: 0; }
.share i { display: block; height: 100%; background: var(--good); }
svg.bars { width: 9rem; height: 1.8rem; display: block; margin-left: auto; }
svg.bars rect { fill: var(--bar); }
.maps { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 24rem), 1fr)); gap: 1rem; }
figure { margin: 0; padding: .6rem; background: var(--panel); border: 1px solid var(--edge); border-radius: 8px; }
figure svg { width: 100%; height: auto; max-height: 28rem; display: block; } figcaption { margin-top: .4rem; font-size: .9rem; }
a { color: var(--bar); }
)";

std::string page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "img-src data:\">\n<link rel=\"icon\" href=\"data:,\">\n<title>{}</title>\n<style>{}</style>\n</head>\n"
      "<body>\n{}</body>\n</html>\n",
      markup_text(title), kStyle, body);
}

std::string share_bar(std::size_t good, std::size_t all) {
  return fmt::format(R"(<span class="share"><i style="width:{:.1f}%"></i></span>{}/{})",
                     100.0 * static_cast<double>(good) / static_cast<double>(std::max<std::size_t>(all, 1)),
                     good, all);
}

/// How many values fall into each of kBins equal parts of 0..most.
std::string bars(const std::vector<double>& values, double most, const std::string& unit) {
  std::vector<int> counts(kBins, 0);
  for (const double value : values)
    ++counts[static_cast<std::size_t>(std::clamp(value / most * kBins, 0.0, kBins - 1.0))];
  const int highest = std::max(1, *std::max_element(counts.begin(), counts.end()));
  std::string text = fmt::format(
      R"(<svg class="bars" viewBox="0 0 {} 20" preserveAspectRatio="none" role="img"><title>{} values from 0 to {:.2f} {}</title>)",
      kBins, values.size(), most, unit);
  for (int i = 0; i < kBins; ++i)
    if (const double h = 20.0 * counts[static_cast<std::size_t>(i)] / highest; h > 0.0)
      fmt::format_to(std::back_inserter(text), R"(<rect x="{}" y="{:.2f}" width="0.9" height="{:.2f}"/>)", i,
                     20.0 - h, h);
  return text + "</svg>";
}

double most_of(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

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

std::string heat_map(const std::string& map, const LeftOn& left) {
  const record::FloorShapes& floor = *left.floor;
  std::string text = fmt::format(
      "<figure><svg viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" aria-label=\"where robots left the line on "
      "{2}\">"
      "<defs><radialGradient id=\"heat\"><stop offset=\"0\" stop-color=\"#d55e00\" stop-opacity=\".75\"/>"
      "<stop offset=\"1\" stop-color=\"#d55e00\" stop-opacity=\"0\"/></radialGradient></defs>{3}",
      floor.width_mm, floor.height_mm, markup_text(map), record::floor_elements(floor));
  const double radius = std::max(floor.width_mm, floor.height_mm) / 28.0;
  // Many places lie over each other: the fewer, the stronger each.
  text += fmt::format("<g fill-opacity=\"{:.2f}\">",
                      std::clamp(20.0 / static_cast<double>(left.places_mm.size() + 1), 0.08, 1.0));
  for (const auto& [x, y] : left.places_mm)
    fmt::format_to(std::back_inserter(text),
                   R"x(<circle cx="{:.0f}" cy="{:.0f}" r="{:.0f}" fill="url(#heat)"/>)x", x,
                   floor.height_mm - y, radius);
  return text +
         fmt::format(
             "</g></svg><figcaption><b>{}</b>: {} in {} of the runs made again</figcaption></figure>\n",
             markup_text(map),
             left.places_mm.size() == 1 ? "the line was left once"
                                        : fmt::format("the line was left {} times", left.places_mm.size()),
             left.runs);
}

}  // namespace

std::vector<std::vector<std::size_t>> combinations_of(const std::vector<SweptRun>& runs) {
  std::map<std::tuple<std::string, std::string, std::string, std::string>, std::size_t> places;
  std::vector<std::vector<std::size_t>> all;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SweptRun& r = runs[i];
    const auto [place, added] = places.try_emplace({r.sketch, r.map, r.robot, r.target}, all.size());
    if (added) all.emplace_back();
    all[place->second].push_back(i);
  }
  return all;
}

std::size_t worst_of(const std::vector<SweptRun>& runs, const std::vector<std::size_t>& combination) {
  const auto failed =
      std::find_if(combination.begin(), combination.end(), [&](std::size_t i) { return !runs[i].reached(); });
  if (failed != combination.end()) return *failed;
  return *std::max_element(combination.begin(), combination.end(),
                           [&](std::size_t a, std::size_t b) { return runs[a].time_s < runs[b].time_s; });
}

std::string sweep_page(const std::string& file, const std::vector<SweptRun>& runs, const Shown& shown) {
  const auto combinations = combinations_of(runs);
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
  body += fmt::format(
      "<div class=\"wide\"><table>\n<tr><th class=\"left\">sketch</th><th class=\"left\">map</th><th "
      "class=\"left\">robot</th>"
      "<th class=\"left\">target</th><th>reached</th><th class=\"left\">look at</th><th>mean time</th>"
      "<th>times, 0 to {:.1f} s</th><th>off the line, 0 to {:.0f} mm</th><th class=\"left\">failed</th>"
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
        fmt::format("{}, seed {}", runs[worst].reached() ? "slowest" : markup_text(runs[worst].verdict),
                    runs[worst].seed);
    const auto replay = shown.replays.find(worst);
    body += fmt::format(
        "<tr><td class=\"left\">{}</td><td class=\"left\">{}</td><td class=\"left\">{}</td><td "
        "class=\"left\">{}</td><td>{}</td>"
        "<td class=\"left\">{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"left bad\">{}</td>"
        "<td>{:.2f} .. {:.2f}</td></tr>\n",
        markup_text(first.sketch), markup_text(first.map), markup_text(first.robot),
        markup_text(first.target), share_bar(own_times.size(), which.size()),
        replay == shown.replays.end()
            ? name
            : fmt::format("<a href=\"{}\">{}</a>", markup_text(replay->second), name),
        own_times.empty() ? "–" : fmt::format("{:.2f} s", mean_of(own_times)),
        bars(own_times, longest_s, "s"), bars(own_errors, widest_mm, "mm"), verdicts(runs, which), low, high);
  }
  body += "</table></div>\n";
  std::string maps;
  for (const auto& [map, left] : shown.left)
    if (left.floor && left.runs > 0) maps += heat_map(map, left);
  if (!maps.empty())
    body += "<h2>Where robots left the line</h2>\n<div class=\"maps\">\n" + maps + "</div>\n";
  if (shown.other > 0)
    body += fmt::format(
        "<p class=\"bad\">{} of the runs came out otherwise when they were made again, and are not shown: "
        "give report the options of the sweep, or the sketch, map or robot has changed since.</p>\n",
        shown.other);
  if (shown.not_made > 0)
    body +=
        fmt::format("<p class=\"dim\">{} more runs failed and were not made again (--runs makes more).</p>\n",
                    shown.not_made);
  std::string failures;
  std::size_t told = 0;
  for (const SweptRun& run : runs)
    if (!run.reached() && told++ < kMostFailures)
      failures += fmt::format(
          "<tr><td class=\"left\">{}</td><td class=\"left\">{}</td><td class=\"left\">{}</td><td>{}</td><td "
          "class=\"left bad\">{}</td><td>{:.2f} s</td><td class=\"why\">{}</td></tr>\n",
          markup_text(run.sketch), markup_text(run.map), markup_text(run.target), run.seed,
          markup_text(run.verdict), run.time_s, markup_text(run.why));
  if (!failures.empty())
    body += fmt::format(
        "<h2>Runs that failed{}</h2>\n<div class=\"wide\"><table>\n<tr><th class=\"left\">sketch</th><th "
        "class=\"left\">map</th><th class=\"left\">target</th><th>seed</th><th "
        "class=\"left\">verdict</th><th>time</th><th class=\"left\">why</th></tr>\n{}</table></div>\n",
        told > kMostFailures ? fmt::format(", the first {} of {}", kMostFailures, told) : "", failures);
  return page(file + ": report", body);
}

std::string junit_page(const std::string& file, const std::vector<JunitCase>& cases) {
  using Ending = JunitCase::Ending;
  std::vector<std::string> groups, names;
  std::map<std::string, std::map<std::string, const JunitCase*>> of;
  std::size_t passed = 0, failed = 0;
  for (const JunitCase& one : cases) {
    if (std::find(groups.begin(), groups.end(), one.group) == groups.end()) groups.push_back(one.group);
    if (names.size() <= kMostColumns && std::find(names.begin(), names.end(), one.name) == names.end())
      names.push_back(one.name);
    of[one.group][one.name] = &one;
    passed += one.ending == Ending::passed;
    failed += one.ending == Ending::failed;
  }
  const bool columns = names.size() <= kMostColumns && groups.size() > 1;
  std::string body = fmt::format(
      "<h1>{}</h1>\n<p>{} checks: {} passed, {} failed, {} left out.</p>\n<div "
      "class=\"wide\"><table>\n<tr><th class=\"left\">of</th><th>passed</th>",
      markup_text(file), cases.size(), passed, failed, cases.size() - passed - failed);
  if (columns)
    for (const std::string& name : names) body += fmt::format("<th>{}</th>", markup_text(name));
  body += "<th>time</th></tr>\n";
  for (const std::string& group : groups) {
    std::size_t good = 0;
    double time_s = 0.0;
    std::vector<double> times;
    for (const auto& [name, one] : of[group]) {
      good += one->ending == Ending::passed;
      time_s += one->time_s;
      times.push_back(one->time_s);
    }
    body += fmt::format("<tr><td class=\"left\">{}</td><td>{}</td>", markup_text(group),
                        share_bar(good, of[group].size()));
    for (const std::string& name : columns ? names : std::vector<std::string>{}) {
      const auto found = of[group].find(name);
      const Ending* ending = found == of[group].end() ? nullptr : &found->second->ending;
      body += !ending || *ending == Ending::skipped ? "<td class=\"dim\">–</td>"
              : *ending == Ending::passed
                  ? "<td class=\"good\">✓</td>"
                  : fmt::format("<td class=\"bad\" title=\"{}\">✗</td>", markup_text(found->second->message));
    }
    body += fmt::format("<td>{:.2f} s</td></tr>\n", time_s);
  }
  body += "</table></div>\n";
  std::vector<double> times;
  for (const JunitCase& one : cases) times.push_back(one.time_s);
  const double longest_s = std::max(most_of(times), 1e-3);
  body += fmt::format("<h2>Times, 0 to {:.2f} s</h2>\n<figure>{}</figure>\n", longest_s,
                      bars(times, longest_s, "s"));
  std::string failures;
  for (const JunitCase& one : cases)
    if (one.ending == Ending::failed)
      failures += fmt::format(
          "<tr><td class=\"left\">{}</td><td class=\"left\">{}</td><td class=\"why\">{}</td></tr>\n",
          markup_text(one.group), markup_text(one.name), markup_text(one.message));
  if (!failures.empty())
    body +=
        "<h2>What failed</h2>\n<div class=\"wide\"><table>\n<tr><th class=\"left\">of</th><th "
        "class=\"left\">check</th><th class=\"left\">why</th></tr>\n" +
        failures + "</table></div>\n";
  return page(file + ": report", body);
}

}  // namespace robosim::cli
