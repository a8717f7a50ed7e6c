#include "sim/map/paint.h"

#include "sim/map/map.h"

namespace robosim::map {

Paint usual_paint(const Map& map) { return {map.line_m, std::nullopt, map.worn, map.gloss}; }

std::vector<Paint> paints_of(const Map& map) {
  std::vector<Paint> all{usual_paint(map)};
  all.insert(all.end(), map.course.paints.begin(), map.course.paints.end());
  for (Paint& paint : all)
    if (!paint.colour) paint.colour = Colour{map.light_line ? Hue::white : Hue::black};
  return all;
}

bool is_plain(const Map& map) { return map.course.paints.empty() && map.worn == 0.0 && map.gloss == 0.0; }

}  // namespace robosim::map
