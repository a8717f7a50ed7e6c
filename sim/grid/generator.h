// Generates random maps: for tests over many maps, for benchmarks, and as courses of any size.
//
// Equal arguments give equal maps on every machine: the only source of randomness is the integer hash of
// sim/base/noise.h. A change that gives another map for the same arguments must raise kGeneratorVersion.
//
// All landmarks lie on a lattice whose rows and columns are 3 or 4 cells apart. A margin of that width is
// around it. So robots have as much room as on the sample maps. There are no walls and no obstacles.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sim/grid/map.h"

namespace robosim::grid {

enum class Family : std::uint8_t {
  tree,    ///< junctions of three ways, no cycle: stations - 2 junctions. What v1 can do
  cycles,  ///< such a tree with lines added that close cycles, at least one, and make some crossings of four
           ///< ways
  grid,    ///< streets as in a city, some of them missing, with crossings of four ways; stations within the
           ///< blocks
};

constexpr int kGeneratorVersion = 1;
constexpr int kMinStations = 2;
constexpr int kMaxStations = 1'000'000;

/// Returns "tree", "cycles" or "grid".
const char* name_of(Family family);
/// Returns the family of that name, or nothing.
std::optional<Family> family_of(std::string_view name);

/// Returns the map's name, "tree-100-7" for 100 stations and seed 7.
std::string generated_name(Family family, int stations, std::uint64_t seed);

/// Returns a connected map with exactly that number of stations; throws std::invalid_argument beyond the
/// limits. Its goal is `tour`, and `generator` has family, version, stations and seed. For a million stations
/// each takes about 55 (tree, cycles) or 70 (grid) cells.
Map generate(Family family, int stations, std::uint64_t seed);

}  // namespace robosim::grid
