#include "sim/cli/report/report_arguments.h"

#include "sim/base/error.h"
#include "sim/cli/run_options.h"

namespace robosim::cli {
namespace {

constexpr std::uint64_t kMostRuns = 10'000;

}  // namespace

Command parse_report(const std::vector<std::string>& words) {
  ReportArguments report;
  std::string runs;
  Options options(
      "report", "make a page from a sweep's table or from test results",
      "Shows who passed. Repeats failed runs to show where the line was left. A table of an older "
      "Robosim lacks the commands of its runs: give the options that its sweep had.");
  options.positional("FILE", report.file,
                     "read this file, which sweep --csv, test --junit or ctest --output-junit wrote",
                     PossibleValues::file());
  options.text("--out", report.out, "FILE",
               "write this page, and replays into a folder next to it (default: report.html)",
               PossibleValues::file());
  options.text("--runs", runs, "N", "repeat at most this many runs (default: 40)");
  launch::RunSettings& each = report.each;
  RunOptions shared(options, each);
  shared.task();
  shared.time();
  shared.common();
  options.flag("--sanitize", each.sanitize, "repeat the runs with --sanitize, as the sweep did");
  options.flag("--untrusted", each.untrusted, kUntrustedHelp);
  if (const auto help = options.parse(words)) return *help;
  if (report.file.empty())
    throw InputError("robosim report requires a table or an XML file, as in robosim report runs.csv");
  if (!report.out.ends_with(".html")) refuse_value("--out", report.out, "a name that ends in .html");
  if (!runs.empty()) report.runs = whole_number("--runs", runs, 0, kMostRuns);
  shared.finish();
  return report;
}

}  // namespace robosim::cli
