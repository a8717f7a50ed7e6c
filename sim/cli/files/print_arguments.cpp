#include "sim/cli/files/print_arguments.h"

#include "sim/base/error.h"
#include "sim/base/units.h"
#include "sim/cli/options.h"
#include "sim/print/sheets.h"

namespace robosim::cli {

Command parse_print(const std::vector<std::string>& words) {
  PrintArguments print;
  std::string margin;
  Options options("map print", "Writes a map's floor as a PDF in true size, on sheets to lay on the floor.");
  options.positional("MAP", print.map, "file, or name of a sample map");
  options.text("--out", print.out, "FILE.pdf", "is written");
  options.text("--paper", print.paper, "A4|A3", "default: A4");
  options.text("--margin", margin, "LENGTH", "that the printer leaves white; default: 5mm");
  options.flag("--black-on-white", print.black_on_white,
               "saves ink: dark lines on white paper, though the map is white on black");
  if (const auto help = options.parse(words)) return PrintText{*help};
  check_choice("--paper", print.paper, {"A4", "A3"});
  if (!margin.empty()) {
    const auto length = parse_quantity(margin, Dimension::length);
    if (!length || !(*length >= 0.0 && *length * 1e3 <= print::kMostMargin))
      refuse_value("--margin", margin, "0 to 40 mm, such as 10mm");
    print.margin_mm = *length * 1e3;
  }
  if (print.map.empty())
    throw InputError("robosim map print needs a map: a file, or the name of a sample map");
  if (print.out.empty()) throw InputError("robosim map print needs --out, as in --out floor.pdf");
  return print;
}

}  // namespace robosim::cli
