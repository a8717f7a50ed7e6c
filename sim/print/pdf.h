// A PDF that is drawn in millimetres, x to the right and y up from a page's lower left corner.
#pragma once

#include <memory>
#include <string>

#include "sim/base/vec.h"
#include "sim/grid/floor_image.h"
#include "sim/print/shapes.h"

namespace robosim::print {

class Pdf {
 public:
  /// `compressed`: its pages' contents. Throws ToolMissing in a build without the library.
  Pdf(const std::string& title, bool compressed);
  ~Pdf();

  void begin_page(double width, double height);
  /// Of what follows, until end_part().
  void begin_part(const Box& clip);
  void end_part();
  /// 0 = black, 1 = white: of lines, areas and text.
  void set_grey(double level);
  void set_colour(double red, double green, double blue);
  void set_pen(double width, bool round_ends);
  void move_to(Vec2 p);
  void line_to(Vec2 p);
  /// An arc as Line has it, from where the pen is; at most an eighth of a half turn.
  void arc_to(const Line& arc);
  void add_box(const Box& box);
  /// A picture, in greys: draws what was loaded, as large as the box.
  void load_picture(const grid::FloorImage& image);
  void draw_picture(const Box& box);
  void stroke();
  void fill();
  /// In Helvetica; characters beyond Latin-1 become `?`.
  void text(Vec2 at, double size, const std::string& utf8);
  double width_of(double size, const std::string& utf8) const;

  /// The file. The same drawing gives the same bytes: no date is in them. Throws std::runtime_error.
  std::string bytes();

 private:
  struct Inside;
  std::unique_ptr<Inside> in_;
};

}  // namespace robosim::print
