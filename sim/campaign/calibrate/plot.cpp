#include "sim/campaign/calibrate/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "sim/base/markup.h"
#include "sim/campaign/calibrate/edge_fit.h"

namespace robosim::calibrate {
namespace {

constexpr double kWidth = 460.0, kHeight = 280.0, kLeft = 56.0, kRight = 14.0, kTop = 34.0,
                 kBottom = 40.0;         // px
constexpr std::size_t kMostDots = 1500;  // maximum in a panel
constexpr const char* kMeasured[2] = {"#0072b2", "#d55e00"};

/// Returns a tick distance of 1, 2 or 5 times a power of ten, so that about five ticks fit.
double tick_of(double range) {
  const double rough = range / 5.0, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (rough <= factor * power) return factor * power;
  return 10.0 * power;
}

struct Span {
  double low = 0.0, high = 1.0;
};

class Panel {
 public:
  Panel(std::string& text, double x, double y, Span across, Span up)
      : text_(text), x_(x), y_(y), across_(across), up_(up) {}

  void frame(const std::string& title, const std::string& across, const std::string& up) {
    put(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="none" stroke="#999"/>)",
        x_ + kLeft, y_ + kTop, kWidth - kLeft - kRight, kHeight - kTop - kBottom);
    put(R"(<text x="{:.1f}" y="{:.1f}" font-weight="600">{}</text>)", x_ + kLeft, y_ + kTop - 10.0,
        markup_text(title));
    const double step_x = tick_of(across_.high - across_.low), step_y = tick_of(up_.high - up_.low);
    for (double v = std::ceil(across_.low / step_x) * step_x; v <= across_.high + 1e-9; v += step_x)
      put(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="middle">{:.4g}</text>)", px(v),
          y_ + kHeight - kBottom + 15.0, std::fabs(v) < 1e-9 * step_x ? 0.0 : v);
    for (double v = std::ceil(up_.low / step_y) * step_y; v <= up_.high + 1e-9; v += step_y) {
      put(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="end">{:.4g}</text>)", x_ + kLeft - 5.0, py(v) + 4.0,
          std::fabs(v) < 1e-9 * step_y ? 0.0 : v);
      put(R"(<path d="M{:.1f} {:.1f}H{:.1f}" stroke="#ddd"/>)", x_ + kLeft, py(v), x_ + kWidth - kRight);
    }
    put(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="middle" fill="#444">{}</text>)",
        x_ + 0.5 * (kLeft + kWidth - kRight), y_ + kHeight - 8.0, markup_text(across));
    put(R"x(<text transform="translate({:.1f} {:.1f}) rotate(-90)" text-anchor="middle" fill="#444">{}</text>)x",
        x_ + 14.0, y_ + 0.5 * (kTop + kHeight - kBottom), markup_text(up));
  }

  void dots(const std::vector<double>& x, const std::vector<double>& y, const char* colour) {
    const std::size_t stride = x.size() / kMostDots + 1;
    std::string path;
    for (std::size_t i = 0; i < x.size(); i += stride)
      if (y[i] >= up_.low && y[i] <= up_.high) path += fmt::format("M{:.1f} {:.1f}h0", px(x[i]), py(y[i]));
    put(R"(<path d="{}" stroke="{}" stroke-opacity="0.5" stroke-width="3" stroke-linecap="round"/>)", path,
        colour);
  }

  void line(const std::vector<double>& x, const std::vector<double>& y) {
    std::string path;
    for (std::size_t i = 0; i < x.size(); ++i)
      path += fmt::format("{}{:.1f} {:.1f}", i ? 'L' : 'M', px(x[i]), py(y[i]));
    put(R"(<path d="{}" fill="none" stroke="#1f1f1f" stroke-width="1.4"/>)", path);
  }

  void note(double row, const std::string& text, const char* colour) {
    put(R"(<text x="{:.1f}" y="{:.1f}" fill="{}">{}</text>)", x_ + kLeft + 8.0, y_ + kTop + 16.0 + 14.0 * row,
        colour, markup_text(text));
  }

 private:
  double px(double v) const {
    return x_ + kLeft + (v - across_.low) / (across_.high - across_.low) * (kWidth - kLeft - kRight);
  }
  double py(double v) const {
    return y_ + kHeight - kBottom - (v - up_.low) / (up_.high - up_.low) * (kHeight - kTop - kBottom);
  }
  template <class... Values>
  void put(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
    text_ += '\n';
  }

  std::string& text_;
  double x_, y_;
  Span across_, up_;
};

void draw_edges(std::string& text, double x, double y, const PartFit& part, double tape_m) {
  std::vector<double> places, blackness;
  Span across{0.0, 0.0};
  for (const EdgePoint& point : part.points) {
    places.push_back(1e3 * point.s);
    blackness.push_back(point.blackness);
    across.low = std::min(across.low, places.back());
    across.high = std::max(across.high, places.back());
  }
  Panel panel(text, x, y, across, {-0.2, 1.2});
  panel.frame(part.part->name + ": edges of the tape", "mm inwards of the edge", "blackness");
  panel.dots(places, blackness, kMeasured[0]);
  std::vector<double> curve_x, curve_y;
  for (int i = 0; i <= 200; ++i) {
    curve_x.push_back(across.low + (across.high - across.low) * i / 200.0);
    curve_y.push_back(share_on_tape(1e-3 * curve_x.back(), part.footprint.value, tape_m));
  }
  panel.line(curve_x, curve_y);
  panel.note(0,
             fmt::format("footprint {:.2f} ± {:.2f} mm", 1e3 * part.footprint.value,
                         1e3 * spread_of(part.footprint)),
             "#1f1f1f");
}

void draw_drive(std::string& text, double x, double y, const DriveCurve& curve) {
  Span up{0.0, 0.0};
  for (const auto& all : {&curve.measured, &curve.fitted})
    for (const auto& side : *all)
      for (const double turns : side) up = {std::min(up.low, turns), std::max(up.high, turns)};
  const double margin = 0.05 * (up.high - up.low);
  Panel panel(text, x, y, {curve.t.front(), curve.t.back()}, {up.low - margin, up.high + margin});
  panel.frame(fmt::format("drive with {} and {}", curve.told[0], curve.told[1]), "s", "turns of the wheel");
  for (const std::size_t side : {0u, 1u}) {
    panel.dots(curve.t, curve.measured[side], kMeasured[side]);
    panel.note(static_cast<double>(side) + (up.high < -up.low ? 12.0 : 0.0), side == 0 ? "left" : "right",
               kMeasured[side]);
  }
  for (const std::size_t side : {0u, 1u}) panel.line(curve.t, curve.fitted[side]);
}

}  // namespace

std::string plot(const Calibration& result) {
  std::size_t panels = 0;
  for (const PartFit& part : result.sweep.parts) panels += !part.points.empty();
  if (result.drive) panels += result.drive->curves.size();
  const std::size_t columns = std::clamp<std::size_t>(panels, 1, 3),
                    rows = std::max<std::size_t>((panels + columns - 1) / columns, 1);
  const double width = kWidth * static_cast<double>(columns),
               height = kHeight * static_cast<double>(rows) + 26.0;
  std::string text = fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:.0f} {1:.0f}" width="{0:.0f}" height="{1:.0f}" role="img" font-family="system-ui, sans-serif" font-size="12">
<title>{2}: measured against fitted</title>
<rect width="100%" height="100%" fill="#fff"/>
<text x="12" y="18">{2}: dots measured, lines fitted</text>
)",
      width, height, markup_text(result.robot.name));
  std::size_t at = 0;
  const auto place = [&] {
    const std::pair<double, double> p{kWidth * static_cast<double>(at % columns),
                                      26.0 + kHeight * static_cast<double>(at / columns)};
    ++at;
    return p;
  };
  for (const PartFit& part : result.sweep.parts) {
    if (part.points.empty()) continue;
    const auto [x, y] = place();
    draw_edges(text, x, y, part, result.tape_m);
  }
  if (result.drive)
    for (const DriveCurve& curve : result.drive->curves) {
      const auto [x, y] = place();
      draw_drive(text, x, y, curve);
    }
  return text + "</svg>\n";
}

}  // namespace robosim::calibrate
