#include "sim/record/record_csv.h"

#include <fmt/format.h>

#include <iterator>

#include "sim/base/csv.h"
#include "sim/base/file.h"

namespace robosim::record {
void CsvRecorder::add(const wire::Event& event) {
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

void CsvRecorder::finish(const wire::RunResult&) { write_file(path_, text_); }

}  // namespace robosim::record
