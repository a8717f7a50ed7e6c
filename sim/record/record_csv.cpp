#include "sim/record/record_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "sim/base/csv.h"
#include "sim/base/error.h"
#include "sim/base/file.h"

namespace robosim::record {
void CsvRecord::add(const wire::Event& event) {
  if (const auto* started = std::get_if<wire::Started>(&event)) {
    text_ = "t_us,x_mm,y_mm,yaw_rad,speed_mm_s,cross_track_mm,left,right";
    for (const std::string& name : started->readings) text_ += "," + csv_field(name);
    text_ += "\n";
  } else if (const auto* s = std::get_if<wire::Sample>(&event)) {
    auto out = std::back_inserter(text_);
    fmt::format_to(out, "{},{},{},{},{},{},{},{}", s->t_us, s->x_mm, s->y_mm, s->yaw_rad, s->speed_mm_s,
                   s->cross_track_mm, s->left, s->right);
    for (const double reading : s->readings) fmt::format_to(out, ",{}", reading);
    text_ += '\n';
  }
}

void CsvRecord::save() const { write_file(path_, text_); }

const std::vector<std::string>& record_endings() {
  static const std::vector<std::string> endings{".csv", ".vcd"};
  return endings;
}

void check_record_ending(const std::filesystem::path& path) {
  const auto& known = record_endings();
  if (std::find(known.begin(), known.end(), path.extension().string()) != known.end()) return;
  throw InputError(path.string() + ": the file's ending chooses the format, and it must be " + one_of(known));
}

}  // namespace robosim::record
