// The stripes of a path. An implementation detail of Stripes.
#pragma once

#include <vector>

#include "sim/grid/stripes.h"

namespace robosim::grid {

/// Appends them: straights whole, arcs in quarters at most, cut where gaps begin and end. A gap takes half
/// their width from the stripes beside it, as among cells. `paints`: those of the map, paints_of.
void add_stripes(const Path& path, const std::vector<Paint>& paints, std::vector<Stripe>& stripes);

}  // namespace robosim::grid
