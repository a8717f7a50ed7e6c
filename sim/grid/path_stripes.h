// The stripes of a path. An implementation detail of Stripes.
#pragma once

#include <vector>

#include "sim/grid/stripes.h"

namespace robosim::grid {

/// Appends the path's stripes: straights whole, arcs in quarters at most, cut at both ends of gaps. A gap
/// takes half of their width from the neighbouring stripes, as between cells. `paints` is paints_of() the
/// map.
void add_stripes(const Path& path, const std::vector<Paint>& paints, std::vector<Stripe>& stripes);

}  // namespace robosim::grid
