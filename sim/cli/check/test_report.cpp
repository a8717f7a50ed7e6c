#include "sim/cli/check/test_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/terminal_text.h"
#include "sim/view/terminal/text.h"

namespace robosim::cli {
namespace {

std::string padded(const std::string& text, int width) {
  return text + std::string(static_cast<std::size_t>(std::max(0, width - terminal::width_of(text))), ' ');
}

/// Returns the largest number of characters in the results of `text_of`.
template <typename Items, typename TextOf>
int widest(const Items& items, const TextOf& text_of) {
  int width = 0;
  for (const auto& item : items) width = std::max(width, terminal::width_of(text_of(item)));
  return width;
}

std::string mark(const campaign::CheckResult& result) {
  switch (result.status) {
    case ExitStatus::ok:
      return "passed";
    case ExitStatus::failed:
    case ExitStatus::timeout:
      return "FAILED";
    default:
      return "ERROR";  // the check could not run
  }
}

// Puts a name into one line. Names come from a sketch or its folder, and may contain line breaks.
std::string shown_name(const campaign::CheckResult& result) { return in_one_line(result.name); }
std::string shown_place(const campaign::CheckResult& result) { return in_one_line(result.where); }

std::string outcome(const campaign::CheckResult& result) {
  if (result.only)
    return fmt::format("{} after {}", result.only->verdict, terminal::time_text(result.only->time_s));
  if (result.runs > 0) return fmt::format("{} of {} runs passed", result.passed, result.runs);
  return "";
}

}  // namespace

std::string sketch_report(const campaign::SketchResult& sketch) {
  if (sketch.problem) return "";
  const auto& results = sketch.results;
  const int names = widest(results, shown_name);
  const int places = widest(results, shown_place);
  std::string text;
  for (const campaign::CheckResult& result : results) {
    std::string line =
        fmt::format("{}  {}  {}  {}", padded(mark(result), 6), padded(shown_name(result), names),
                    padded(shown_place(result), places), outcome(result));
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
    if (!result.why.empty()) text += fmt::format("        why: {}\n", in_one_line(result.why));
    if (!result.ok() && !result.replay.empty())
      text += fmt::format("        see: {} --view\n", in_one_line(result.replay));
  }
  return text + fmt::format("{} of {} check{} passed\n", sketch.passed(), results.size(),
                            results.size() == 1 ? "" : "s");
}

std::string class_report(const std::vector<campaign::SketchResult>& sketches) {
  const auto shown = [](const campaign::SketchResult& sketch) { return in_one_line(sketch.name); };
  const int names = widest(sketches, shown);
  std::size_t passed = 0;
  std::string text;
  for (const campaign::SketchResult& sketch : sketches) {
    std::string line = padded(shown(sketch), names);
    if (sketch.problem) {
      line += "  ERROR   " + in_one_line(sketch.problem->line);
    } else {
      const bool all = sketch.passed() == sketch.results.size();
      line +=
          fmt::format("  {}  {} of {}", all ? "passed" : "FAILED", sketch.passed(), sketch.results.size());
      const auto failed = std::find_if(sketch.results.begin(), sketch.results.end(),
                                       [](const campaign::CheckResult& r) { return !r.ok(); });
      if (failed != sketch.results.end())
        line += fmt::format("  {}: {}", shown_name(*failed), in_one_line(failed->why));
      passed += all ? 1 : 0;
    }
    text += line + "\n";
  }
  return text + fmt::format("{} of {} sketches passed all checks\n", passed, sketches.size());
}

}  // namespace robosim::cli
