#include <fmt/format.h>

#include <cmath>

#include "sim/campaign/calibrate/calibrate.h"

namespace robosim::calibrate {
namespace {

constexpr double kSure = 0.1;  // values with a larger relative uncertainty are called rough

std::string line_of(const Figure& figure, const Found& found, const std::string& name, bool first) {
  const std::string value = shown(figure, found);
  std::string text = fmt::format("  {:<24} {:<28} ±{:.0f} %{}", name, value,
                                 std::ceil(100.0 * unsureness(figure, found) - 1e-9),
                                 figure.against > 0.0 ? " of white to black" : "");
  if (first && figure.before > 0.0)
    text +=
        fmt::format("   was {:.4g}{}{}", figure.before / figure.scale, *figure.unit ? " " : "", figure.unit);
  if (first && !figure.remark.empty()) text += "   " + figure.remark;
  return text + "\n";
}

std::string lines_of(const Figure& figure) {
  std::string text;
  const std::string name = figure.table + "." + figure.key;
  if (figure.of.empty()) return line_of(figure, figure.found.front(), name, true);
  for (std::size_t i = 0; i < figure.of.size(); ++i)
    text += line_of(figure, figure.found[i], fmt::format("{}  {}", name, figure.of[i]), i == 0);
  return text;
}

}  // namespace

std::string report(const Calibration& result) {
  std::string text =
      fmt::format("{}: values from the logs, ± twice the standard deviation\n", result.robot.name);
  std::string rough;
  for (const Figure& figure : result.figures)
    (least_sure(figure) <= kSure ? text : rough) += lines_of(figure);
  if (!rough.empty()) text += "rough: uncertain by more than a tenth\n" + rough;
  if (!result.unsure.empty()) text += "too uncertain to be written\n";
  for (const Figure& figure : result.unsure) text += lines_of(figure);
  for (const PartFit& part : result.sweep.parts) {
    std::size_t crossings = 0;
    double dark = 0.0, light = 0.0;
    for (const ElementFit& element : part.elements) {
      crossings += element.crossings;
      dark += element.dark_noise;
      light += element.noise;
    }
    text += fmt::format(
        "{}: {} crossings, readings {:.2f} mm apart; the noise over black is {:.0f} % of the noise over "
        "white",
        part.part->name, crossings, 1e3 * part.spacing, light > 0.0 ? 100.0 * dark / light : 0.0);
    if (part.seen.value > 0.0)
      text += fmt::format("; the tape is {:.1f} mm wide at half depth by the wheels, {:.1f} mm by --tape",
                          1e3 * part.seen.value, 1e3 * result.tape_m);
    text += "\n";
  }
  if (result.drive) {
    text +=
        fmt::format("motors: time constant {:.0f} ms straight on", 1e3 * result.drive->time_constant.value);
    text += result.drive->curves.empty()
                ? fmt::format("; the model meets the drives within {:.1f} times their measuring accuracy\n",
                              result.drive->rms)
                : fmt::format("; the model meets {} drives within {:.1f} counts (root mean square)\n",
                              result.drive->curves.size(), result.drive->rms);
  }
  text += "not determined\n";
  for (const std::string& sentence : result.not_told) text += "  " + sentence + "\n";
  return text;
}

}  // namespace robosim::calibrate
