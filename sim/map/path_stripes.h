// The stripes of a path. An implementation detail of Stripes.
#pragma once

#include <vector>

#include "sim/map/stripes.h"

namespace robosim::map {

/// Appends the path's stripes. Splits arcs into parts of at most a quarter of a circle. Splits all pieces at
/// both ends of each gap. A gap shortens each neighbouring stripe by half the stripe's width, like a gap cell
/// (stripes.h). `paints` is the map's paints_of().
void add_stripes(const Path& path, const std::vector<Paint>& paints, std::vector<Stripe>& stripes);

}  // namespace robosim::map
