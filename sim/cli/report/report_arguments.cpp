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
      "report",
      "Makes a page of a sweep's table, or of test results in JUnit's XML. Runs that failed are made again, "
      "to show where the line was left: those of a table need the options that the sweep had.");
  options.positional("FILE", report.file, "of sweep --csv, test --junit, or ctest --output-junit");
  options.text("--out", report.out, "FILE",
               "the page; default: report.html; replays are put into a folder beside it");
  options.text("--runs", runs, "N", "runs that are made again, at most; default: 40; 0: none");
  RunArguments& each = report.each;
  RunOptions shared(options, each);
  shared.task();
  shared.time();
  shared.common();
  options.flag("--sanitize", each.sanitize, "if the sweep had it");
  options.flag("--untrusted", each.untrusted, kUntrusted);
  if (const auto help = options.parse(words)) return PrintText{*help};
  if (report.file.empty())
    throw InputError("robosim report needs a table or an XML file, as in robosim report runs.csv");
  if (!report.out.ends_with(".html")) refuse_value("--out", report.out, "a name that ends in .html");
  if (!runs.empty()) report.runs = whole_number("--runs", runs, 0, kMostRuns);
  shared.finish();
  return report;
}

}  // namespace robosim::cli
