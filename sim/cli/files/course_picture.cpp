#include "sim/cli/files/course_picture.h"

#include <fmt/format.h>

#include "sim/map/stripes.h"
#include "sim/view/terminal/floor_picture.h"

namespace robosim::cli {

std::string draw_course(const map::Map& map, const map::Start& start, const map::PictureOptions& options) {
  terminal::FloorPicture picture(map);
  picture.look_at(terminal::fit(map, terminal::area_of(map), options.columns, options.rows - 1));
  const Pose pose = map::Stripes(map, map.cell_m).pose_of(start);
  const char32_t arrow = terminal::arrow(pose.yaw());
  terminal::Frame frame(picture.window().columns, picture.window().rows);
  const terminal::Look look{!options.ascii, false};
  // Passes colour = true, so that the line is drawn in braille dots. In pictures without colours, the line
  // consists of other signs, because dots would look like a robot's trail. This picture has no trail.
  picture.draw(frame, 0, 0, {{pose.position, {arrow, terminal::Ink::mark}}}, {!options.ascii, true});
  std::string text = terminal::to_text(frame, look);
  std::string sign;
  terminal::append(sign, arrow, look.utf8);
  return text + fmt::format("{} start at {:.0f} mm, {:.0f} mm\n", sign, 1e3 * pose.position.x,
                            1e3 * pose.position.y);
}

}  // namespace robosim::cli
