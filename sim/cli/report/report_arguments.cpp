#include "sim/cli/report/report_arguments.h"

#include "sim/base/error.h"
#include "sim/cli/options.h"

namespace robosim::cli {
namespace {

constexpr std::uint64_t kMostRuns = 10'000;

}  // namespace

Command parse_report(const std::vector<std::string>& words) {
  ReportArguments report;
  std::string duration, clock, runs;
  Options options(
      "report",
      "Makes a page of a sweep's table, or of test results in JUnit's XML. Runs of the table that failed are "
      "made again, to show where the line was left: for that it needs the options that the sweep had.");
  options.positional("FILE", report.file, "of sweep --csv, test --junit, or ctest --output-junit");
  options.text("--out", report.out, "FILE",
               "the page; default: report.html; replays are put into a folder beside it");
  options.text("--runs", runs, "N", "runs that are made again, at most; default: 40; 0: none");
  RunArguments& each = report.each;
  options.text("--start", each.request.start, "X,Y,DIR", "of the sweep; so are all that follow");
  options.text("--goal", each.request.goal, "GOAL", "");
  options.text("--for", duration, "TIME", "");
  options.text("--clock", clock, "TIME", "");
  options.text("--profile", each.request.profile, "PROFILE", kProfiles);
  options.text("--script", each.script, "FILE", "");
  options.texts("--send", each.send, "TEXT", "");
  options.text("--env", each.environment, "NAME", kEnvironment);
  options.texts("--libraries", each.libraries, "DIR", "may be repeated");
  options.flag("--sanitize", each.sanitize, "");
  options.flag("--untrusted", each.untrusted, kUntrusted);
  if (const auto help = options.parse(words)) return PrintText{*help};
  if (report.file.empty())
    throw InputError("robosim report needs a table or an XML file, as in robosim report runs.csv");
  if (!report.out.ends_with(".html")) refuse_value("--out", report.out, "a name that ends in .html");
  if (!runs.empty()) report.runs = whole_number("--runs", runs, 0, kMostRuns);
  if (!duration.empty()) each.request.for_ns = simulated_time("--for", duration);
  if (!clock.empty()) each.request.clock_ns = simulated_time("--clock", clock);
  check_profile(each.request.profile);
  return report;
}

}  // namespace robosim::cli
