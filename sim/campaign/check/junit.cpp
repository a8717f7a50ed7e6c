#include "sim/campaign/check/junit.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/markup.h"
#include "sim/campaign/sweep/figures.h"

namespace robosim::campaign {
namespace {

/// Formats a sketch's output, with plain line ends.
std::string xml_log(const std::string& serial) {
  std::string xml;
  for (std::size_t begin = 0; begin < serial.size();) {
    const std::size_t end = std::min(serial.find('\n', begin), serial.size());
    std::string line = serial.substr(begin, end - begin);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    xml += markup_text(line);
    if (end < serial.size()) xml += '\n';
    begin = end + 1;
  }
  return xml;
}

std::string property(const std::string& name, const std::string& value) {
  return fmt::format("        <property name=\"{}\" value=\"{}\"/>\n", name, markup_text(value));
}

std::string properties(const CheckResult& result) {
  std::string xml;
  if (result.only) {
    xml += property("verdict", result.only->verdict) + property("seed", std::to_string(result.only->seed)) +
           property("trace_hash", result.only->trace_hash);
    for (const Figure& figure : figures()) {
      for (const double value : figure.values(*result.only))
        xml += property(figure.name, fmt::format("{}", value));
    }
  } else if (result.runs > 0) {
    xml += property("runs", std::to_string(result.runs)) + property("passed", std::to_string(result.passed));
  }
  if (result.best_lap_s) xml += property("best_lap_s", fmt::format("{}", *result.best_lap_s));
  if (!result.ok() && !result.again.empty())
    xml += property("failed_run", result.again) + property("failed_trace_hash", result.again_trace_hash);
  return xml.empty() ? "" : "      <properties>\n" + xml + "      </properties>\n";
}

bool is_failure(ExitStatus status) { return status == ExitStatus::failed || status == ExitStatus::timeout; }

std::string verdict(const CheckResult& result) {
  if (result.ok()) return "";
  const char* element = is_failure(result.status) ? "failure" : "error";
  return fmt::format("      <{0} message=\"{1}\">{2}</{0}>\n", element, markup_text(result.why),
                     markup_text(result.replay.empty() ? result.why : result.why + "\n" + result.replay));
}

std::string log(const CheckResult& result) {
  if (result.ok() || result.serial.empty()) return "";
  return fmt::format("      <system-out>{}</system-out>\n", xml_log(result.serial));
}

std::string test_case(const std::string& sketch, const CheckResult& result) {
  return fmt::format(
      "    <testcase classname=\"{}\" name=\"{}\" file=\"{}\" line=\"{}\" time=\"{:.3f}\">\n{}{}{}    "
      "</testcase>\n",
      markup_text(sketch), markup_text(result.name), markup_text(result.place.file), result.place.line,
      result.time_s, properties(result), verdict(result), log(result));
}

struct Sums {
  std::size_t tests = 0;
  std::size_t failures = 0;
  std::size_t errors = 0;
  double time_s = 0.0;

  std::string text() const {
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"", tests, failures, errors,
                       time_s);
  }
};

Sums sums_of(const SketchResult& sketch) {
  if (sketch.problem) return {1, 0, 1, 0.0};
  Sums sums{sketch.results.size(), 0, 0, 0.0};
  for (const CheckResult& result : sketch.results) {
    sums.time_s += result.time_s;
    if (result.ok()) continue;
    ++(is_failure(result.status) ? sums.failures : sums.errors);
  }
  return sums;
}

}  // namespace

std::string junit_xml(const std::vector<SketchResult>& sketches) {
  Sums all;
  std::string suites;
  for (const SketchResult& sketch : sketches) {
    const Sums sums = sums_of(sketch);
    all = {all.tests + sums.tests, all.failures + sums.failures, all.errors + sums.errors,
           all.time_s + sums.time_s};
    suites += fmt::format("  <testsuite name=\"{}\" {}>\n", markup_text(sketch.name), sums.text());
    if (sketch.problem) {
      suites += fmt::format(
          "    <testcase classname=\"{}\" name=\"can be checked\" time=\"0\">\n"
          "      <error message=\"{}\">{}</error>\n    </testcase>\n",
          markup_text(sketch.name), markup_text(sketch.problem->line), markup_text(sketch.problem->text));
    } else {
      for (const CheckResult& result : sketch.results) suites += test_case(sketch.name, result);
    }
    suites += "  </testsuite>\n";
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"robosim\" {}>\n{}</testsuites>\n",
      all.text(), suites);
}

}  // namespace robosim::campaign
