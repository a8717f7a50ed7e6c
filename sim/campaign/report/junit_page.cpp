#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "sim/base/markup.h"
#include "sim/campaign/report/page_parts.h"
#include "sim/campaign/report/report_page.h"

namespace robosim::campaign {
namespace {

constexpr std::size_t kMostColumns = 12;  // if there are more checks, the table has no column for each

/// Indices of cases, grouped by name, in the order of the names' first use.
struct Table {
  std::vector<std::string> names;
  std::map<std::string, std::vector<std::size_t>> of;

  void add(const std::string& name, std::size_t number) {
    const auto [place, added] = of.try_emplace(name);
    if (added) names.push_back(name);
    place->second.push_back(number);
  }
};

/// Counts the cases with this result.
std::size_t count(const std::vector<JunitCase>& cases, const std::vector<std::size_t>& numbers,
                  JunitCase::Ending ending) {
  return static_cast<std::size_t>(std::count_if(numbers.begin(), numbers.end(),
                                                [&](std::size_t i) { return cases[i].ending == ending; }));
}

std::string cell(const JunitCase& one, std::size_t number, const ReportExtras& extras) {
  if (one.ending == JunitCase::Ending::skipped) return "<td class=\"dim\">–</td>";
  if (one.ending == JunitCase::Ending::passed) return "<td class=\"good\">✓</td>";
  return fmt::format("<td class=\"bad\" title=\"{}\">{}</td>", markup_text(one.message),
                     linked(extras, number, "✗"));
}

/// Returns the shortest lap of all cases; nullopt if no case has a lap.
std::optional<double> best_lap_s(const std::vector<JunitCase>& cases,
                                 const std::vector<std::size_t>& numbers) {
  std::optional<double> best;
  for (const std::size_t i : numbers)
    if (cases[i].best_lap_s) best = std::min(*cases[i].best_lap_s, best.value_or(*cases[i].best_lap_s));
  return best;
}

/// Sorts groups by the number of cases that passed, then by the shortest lap.
void rank(const std::vector<JunitCase>& cases, Table& groups) {
  using Key = std::tuple<std::int64_t, double, std::size_t>;  // the last part is the place before sorting
  std::vector<std::pair<Key, std::string>> sorted;
  for (const std::string& name : groups.names) {
    const std::vector<std::size_t>& own = groups.of.at(name);
    const auto passed = static_cast<std::int64_t>(count(cases, own, JunitCase::Ending::passed));
    const double lap_s = best_lap_s(cases, own).value_or(std::numeric_limits<double>::infinity());
    sorted.push_back({{-passed, lap_s, sorted.size()}, name});
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) groups.names[i] = std::move(sorted[i].second);
}

/// Returns a table with a row for each group. If `columns` is true, it has a column for each check. If `laps`
/// is true, it has a column of shortest laps.
std::string groups_table(const std::vector<JunitCase>& cases, const Table& groups, const Table& checks,
                         bool columns, bool laps, const ReportExtras& extras) {
  const std::string shown = rows_shown(groups.names.size(), kMostRows);
  std::string body = shown.empty() ? "" : fmt::format("<h2>Names{}</h2>\n", shown);
  body +=
      "<div class=\"wide\" tabindex=\"0\"><table>\n<tr><th class=\"left\">name</th><th>passed</th>"
      "<th class=\"left\">look at</th>";
  if (laps) body += "<th>best lap</th>";
  if (columns)
    for (const std::string& name : checks.names) body += fmt::format("<th>{}</th>", markup_text(name));
  body += "<th>time</th></tr>\n";
  for (std::size_t k = 0; k < std::min(groups.names.size(), kMostRows); ++k) {
    const std::string& group = groups.names[k];
    const std::vector<std::size_t>& own = groups.of.at(group);
    double time_s = 0.0;
    std::map<std::string, std::size_t> by_name;
    for (const std::size_t i : own) {
      time_s += cases[i].time_s;
      by_name[cases[i].name] = i;
    }
    const auto seen =
        std::find_if(own.begin(), own.end(), [&](std::size_t i) { return extras.replays.contains(i); });
    body +=
        fmt::format("<tr><td class=\"left\">{}</td><td>{}</td><td class=\"left\">{}</td>", markup_text(group),
                    share_bar(count(cases, own, JunitCase::Ending::passed), own.size()),
                    seen == own.end() ? "" : linked(extras, *seen, markup_text(cases[*seen].name)));
    if (laps) {
      const std::optional<double> best = best_lap_s(cases, own);
      body += best ? fmt::format("<td>{:.2f} s</td>", *best) : "<td class=\"dim\">–</td>";
    }
    if (columns)
      for (const std::string& name : checks.names) {
        const auto found = by_name.find(name);
        body += found == by_name.end() ? "<td class=\"dim\">–</td>"
                                       : cell(cases[found->second], found->second, extras);
      }
    body += fmt::format("<td>{:.2f} s</td></tr>\n", time_s);
  }
  return body + "</table></div>\n";
}

/// Returns a row for each check, over all groups.
std::string checks_table(const std::vector<JunitCase>& cases, const Table& checks) {
  std::vector<double> all_times, all_off;
  for (const JunitCase& one : cases) {
    if (one.ending != JunitCase::Ending::passed) continue;
    all_times.push_back(one.time_s);
    if (one.off_line_mm) all_off.push_back(*one.off_line_mm);
  }
  const double longest_s = std::max(most_of(all_times), 1e-3), widest_mm = std::max(most_of(all_off), 1e-3);
  std::string body = fmt::format(
      "<h2>Passed cases of each check</h2>\n<div class=\"wide\" tabindex=\"0\"><table>\n<tr><th "
      "class=\"left\">check</th><th>passed</th><th>times, 0 to {:.1f} s</th>",
      longest_s);
  if (!all_off.empty()) body += fmt::format("<th>off the line, 0 to {:.0f} mm</th>", widest_mm);
  body += "</tr>\n";
  for (const std::string& name : checks.names) {
    const std::vector<std::size_t>& own = checks.of.at(name);
    std::vector<double> times, off;
    for (const std::size_t i : own) {
      if (cases[i].ending != JunitCase::Ending::passed) continue;
      times.push_back(cases[i].time_s);
      if (cases[i].off_line_mm) off.push_back(*cases[i].off_line_mm);
    }
    body += fmt::format("<tr><td class=\"left\">{}</td><td>{}</td><td>{}</td>", markup_text(name),
                        share_bar(times.size(), own.size()), bars(times, longest_s, "s"));
    if (!all_off.empty()) body += fmt::format("<td>{}</td>", off.empty() ? "" : bars(off, widest_mm, "mm"));
    body += "</tr>\n";
  }
  return body + "</table></div>\n";
}

/// Returns a histogram of all times, used if there are too many checks for a table.
std::string times_of_all(const std::vector<JunitCase>& cases) {
  std::vector<double> times;
  for (const JunitCase& one : cases) times.push_back(one.time_s);
  const double longest_s = std::max(most_of(times), 1e-3);
  return fmt::format("<h2>Times, 0 to {:.2f} s</h2>\n<figure class=\"times\">{}</figure>\n", longest_s,
                     bars(times, longest_s, "s"));
}

std::string what_failed(const std::vector<JunitCase>& cases, const ReportExtras& extras) {
  std::string failures;
  std::size_t told = 0;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (const JunitCase& one = cases[i]; one.ending == JunitCase::Ending::failed && told++ < kMostRows)
      failures += fmt::format(
          "<tr><td class=\"left\">{}</td><td class=\"left\">{}</td><td class=\"why\">{}</td></tr>\n",
          markup_text(one.group), linked(extras, i, markup_text(one.name)), markup_text(one.message));
  if (failures.empty()) return failures;
  return fmt::format("<h2>Failures{}</h2>\n", rows_shown(told, kMostRows)) +
         "<div class=\"wide\" tabindex=\"0\"><table class=\"list\">\n<tr><th "
         "class=\"left\">name</th><th "
         "class=\"left\">check</th><th class=\"left\">why</th></tr>\n" +
         failures + "</table></div>\n";
}

}  // namespace

std::string junit_page(const std::string& file, const std::vector<JunitCase>& cases,
                       const ReportExtras& extras) {
  Table groups, checks;
  std::size_t passed = 0, failed = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    groups.add(cases[i].group, i);
    checks.add(cases[i].name, i);
    passed += cases[i].ending == JunitCase::Ending::passed;
    failed += cases[i].ending == JunitCase::Ending::failed;
  }
  // Checks of several sketches have equal names, which become columns. Tests of C++ programs have different
  // names.
  const bool columns =
      checks.names.size() <= kMostColumns && groups.names.size() > 1 && checks.names.size() < cases.size();
  std::string body =
      fmt::format("<h1>{}</h1>\n<p>{} checks: {} passed, {} failed, {} left out.", markup_text(file),
                  cases.size(), passed, failed, cases.size() - passed - failed);
  if (groups.names.size() > 1) {
    const auto whole = std::count_if(groups.names.begin(), groups.names.end(), [&](const std::string& name) {
      return count(cases, groups.of.at(name), JunitCase::Ending::failed) == 0;
    });
    body += fmt::format(" Names without a failure: {} of {}.", whole, groups.names.size());
  }
  const bool laps =
      columns && std::any_of(cases.begin(), cases.end(), [](const JunitCase& one) { return one.best_lap_s; });
  if (laps) {
    rank(cases, groups);
    body += " The rows are sorted by passed checks, then by the shortest lap.";
  }
  body += "</p>\n" + groups_table(cases, groups, checks, columns, laps, extras) + places_left(extras);
  body += columns ? checks_table(cases, checks) : times_of_all(cases);
  return page_of(file + ": report", body + what_failed(cases, extras));
}

}  // namespace robosim::campaign
