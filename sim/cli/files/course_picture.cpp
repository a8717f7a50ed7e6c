#include "sim/cli/files/course_picture.h"

#include <fmt/format.h>

#include "sim/grid/stripes.h"
#include "sim/tui/floor_picture.h"

namespace robosim::cli {

std::string draw_course(const grid::Map& map, const grid::Start& start, const grid::PictureOptions& options) {
  tui::FloorPicture picture(map);
  picture.look_at(tui::fit(map, tui::area_of(map), options.columns, options.rows - 1));
  const Pose pose = grid::Stripes(map, map.cell_m).pose_of(start);
  const char32_t arrow = tui::arrow(pose.yaw());
  tui::Frame frame(picture.window().columns, picture.window().rows);
  const tui::Look look{!options.ascii, false};
  // Passes colour = true, so that the line is drawn in braille. A trail would look the same, but none is
  // drawn.
  picture.draw(frame, 0, 0, {{pose.position, {arrow, tui::Ink::mark}}}, {!options.ascii, true});
  std::string text = tui::to_text(frame, look);
  std::string sign;
  tui::append(sign, arrow, look.utf8);
  return text + fmt::format("{} start at {:.0f} mm, {:.0f} mm\n", sign, 1e3 * pose.position.x,
                            1e3 * pose.position.y);
}

}  // namespace robosim::cli
