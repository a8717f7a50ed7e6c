#include "sim/cli/files/map_print.h"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>
#include <sstream>
#include <system_error>

#include "sim/base/file.h"
#include "sim/base/pluralize.h"
#include "sim/map/map.h"
#include "sim/map/print/print.h"

namespace robosim::cli {
namespace fs = std::filesystem;

ExitStatus print_map(const PrintArguments& arguments, std::ostream& out) {
  print::Options options;
  if (arguments.paper == "A3") options.paper = {297.0, 420.0};
  options.margin = arguments.margin_mm;
  options.swapped = arguments.black_on_white;
  std::error_code error;
  if (fs::exists(fs::symlink_status(arguments.out, error)))
    throw InputError({arguments.out},
                     "exists already; nothing was written; remove it, or name another --out");
  const map::Map map = map::read_map(map::find_map(arguments.map));
  const print::Printed printed = print::print_map(map, options);
  write_file(arguments.out, printed.pdf);
  const print::Sheets& sheets = printed.sheets;
  out << fmt::format("wrote {}: an overview and {} of {}, in {} of {}; print at 100 %\n", arguments.out,
                     pluralize(sheets.printed.size(), "sheet"), arguments.paper,
                     pluralize(static_cast<std::size_t>(sheets.rows), "row"),
                     pluralize(static_cast<std::size_t>(sheets.columns), "column"));
  return ExitStatus::ok;
}

int print_command(const PrintArguments& arguments) {
  std::ostringstream text;
  const ExitStatus status = print_map(arguments, text);
  print(text.str());
  return static_cast<int>(status);
}

}  // namespace robosim::cli
