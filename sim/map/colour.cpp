#include "sim/map/colour.h"

#include <fmt/format.h>

#include <cmath>

namespace robosim::map {

std::string Colour::drawn() const {
  if (hue != Hue::grey) return figures().drawn;
  constexpr double kBlack = 0x20, kWhite = 0xFF;
  const int level = static_cast<int>(std::lround(kWhite + black * (kBlack - kWhite)));
  return fmt::format("#{0:02x}{0:02x}{0:02x}", level);
}

}  // namespace robosim::map
