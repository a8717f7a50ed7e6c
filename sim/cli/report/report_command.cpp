#include "sim/cli/report/report_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "sim/base/file.h"
#include "sim/base/file_kind.h"
#include "sim/base/write_claim.h"
#include "sim/cli/output.h"
#include "sim/cli/report/report_page.h"

namespace robosim::cli {

int report_command(const ReportArguments& arguments) {
  const std::string text = read_file(arguments.file);
  const std::string name = std::filesystem::path(arguments.file).filename();
  const WriteClaim claim(arguments.out);
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  std::string page;
  Shown shown;
  if (first != text.npos && text[first] == '<') {
    const std::vector<JunitCase> cases = read_junit(text, arguments.file);
    shown = look_at_cases(cases, arguments);
    page = junit_page(name, cases, shown);
  } else {
    const std::vector<SweptRun> runs =
        read_as(FileKind::table, text, arguments.file, [&] { return read_swept_runs(text, arguments.file); });
    shown = look_at_runs(runs, arguments);
    page = sweep_page(name, runs, shown);
  }
  write_file(arguments.out, page);
  const std::string replays = shown.written == 1 ? "a replay" : fmt::format("{} replays", shown.written);
  print(fmt::format("{} is written{}; open it in a browser\n", arguments.out,
                    shown.written == 0 ? "" : fmt::format(", and {} next to it", replays)));
  return 0;
}

}  // namespace robosim::cli
