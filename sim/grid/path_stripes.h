// The stripes of a path. An implementation detail of Stripes.
#pragma once

#include <vector>

#include "sim/grid/stripes.h"

namespace robosim::grid {

/// Appends them: straights whole, arcs in quarters at most, cut where gaps begin and end. A gap takes line/2
/// from the stripes beside it, as among cells.
void add_stripes(const Path& path, double line_m, std::vector<Stripe>& stripes);

}  // namespace robosim::grid
