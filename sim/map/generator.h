// Generates random maps: for tests over many maps, for benchmarks, and as courses of any size.
//
// Equal arguments give equal maps on every machine: the only source of randomness is the integer hash of
// sim/base/noise.h. A change that alters the map for any arguments must raise kGeneratorVersion.
//
// All landmarks lie on a lattice whose rows and columns are 3 or 4 cells apart. A margin of 3 cells surrounds
// the lattice. Robots therefore have as much room as on the sample maps. The maps have no walls and no
// obstacles.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sim/map/map.h"

namespace robosim::map {

enum class Family : std::uint8_t {
  tree,    ///< no cycles, and `stations` - 2 three-way junctions; supported by Robosim v1
  cycles,  ///< a tree with added lines, which close at least one cycle and make some four-way crossings
  grid,  ///< a grid of city streets with some streets missing, four-way crossings, and stations inside blocks
};

constexpr int kGeneratorVersion = 1;
constexpr int kMinStations = 2;
constexpr int kMaxStations = 1'000'000;

/// Returns "tree", "cycles" or "grid".
const char* name_of(Family family);
/// Returns the family with this name, or nullopt.
std::optional<Family> family_of(std::string_view name);

/// Returns the map's name, such as "tree-100-7" for 100 stations and seed 7.
std::string generated_name(Family family, int stations, std::uint64_t seed);

/// Returns a connected map with exactly `stations` stations; throws std::invalid_argument if the number is
/// outside the limits above. The map's goal is `tour`; its `generator` contains family, version, stations and
/// seed. A map of a million stations has about 55 (tree, cycles) or 70 (grid) cells per station.
Map generate(Family family, int stations, std::uint64_t seed);

}  // namespace robosim::map
