#include "sim/map/generator.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sim/base/noise.h"

namespace robosim::map {
namespace {

constexpr const char* kFamilies[] = {"tree", "cycles", "grid"};
constexpr Direction kDirections[] = {Direction::east, Direction::south, Direction::west, Direction::north};
constexpr unsigned kLeastPitch = 3;  // in cells: smallest distance between lattice lines; also the margin
constexpr unsigned kPitches = 2;     // number of different distances between lattice lines

class Chance {
 public:
  Chance(Family family, std::uint64_t seed) : noise_(seed, 0, "generator", name_of(family)) {}
  /// Returns a random number from 0 to n - 1.
  std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(noise_.bits(drawn_++) % n); }
  bool one_in(std::size_t n) { return below(n) == 0; }

 private:
  NoiseStream noise_;
  std::uint64_t drawn_ = 0;
};

// The possible places of landmarks, and their connections.
class Lattice {
 public:
  Lattice(int width, int height)
      : width_(width),
        height_(height),
        arms_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t size() const { return arms_.size(); }
  std::uint32_t index(int x, int y) const {
    return static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(width_) + static_cast<std::uint32_t>(x);
  }
  int x(std::uint32_t i) const { return static_cast<int>(i % static_cast<std::uint32_t>(width_)); }
  int y(std::uint32_t i) const { return static_cast<int>(i / static_cast<std::uint32_t>(width_)); }
  unsigned arms(std::uint32_t i) const { return arms_[i]; }
  int degree(std::uint32_t i) const { return std::popcount(arms(i)); }

  std::optional<std::uint32_t> beside(std::uint32_t i, Direction d) const {
    const CellAt to = ahead({x(i), y(i)}, d);
    if (to.x < 0 || to.y < 0 || to.x >= width_ || to.y >= height_) return std::nullopt;
    return index(to.x, to.y);
  }
  void join(std::uint32_t i, Direction d) { flip(i, d); }
  void part(std::uint32_t i, Direction d) { flip(i, d); }

 private:
  void flip(std::uint32_t i, Direction d) {
    arms_[i] = static_cast<std::uint8_t>(arms_[i] ^ 1u << static_cast<int>(d));
    std::uint8_t& other = arms_[*beside(i, d)];
    other = static_cast<std::uint8_t>(other ^ 1u << static_cast<int>(reversed(d)));
  }

  int width_;
  int height_;
  std::vector<std::uint8_t> arms_;  // bit 1 << Direction
};

// Grows a tree from the middle outward. A node added at a dead end moves the dead end; a node added elsewhere
// creates a dead end. Any number of dead ends can therefore be reached exactly. One step in four extends the
// newest node, which makes lines with bends. The other steps extend a random node. Returns false if the
// lattice fills up first.
bool grow_tree(Lattice& lattice, std::size_t stations, std::size_t least_nodes, Chance& chance) {
  std::vector<std::uint32_t> growing{lattice.index(lattice.width() / 2, lattice.height() / 2)};
  std::size_t nodes = 1;
  std::size_t ends = 0;
  while (ends < stations || nodes < least_nodes) {
    if (growing.empty()) return false;
    const std::size_t pick = chance.one_in(4) ? growing.size() - 1 : chance.below(growing.size());
    const std::uint32_t node = growing[pick];
    const int degree = lattice.degree(node);
    std::vector<Direction>::size_type free = 0;
    Direction ways[4];
    for (const Direction d : kDirections) {
      const auto next = lattice.beside(node, d);
      if (next && lattice.arms(*next) == 0) ways[free++] = d;
    }
    if (free == 0 || degree == 3 || (ends == stations && degree > 1)) {
      growing[pick] = growing.back();
      growing.pop_back();
      continue;
    }
    const Direction d = ways[chance.below(free)];
    lattice.join(node, d);
    growing.push_back(*lattice.beside(node, d));
    ++nodes;
    ends += degree == 0 ? 2 : degree == 1 ? 0 : 1;
  }
  return true;
}

// Returns a lattice with a tree. Enlarges the lattice until the tree fits.
Lattice tree(std::size_t stations, std::size_t least_nodes, Chance& chance) {
  for (double room = 6.0;; room *= 1.5) {
    const int side =
        6 + static_cast<int>(std::sqrt(room * static_cast<double>(std::max(stations, least_nodes / 3))));
    Lattice lattice(side, side);
    if (grow_tree(lattice, stations, least_nodes, chance)) return lattice;
  }
}

// Connects unconnected pairs of lattice neighbours that are not dead ends. Connects each pair with a
// probability of one in four, and at least one pair. Returns false if there is no such pair.
bool close_cycles(Lattice& lattice, Chance& chance) {
  const auto inner = [&](std::uint32_t i) { return lattice.degree(i) >= 2; };
  std::vector<std::pair<std::uint32_t, Direction>> pairs;
  for (std::uint32_t i = 0; i < lattice.size(); ++i)
    for (const Direction d : {Direction::east, Direction::south}) {
      const auto next = lattice.beside(i, d);
      if (next && !has(lattice.arms(i), d) && inner(i) && inner(*next)) pairs.emplace_back(i, d);
    }
  if (pairs.empty()) return false;
  const std::size_t always = chance.below(pairs.size());
  for (std::size_t n = 0; n < pairs.size(); ++n)
    if (n == always || chance.one_in(4)) lattice.join(pairs[n].first, pairs[n].second);
  return true;
}

Lattice cycles(std::size_t stations, Chance& chance) {
  for (;;) {
    Lattice lattice = tree(stations, 2 * stations + 8, chance);
    if (close_cycles(lattice, chance)) return lattice;
  }
}

// Groups of connected crossings in a city.
class Groups {
 public:
  explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }
  /// Merges two groups. Returns false if they were already one group.
  bool unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[a] = b;
    return a != b;
  }

 private:
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  std::vector<std::uint32_t> parent_;
};

// A city with crossings on the even rows and columns of the lattice. The middle of a block is on an odd row
// and column. It may be a station, connected to the middle of one of the block's four sides. Each side is a
// street of two lattice steps.
class City {
 public:
  City(std::size_t stations, Chance& chance)
      : columns_(2 + static_cast<int>(std::sqrt(1.4 * static_cast<double>(stations)))),
        rows_(columns_),
        lattice_(2 * columns_ + 1, 2 * rows_ + 1),
        chance_(chance) {
    lay_streets();
    build_stations(stations);
    remove_streets();
  }
  Lattice take() { return std::move(lattice_); }

 private:
  struct Street {
    std::uint32_t from;  // a crossing
    Direction to;        // east or south
  };

  void lay_streets() {
    for (int y = 0; y <= 2 * rows_; y += 2)
      for (int x = 0; x <= 2 * columns_; x += 2) {
        const std::uint32_t i = lattice_.index(x, y);
        if (x < 2 * columns_) streets_.push_back({i, Direction::east});
        if (y < 2 * rows_) streets_.push_back({i, Direction::south});
      }
    for (const Street& street : streets_) {
      lattice_.join(street.from, street.to);
      lattice_.join(middle(street), street.to);
    }
  }

  // Selects the blocks with stations. All selections are equally likely (Knuth's selection sampling).
  void build_stations(std::size_t stations) {
    std::size_t blocks = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    for (int y = 1; y < 2 * rows_; y += 2)
      for (int x = 1; x < 2 * columns_; x += 2, --blocks) {
        if (chance_.below(blocks) >= stations) continue;
        --stations;
        lattice_.join(lattice_.index(x, y), kDirections[chance_.below(4)]);
      }
  }

  // Removes each street with a probability of one in three. Keeps streets with a station, and streets of a
  // random spanning tree (Kruskal's algorithm). Each crossing retains at least two streets.
  void remove_streets() {
    for (std::size_t n = streets_.size(); n > 1; --n) std::swap(streets_[n - 1], streets_[chance_.below(n)]);
    Groups connected(lattice_.size());
    for (const Street& street : streets_) {
      const std::uint32_t to = *lattice_.beside(middle(street), street.to);
      const bool needed = connected.unite(street.from, to) || lattice_.degree(middle(street)) > 2 ||
                          lattice_.degree(street.from) <= 2 || lattice_.degree(to) <= 2;
      if (needed || !chance_.one_in(3)) continue;
      lattice_.part(street.from, street.to);
      lattice_.part(middle(street), street.to);
    }
  }

  std::uint32_t middle(const Street& street) const { return *lattice_.beside(street.from, street.to); }

  int columns_;  // number of columns of blocks
  int rows_;
  Lattice lattice_;
  Chance& chance_;
  std::vector<Street> streets_;
};

// Returns the coordinate, in cells, of each lattice line from `first` to `last`, indexed by the line's
// number.
std::vector<int> spread(int first, int last, Chance& chance) {
  std::vector<int> at(static_cast<std::size_t>(last) + 1, 0);
  int cell = static_cast<int>(kLeastPitch);
  for (int line = first; line <= last; ++line) {
    at[static_cast<std::size_t>(line)] = cell;
    cell += static_cast<int>(kLeastPitch + chance.below(kPitches));
  }
  return at;
}

Map paint(const Lattice& lattice, Chance& chance) {
  int left = lattice.width(), right = 0, top = lattice.height(), bottom = 0;
  for (std::uint32_t i = 0; i < lattice.size(); ++i) {
    if (lattice.arms(i) == 0) continue;
    left = std::min(left, lattice.x(i));
    right = std::max(right, lattice.x(i));
    top = std::min(top, lattice.y(i));
    bottom = std::max(bottom, lattice.y(i));
  }
  const std::vector<int> column = spread(left, right, chance);
  const std::vector<int> row = spread(top, bottom, chance);
  Map map;
  map.width = column.back() + static_cast<int>(kLeastPitch) + 1;
  map.height = row.back() + static_cast<int>(kLeastPitch) + 1;
  map.cells.assign(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height), Cell::floor);
  for (std::uint32_t i = 0; i < lattice.size(); ++i) {
    if (lattice.arms(i) == 0) continue;
    const CellAt node{column[static_cast<std::size_t>(lattice.x(i))],
                      row[static_cast<std::size_t>(lattice.y(i))]};
    CellAt cell = node;
    map.cells[map.index_of(cell)] = Cell::line;
    if (has(lattice.arms(i), Direction::east))
      for (const int end = column[static_cast<std::size_t>(lattice.x(i)) + 1]; cell.x < end; ++cell.x)
        map.cells[map.index_of(cell)] = Cell::line;
    cell = node;
    if (has(lattice.arms(i), Direction::south))
      for (const int end = row[static_cast<std::size_t>(lattice.y(i)) + 1]; cell.y < end; ++cell.y)
        map.cells[map.index_of(cell)] = Cell::line;
  }
  return map;
}

}  // namespace

const char* name_of(Family family) { return kFamilies[static_cast<std::size_t>(family)]; }

std::optional<Family> family_of(std::string_view name) {
  const auto found = std::find(std::begin(kFamilies), std::end(kFamilies), name);
  if (found == std::end(kFamilies)) return std::nullopt;
  return static_cast<Family>(found - std::begin(kFamilies));
}

std::string generated_name(Family family, int stations, std::uint64_t seed) {
  return fmt::format("{}-{}-{}", name_of(family), stations, seed);
}

Map generate(Family family, int stations, std::uint64_t seed) {
  if (stations < kMinStations || stations > kMaxStations)
    throw std::invalid_argument(fmt::format("a map of {} stations cannot be generated", stations));
  Chance chance(family, seed);
  const auto n = static_cast<std::size_t>(stations);
  const Lattice lattice = family == Family::tree     ? tree(n, 2 * n + 2, chance)
                          : family == Family::cycles ? cycles(n, chance)
                                                     : City(n, chance).take();
  Map map = paint(lattice, chance);
  map.name = generated_name(family, stations, seed);
  map.file = map.name + ".map";
  map.goal = "tour";
  map.generator =
      fmt::format("{} {} stations {} seed {}", name_of(family), kGeneratorVersion, stations, seed);
  return map;
}

}  // namespace robosim::map
