#include "sim/cli/report/report_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <variant>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/file_kind.h"
#include "sim/base/file_lock.h"
#include "sim/base/shell_word.h"
#include "sim/campaign/report/report_page.h"
#include "sim/cli/launching.h"
#include "sim/cli/output.h"
#include "sim/view/terminal/progress.h"

namespace robosim::cli {
namespace {

/// Parses the `robosim run` command of a result. Adds --untrusted if `untrusted` is true. Throws InputError.
launch::RunSettings run_of(const std::string& command, bool untrusted) {
  std::vector<std::string> words = shell_words(command).value_or(std::vector<std::string>());
  if (!words.empty()) words.erase(words.begin());
  if (untrusted && std::find(words.begin(), words.end(), "--untrusted") == words.end())
    words.emplace_back("--untrusted");
  const Command parsed = parse_arguments(words);
  const auto* run = std::get_if<RunArguments>(&parsed);
  if (!run || run->request.gdb_port != 0)
    throw InputError(fmt::format("expected the command of a run, got “{}”", command));
  return *run;
}

}  // namespace

int report_command(const ReportArguments& arguments) {
  const std::string text = read_file(arguments.file);
  const std::string name = std::filesystem::path(arguments.file).filename();
  const FileLock claim(arguments.out);
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  terminal::Progress progress(true);
  const launch::Listener listener = listener_of(progress, {false, false});
  const auto read_command = [&](const std::string& command) {
    return run_of(command, arguments.each.untrusted);
  };
  std::string page;
  campaign::ReportExtras extras;
  if (first != text.npos && text[first] == '<') {
    const std::vector<campaign::JunitCase> cases = campaign::read_junit(text, arguments.file);
    extras = extras_of_cases(cases, arguments.file, arguments, read_command, listener);
    page = junit_page(name, cases, extras);
  } else {
    const std::vector<campaign::SweptRun> runs = read_as(FileKind::table, text, arguments.file, [&] {
      return campaign::read_swept_runs(text, arguments.file);
    });
    extras = extras_of_runs(runs, arguments, read_command, listener);
    page = sweep_page(name, runs, extras);
  }
  write_file(arguments.out, page);
  const std::string replays = extras.written == 1 ? "a replay" : fmt::format("{} replays", extras.written);
  print(fmt::format("{} is written{}; open it in a browser\n", arguments.out,
                    extras.written == 0 ? "" : fmt::format(", and {} next to it", replays)));
  for (const std::string& remark : campaign::remarks_on(extras))
    complain(fmt::format("robosim: {}\n", remark));
  return 0;
}

}  // namespace robosim::cli
