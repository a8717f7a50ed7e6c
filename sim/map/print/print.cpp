#include "sim/map/print/print.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/pluralize.h"
#include "sim/map/print/pdf.h"
#include "sim/map/stripes.h"

namespace robosim::print {
namespace {

constexpr double kLongest = 200.0;  // in mm: longer lines are split, so that a page can skip distant pieces
constexpr double kHairline = 0.15;
constexpr double kBar = 100.0;

class Printer {
 public:
  Printer(const map::Map& map, const Options& options)
      : map_(map),
        dark_floor_(map.light_line && !options.swapped && !map.image),
        shapes_(map),
        sheets_(divide(map, shapes_, options.paper, options.margin, dark_floor_)),
        pdf_(map.name, options.compressed) {
    if (map.image) pdf_.load_picture(*map.image);
  }

  Printed print() {
    overview();
    for (const Sheet& sheet : sheets_.printed) page(sheet);
    return {pdf_.bytes(), sheets_};
  }

 private:
  // Converts coordinates from the floor to the page.
  struct View {
    Vec2 shift;
    double scale = 1.0;
    Vec2 operator()(Vec2 p) const { return p * scale + shift; }
    Box operator()(const Box& b) const {
      const Vec2 low = (*this)(Vec2{b.left, b.low}), high = (*this)(Vec2{b.right, b.high});
      return {low.x, low.y, high.x, high.y};
    }
  };

  Box floor() const { return {0.0, 0.0, sheets_.width, sheets_.height}; }

  // Draws the part of the floor's paint that is within the box.
  void paint(const Box& box, const View& view, double least_pen) {
    if (dark_floor_) {
      pdf_.set_grey(0.0);
      pdf_.add_box(view(floor()));
      pdf_.fill();
    }
    if (map_.image)
      pdf_.draw_picture(view(Box{0.0, 0.0, map_.image->wide_m() * 1e3, map_.image->high_m() * 1e3}));
    pdf_.set_grey(dark_floor_ ? 1.0 : 0.0);
    bool any = false;
    shapes_.painted_cells_near(box, [&](const Box& run) {
      pdf_.add_box(view(run));
      any = true;
    });
    if (any) pdf_.fill();
    areas(box, view, false);
    for (std::size_t paint = 0; paint < shapes_.paints().size(); ++paint) {
      any = false;
      colour(*shapes_.paints()[paint].colour);
      pdf_.set_pen(std::max(1e3 * shapes_.paints()[paint].width * view.scale, least_pen), true);
      shapes_.lines_near(paint, box, kLongest / view.scale, [&](const Line& line) {
        pdf_.move_to(view(line.from));
        if (line.radius > 0.0)
          pdf_.arc_to({view(line.from), view(line.to), view(line.centre), line.radius * view.scale});
        else
          pdf_.line_to(view(line.to));
        any = true;
      });
      if (any) pdf_.stroke();
    }
    for (const Bar& bar : shapes_.bars()) {
      const Box around{std::min(bar.from.x, bar.to.x), std::min(bar.from.y, bar.to.y),
                       std::max(bar.from.x, bar.to.x), std::max(bar.from.y, bar.to.y)};
      if (!around.wider(bar.width).meets(box)) continue;
      colour(*shapes_.paints()[bar.paint].colour);
      pdf_.set_pen(bar.width * view.scale, false);
      pdf_.move_to(view(bar.from));
      pdf_.line_to(view(bar.to));
      pdf_.stroke();
    }
    areas(box, view, true);
    outlines(box, view);
  }

  void areas(const Box& box, const View& view, bool over_lines) {
    for (const map::Area& area : map_.course.areas) {
      const Vec2 middle = area.middle.position * 1e3;
      const double reach = area.reach() * 1e3;
      if (area.over_lines != over_lines ||
          !Box{middle.x, middle.y, middle.x, middle.y}.wider(reach).meets(box))
        continue;
      colour(area.colour);
      if (area.radius > 0.0) {
        pdf_.set_pen(2.0 * reach * view.scale, true);
        pdf_.move_to(view(middle));
        pdf_.line_to(view(middle));
      } else {
        const Vec2 half = area.middle.heading * (area.half_length * 1e3);
        pdf_.set_pen(2e3 * area.half_width * view.scale, false);
        pdf_.move_to(view(middle - half));
        pdf_.line_to(view(middle + half));
      }
      pdf_.stroke();
    }
  }

  // Sets a colour. Exchanges black and white for a map with light lines.
  void colour(const map::Colour& colour) {
    const auto swapped = [this](double grey) { return map_.light_line && !dark_floor_ ? 1.0 - grey : grey; };
    switch (colour.hue) {
      case map::Hue::black:
        return pdf_.set_grey(swapped(0.0));
      case map::Hue::white:
        return pdf_.set_grey(swapped(1.0));
      case map::Hue::grey:
        return pdf_.set_grey(swapped(1.0 - colour.black));
      case map::Hue::green:
        return pdf_.set_colour(0.12, 0.62, 0.30);
      case map::Hue::silver:
        return pdf_.set_colour(0.73, 0.77, 0.81);
      case map::Hue::red:
        return pdf_.set_colour(0.78, 0.20, 0.17);
    }
  }

  // Draws the outlines of objects with lines that are too thin for a sensor to see.
  void outlines(const Box& box, const View& view) {
    pdf_.set_grey(0.6);
    pdf_.set_pen(kHairline, false);
    bool any = false;
    shapes_.walls_near(box, [&](const Box& run) {
      pdf_.add_box(view(run));
      any = true;
    });
    const double half = 0.5 * map_.cell_m * 1e3;
    for (const Vec2 p : shapes_.obstacles_near(box)) {
      pdf_.add_box(view(Box{p.x - half, p.y - half, p.x + half, p.y + half}));
      any = true;
    }
    if (any) pdf_.stroke();
    for (const map::Hill& hill : map_.course.hills) {
      const Vec2 along = hill.middle.heading * (hill.half_length * 1e3);
      const Vec2 across = left_of(hill.middle.heading) * (hill.half_width * 1e3);
      const Vec2 middle = hill.middle.position * 1e3;
      if (!Box{middle.x, middle.y, middle.x, middle.y}.wider(hill.reach() * 1e3).meets(box)) continue;
      pdf_.move_to(view(middle - along - across));
      for (const Vec2 corner : {middle + along - across, middle + along + across, middle - along + across,
                                middle - along - across})
        pdf_.line_to(view(corner));
      pdf_.stroke();
    }
  }

  // Draws a mark that is visible on dark and on light floors.
  void mark(Vec2 from, Vec2 to) {
    for (const auto& [width, grey] : {std::pair{4.0 * kHairline, 1.0}, {kHairline, 0.0}}) {
      pdf_.set_pen(width, false);
      pdf_.set_grey(grey);
      pdf_.move_to(from);
      pdf_.line_to(to);
      pdf_.stroke();
    }
  }

  void page(const Sheet& sheet) {
    const Paper& paper = sheets_.paper;
    const double edge = sheets_.margin, cut = edge + kFlap;
    const Box piece = sheets_.piece(sheet);
    const Box shown{edge, edge, paper.width - edge, paper.height - edge};
    pdf_.begin_page(paper.width, paper.height);
    pdf_.begin_part(shown);
    paint(piece.wider(kFlap), {Vec2{cut - piece.left, cut - piece.low}}, 0.0);
    pdf_.end_part();
    for (const double x : {cut, paper.width - cut}) {
      const double out = x < 0.5 * paper.width ? -1.0 : 1.0;
      for (const double y : {cut, paper.height - cut}) {
        const double up = y < 0.5 * paper.height ? -1.0 : 1.0;
        mark({x + 1.5 * out, y}, {x + (kFlap - 1.0) * out, y});
        mark({x, y + 1.5 * up}, {x, y + (kFlap - 1.0) * up});
      }
    }
    label(sheet, {cut + 4.0, edge + 0.8});
  }

  // Writes the label, 8 mm high, in the lower flap.
  void label(const Sheet& sheet, Vec2 at) {
    pdf_.set_grey(1.0);
    pdf_.add_box({at.x - 2.0, at.y, at.x + kBar + 2.0, at.y + 8.0});
    pdf_.fill();
    pdf_.set_grey(0.0);
    pdf_.set_pen(0.25, false);
    const double y = at.y + 2.0;
    pdf_.move_to({at.x, y});
    pdf_.line_to({at.x + kBar, y});
    for (int i = 0; i <= 10; ++i) {
      const double tick = i % 10 == 0 ? 1.6 : 0.8;
      pdf_.move_to({at.x + 10.0 * i, y - tick});
      pdf_.line_to({at.x + 10.0 * i, y + tick});
    }
    pdf_.stroke();
    const std::string number = fmt::format("{}-{}", sheet.row, sheet.column);
    pdf_.text({at.x + 0.5, at.y + 4.4}, 3.6, number);
    pdf_.text({at.x + 2.5 + pdf_.width_of(3.6, number), at.y + 4.4}, 2.5,
              fmt::format("row {} of {}, column {} of {}: {}", sheet.row, sheets_.rows, sheet.column,
                          sheets_.columns, shortened(map_.name, 2.5, 34.0)));
    const std::string bar = "100 mm";
    pdf_.text({at.x + kBar - 2.0 - pdf_.width_of(2.5, bar), at.y + 4.4}, 2.5, bar);
  }

  std::string shortened(std::string text, double size, double most) const {
    if (pdf_.width_of(size, text) <= most) return text;
    while (!text.empty() && (pdf_.width_of(size, text + "...") > most || (text.back() & 0xC0) == 0x80))
      text.pop_back();
    return text + "...";
  }

  void overview() {
    const Paper& paper = sheets_.paper;
    const double margin = std::max(sheets_.margin, 15.0);
    pdf_.begin_page(paper.width, paper.height);
    pdf_.set_grey(0.0);
    double y = paper.height - margin - 5.0;
    pdf_.text({margin, y}, 6.0, shortened(map_.name, 6.0, paper.width - 2.0 * margin));
    // Total size of all sheets.
    const double wide = sheets_.columns * sheets_.net_width(), high = sheets_.rows * sheets_.net_height();
    constexpr double kText = 42.0;
    const double scale =
        std::min({(paper.width - 2.0 * margin) / wide, (paper.height - 2.0 * margin - kText) / high, 1.0});
    const std::size_t count = sheets_.printed.size();
    const std::size_t all =
        static_cast<std::size_t>(sheets_.rows) * static_cast<std::size_t>(sheets_.columns);
    y -= 3.0;
    const bool worn = std::any_of(shapes_.paints().begin(), shapes_.paints().end(),
                                  [](const map::Paint& paint) { return paint.worn > 0.0; });
    for (const std::string& line :
         {fmt::format("{:.10g} x {:.10g} mm, {}, line {:.10g} mm wide; shown here at 1 : {:.1f}",
                      sheets_.width, sheets_.height,
                      map_.image    ? map_.image->name()
                      : dark_floor_ ? "white on black"
                                    : "black on white",
                      1e3 * map_.line_m, 1.0 / scale),
          fmt::format("{} in {} of {}, numbered row-column{}.", pluralize(count, "sheet"),
                      pluralize(static_cast<std::size_t>(sheets_.rows), "row"),
                      pluralize(static_cast<std::size_t>(sheets_.columns), "column"),
                      count < all ? "; parts without paint have no sheet" : ""),
          std::string("Print at 100 %, not fitted to the page: on each sheet the bar must measure 100 mm."),
          std::string("Cut off the left and the lower edge along the marks. Lay each sheet on the flaps "
                      "of the sheets to its left and below it."),
          std::string(worn ? "Worn paint is printed whole." : ""),
          fmt::format("From one sheet to the next, the marks are {:.10g} mm apart to the right, and "
                      "{:.10g} mm upward.",
                      sheets_.net_width(), sheets_.net_height())}) {
      if (line.empty()) continue;
      y -= 5.0;
      pdf_.text({margin, y}, 3.4, line);
    }
    const View view{{margin, paper.height - margin - kText - sheets_.height * scale}, scale};
    pdf_.begin_part({margin - 1.0, margin - 1.0, paper.width - margin + 1.0, paper.height - margin});
    paint(floor(), view, kHairline);
    pdf_.set_grey(0.5);
    pdf_.set_pen(kHairline, false);
    pdf_.add_box(view(floor()));
    pdf_.stroke();
    start(view);
    pdf_.end_part();
    numbers(view);
  }

  void numbers(const View& view) {
    pdf_.set_colour(0.80, 0.30, 0.0);
    pdf_.set_pen(kHairline, false);
    for (const Sheet& sheet : sheets_.printed) pdf_.add_box(view(sheets_.piece(sheet)));
    pdf_.stroke();
    for (const Sheet& sheet : sheets_.printed) {
      const Box box = view(sheets_.piece(sheet));
      const std::string number = fmt::format("{}-{}", sheet.row, sheet.column);
      const double size = std::clamp(0.7 * (box.right - box.left) / pdf_.width_of(1.0, number), 0.5, 4.0);
      pdf_.text({0.5 * (box.left + box.right - pdf_.width_of(size, number)), box.high - 1.2 * size}, size,
                number);
    }
  }

  // Draws an arrow at a robot's start.
  void start(const View& view) {
    const Pose pose = map::Stripes(map_, 0.0).pose_of(map::default_start(map_));
    const Vec2 at = view(pose.position * 1e3);
    const Vec2 tip = at + pose.heading * 6.0, left = left_of(pose.heading);
    pdf_.set_colour(0.0, 0.45, 0.70);
    pdf_.set_pen(0.6, true);
    pdf_.move_to(at);
    pdf_.line_to(tip);
    pdf_.move_to(tip - pose.heading * 2.0 + left * 1.5);
    pdf_.line_to(tip);
    pdf_.line_to(tip - pose.heading * 2.0 - left * 1.5);
    pdf_.stroke();
  }

  const map::Map& map_;
  const bool dark_floor_;
  const Shapes shapes_;
  const Sheets sheets_;
  Pdf pdf_;
};

}  // namespace

Printed print_map(const map::Map& map, const Options& options) { return Printer(map, options).print(); }

}  // namespace robosim::print
