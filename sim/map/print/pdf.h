// Writes a PDF with drawings in millimetres: x to the right, y up, from a page's lower left corner.
#pragma once

#include <memory>
#include <string>

#include "sim/base/vec.h"
#include "sim/map/floor_image.h"
#include "sim/map/print/shapes.h"

namespace robosim::print {

class Pdf {
 public:
  /// If `compressed` is true, the contents of pages are compressed. Throws ToolMissing in a build without
  /// libhpdf.
  Pdf(const std::string& title, bool compressed);
  ~Pdf();

  void begin_page(double width, double height);
  /// Clips all drawings to a box until end_part().
  void begin_part(const Box& clip);
  void end_part();
  /// Sets the grey of lines, areas and text: 0 = black, 1 = white.
  void set_grey(double level);
  void set_colour(double red, double green, double blue);
  void set_pen(double width, bool round_ends);
  void move_to(Vec2 p);
  void line_to(Vec2 p);
  /// Draws an arc (see Line) of at most 22.5 degrees from the pen's position.
  void arc_to(const Line& arc);
  void add_box(const Box& box);
  /// Loads a picture, in greys. draw_picture() draws the picture at the size of the box.
  void load_picture(const map::FloorImage& image);
  void draw_picture(const Box& box);
  void stroke();
  void fill();
  /// Draws text in Helvetica. Characters beyond Latin-1 become `?`.
  void text(Vec2 at, double size, const std::string& utf8);
  double width_of(double size, const std::string& utf8) const;

  /// Returns the file. Equal drawings give equal bytes, since the file has no date. Throws
  /// std::runtime_error.
  std::string bytes();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace robosim::print
