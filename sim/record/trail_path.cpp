#include "sim/record/trail_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace robosim::record {
namespace {

using TrailPoint = SvgRecorder::Point;

double distance_mm(const TrailPoint& p, const TrailPoint& a, const TrailPoint& b) {
  const double dx = b.x_mm - a.x_mm, dy = b.y_mm - a.y_mm;
  const double square = dx * dx + dy * dy;
  const double along =
      square > 0.0 ? std::clamp(((p.x_mm - a.x_mm) * dx + (p.y_mm - a.y_mm) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x_mm - a.x_mm - along * dx, p.y_mm - a.y_mm - along * dy);
}

}  // namespace

std::string speed_colour(int number) {
  // Colours of the colour map "plasma", by van der Walt and Smith. Its first and last colours are omitted:
  // they would not stand out from the line or the floor.
  static constexpr const char* kPlasma[kSpeedColours] = {
      "#5402a3", "#7e03a8", "#9c179e", "#b6308b", "#cc4778", "#de5f65", "#ed7953", "#f89540", "#fdb42f"};
  return kPlasma[std::clamp(number, 0, kSpeedColours - 1)];
}

std::vector<Stretch> stretches(const std::vector<TrailPoint>& trail, double fastest_mm_s) {
  std::vector<Stretch> all;
  for (std::size_t i = 1; i < trail.size(); ++i) {
    const TrailPoint& b = trail[i];
    if (b.carried) continue;
    const double share = std::fabs(b.speed_mm_s) / std::max(fastest_mm_s, 1.0);
    const int colour = std::min(static_cast<int>(share * kSpeedColours), kSpeedColours - 1);
    if (!all.empty() && all.back().last == i - 1 && all.back().colour == colour)
      all.back().last = i;
    else
      all.push_back({i - 1, i, colour});
  }
  return all;
}

std::vector<std::size_t> corners(const std::vector<TrailPoint>& trail, std::size_t first, std::size_t last,
                                 double tolerance_mm) {
  std::vector<std::size_t> kept{first, last};
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    std::size_t farthest = from;
    double most = tolerance_mm;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double off = distance_mm(trail[i], trail[from], trail[to]);
      if (off > most) most = off, farthest = i;
    }
    if (farthest == from) continue;
    kept.push_back(farthest);
    open.push_back({from, farthest});
    open.push_back({farthest, to});
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace robosim::record
