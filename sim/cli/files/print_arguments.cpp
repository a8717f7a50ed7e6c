#include "sim/cli/files/print_arguments.h"

#include "sim/base/error.h"
#include "sim/base/units.h"
#include "sim/cli/options.h"
#include "sim/map/print/sheets.h"

namespace robosim::cli {

namespace {

const std::vector<std::string> kPapers{"A4", "A3"};

}  // namespace

Command parse_print(const std::vector<std::string>& words) {
  PrintArguments print;
  std::string margin;
  Options options("map print", "write a map as a PDF in true size, on sheets to lay on the floor");
  options.positional("MAP", print.map, kMapHelp, PossibleValues::map());
  options.text("--out", print.out, "FILE.pdf", "write this file (required)", PossibleValues::file());
  options.text("--paper", print.paper, "SIZE", "print on A4 or A3 (default: A4)",
               PossibleValues::of(kPapers));
  options.text("--margin", margin, "LENGTH",
               "leave this margin on each sheet, where the printer cannot print (default: 5mm)");
  options.flag("--black-on-white", print.black_on_white,
               "save ink: print dark lines on white paper even if the map is white on black");
  if (const auto help = options.parse(words)) return *help;
  check_choice("--paper", print.paper, kPapers);
  if (!margin.empty()) {
    const auto length = parse_quantity(margin, Dimension::length);
    if (!length || !(*length >= 0.0 && *length * 1e3 <= print::kMostMargin))
      refuse_value("--margin", margin, "a length from 0 to 40 mm, such as 10mm");
    print.margin_mm = *length * 1e3;
  }
  if (print.map.empty())
    throw InputError("robosim map print requires a map: a file, or the name of a sample map");
  if (print.out.empty()) throw InputError("robosim map print requires --out, as in --out floor.pdf");
  return print;
}

}  // namespace robosim::cli
