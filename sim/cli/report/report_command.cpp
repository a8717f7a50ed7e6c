#include "sim/cli/report/report_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "sim/base/file.h"
#include "sim/base/file_kind.h"
#include "sim/base/file_lock.h"
#include "sim/cli/output.h"
#include "sim/cli/report/report_page.h"

namespace robosim::cli {

int report_command(const ReportArguments& arguments) {
  const std::string text = read_file(arguments.file);
  const std::string name = std::filesystem::path(arguments.file).filename();
  const FileLock claim(arguments.out);
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  std::string page;
  ReportExtras extras;
  if (first != text.npos && text[first] == '<') {
    const std::vector<JunitCase> cases = read_junit(text, arguments.file);
    extras = extras_of_cases(cases, arguments);
    page = junit_page(name, cases, extras);
  } else {
    const std::vector<SweptRun> runs =
        read_as(FileKind::table, text, arguments.file, [&] { return read_swept_runs(text, arguments.file); });
    extras = extras_of_runs(runs, arguments);
    page = sweep_page(name, runs, extras);
  }
  write_file(arguments.out, page);
  const std::string replays = extras.written == 1 ? "a replay" : fmt::format("{} replays", extras.written);
  print(fmt::format("{} is written{}; open it in a browser\n", arguments.out,
                    extras.written == 0 ? "" : fmt::format(", and {} next to it", replays)));
  return 0;
}

}  // namespace robosim::cli
