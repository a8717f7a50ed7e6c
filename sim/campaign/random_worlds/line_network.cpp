#include "sim/campaign/random_worlds/line_network.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace robosim::random_worlds {
namespace {

Piece between(Knot a, Knot b) { return {std::min(a, b), a.x == b.x}; }

std::vector<Knot> around(Knot k) { return {{k.x + 1, k.y}, {k.x, k.y + 1}, {k.x - 1, k.y}, {k.x, k.y - 1}}; }

std::set<Knot> knots_of(const std::vector<Piece>& pieces) {
  std::set<Knot> knots;
  for (const Piece& piece : pieces) {
    knots.insert(piece.at);
    knots.insert(piece.end());
  }
  return knots;
}

std::set<Knot> reached_from(Knot from, const LineNetwork& network) {
  std::set<Knot> reached{from};
  std::vector<Knot> next{from};
  while (!next.empty()) {
    const Knot knot = next.back();
    next.pop_back();
    for (const Knot other : network.neighbours(knot))
      if (reached.insert(other).second) next.push_back(other);
  }
  return reached;
}

/// Compares knots in row order.
bool comes_before(Knot a, Knot b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }

/// Sorts the pieces, moves the network to the lattice's corner, and drops columns and rows without a line. If
/// the start is no longer a station, it becomes the first station.
void tidy(LineNetwork& network) {
  const std::set<Knot> knots = knots_of(network.pieces);
  if (knots.empty()) return;
  Knot low = *knots.begin(), high = low;
  for (const Knot knot : knots) {
    low = {std::min(low.x, knot.x), std::min(low.y, knot.y)};
    high = {std::max(high.x, knot.x), std::max(high.y, knot.y)};
  }
  for (std::vector<Piece>* list : {&network.pieces, &network.obstacles})
    for (Piece& piece : *list) piece.at = {piece.at.x - low.x, piece.at.y - low.y};
  network.start = {network.start.x - low.x, network.start.y - low.y};
  const auto cut = [](std::vector<int>& widths, int from, int to) {
    widths = std::vector<int>(widths.begin() + from, widths.begin() + to);
  };
  cut(network.columns, low.x, high.x);
  cut(network.rows, low.y, high.y);
  std::sort(network.pieces.begin(), network.pieces.end());
  std::erase_if(network.obstacles, [&](const Piece& piece) { return !has(network.pieces, piece); });
  std::sort(network.obstacles.begin(), network.obstacles.end());
  network.obstacles.erase(std::unique(network.obstacles.begin(), network.obstacles.end()),
                          network.obstacles.end());
  const std::vector<Knot> stations = network.stations();
  if (!stations.empty() && std::find(stations.begin(), stations.end(), network.start) == stations.end())
    network.start = stations.front();
}

/// Returns the network without `piece`, reduced to the connected part that contains `keep`.
LineNetwork without(const LineNetwork& network, const Piece& piece, Knot keep) {
  LineNetwork left = network;
  std::erase(left.pieces, piece);
  const std::set<Knot> side = reached_from(keep, left);
  std::erase_if(left.pieces, [&](const Piece& other) { return !side.contains(other.at); });
  tidy(left);
  return left;
}

/// Merges lattice column `column` into the previous one. Returns false if separate lines would meet.
bool fold_column(LineNetwork& network, int column) {
  const auto moved = [&](Knot knot) { return knot.x >= column ? Knot{knot.x - 1, knot.y} : knot; };
  const std::set<Knot> knots = knots_of(network.pieces);
  for (const Knot knot : knots)
    if (knot.x == column && knots.contains({column - 1, knot.y}) &&
        !has(network.pieces, {{column - 1, knot.y}, false}))
      return false;
  std::set<Piece> pieces;
  for (const Piece& piece : network.pieces) {
    if (!piece.down && piece.at.x == column - 1) {
      std::erase(network.obstacles, piece);
      continue;
    }
    if (!pieces.insert({moved(piece.at), piece.down}).second) return false;
  }
  network.pieces.assign(pieces.begin(), pieces.end());
  for (Piece& piece : network.obstacles) piece.at = moved(piece.at);
  network.start = moved(network.start);
  network.columns.erase(network.columns.begin() + column - 1);
  return true;
}

LineNetwork mirrored(const LineNetwork& network) {
  LineNetwork other = network;
  for (std::vector<Piece>* list : {&other.pieces, &other.obstacles})
    for (Piece& piece : *list) piece = {{piece.at.y, piece.at.x}, !piece.down};
  other.start = {network.start.y, network.start.x};
  std::swap(other.columns, other.rows);
  return other;
}

void add_folded(const LineNetwork& network, std::vector<LineNetwork>& found) {
  for (int column = 1; column <= static_cast<int>(network.columns.size()); ++column) {
    LineNetwork folded = network;
    if (fold_column(folded, column)) found.push_back(folded);
  }
}

/// Adds a free lattice column or row on each side of the network.
LineNetwork padded(LineNetwork network) {
  for (std::vector<int>* widths : {&network.columns, &network.rows}) {
    widths->insert(widths->begin(), network.apart);
    widths->push_back(network.apart);
  }
  for (std::vector<Piece>* list : {&network.pieces, &network.obstacles})
    for (Piece& piece : *list) piece.at = {piece.at.x + 1, piece.at.y + 1};
  network.start = {network.start.x + 1, network.start.y + 1};
  return network;
}

/// Shortens each line that has several pieces and ends at a station: removes it, and inserts a single piece.
/// Adds a network to `found` for each place where this piece fits.
void add_shorter_ends(const LineNetwork& network, std::vector<LineNetwork>& found) {
  for (const Knot station : padded(network).stations()) {
    LineNetwork rest = padded(network);
    Knot at = station;
    int cut = 0;
    for (std::vector<Knot> next = rest.neighbours(at); next.size() == 1; next = rest.neighbours(at), ++cut) {
      std::erase(rest.pieces, between(at, next[0]));
      at = next[0];
    }
    if (cut < 2) continue;
    const std::set<Knot> knots = knots_of(rest.pieces);
    for (const Knot knot : knots) {
      for (const Knot end : around(knot)) {
        if (knots.contains(end)) continue;
        found.push_back(rest);
        found.back().pieces.push_back(between(knot, end));
      }
    }
  }
}

}  // namespace

bool has(const std::vector<Piece>& pieces, const Piece& piece) {
  return std::find(pieces.begin(), pieces.end(), piece) != pieces.end();
}

std::vector<Knot> LineNetwork::neighbours(Knot knot) const {
  std::vector<Knot> found;
  for (const Knot other : around(knot))
    if (has(pieces, between(knot, other))) found.push_back(other);
  return found;
}

bool LineNetwork::is_connected() const {
  return !pieces.empty() && reached_from(pieces[0].at, *this).size() == knots_of(pieces).size();
}

std::vector<Knot> LineNetwork::stations() const {
  std::vector<Knot> found;
  for (const Knot knot : knots_of(pieces))
    if (neighbours(knot).size() == 1) found.push_back(knot);
  std::sort(found.begin(), found.end(), comes_before);
  return found;
}

bool LineNetwork::is_sound() const {
  const std::vector<Knot> ends = stations();
  const std::set<Knot> knots = knots_of(pieces);
  return is_connected() && std::find(ends.begin(), ends.end(), start) != ends.end() &&
         std::all_of(knots.begin(), knots.end(),
                     [&](Knot knot) { return static_cast<int>(neighbours(knot).size()) <= most_ways; });
}

std::vector<LineNetwork> LineNetwork::smaller() const {
  std::vector<LineNetwork> found;
  for (const Piece& piece : pieces) {
    found.push_back(without(*this, piece, piece.at));
    found.push_back(without(*this, piece, piece.end()));
  }
  add_folded(*this, found);
  std::vector<LineNetwork> across;
  add_folded(mirrored(*this), across);
  for (const LineNetwork& network : across) found.push_back(mirrored(network));
  add_shorter_ends(*this, found);
  for (LineNetwork& network : found) tidy(network);
  std::erase_if(found, [](const LineNetwork& network) { return !network.is_sound(); });
  std::stable_sort(found.begin(), found.end(), [](const LineNetwork& a, const LineNetwork& b) {
    return a.pieces.size() < b.pieces.size();
  });
  for (const Piece& piece : obstacles) {
    found.push_back(*this);
    std::erase(found.back().obstacles, piece);
  }
  for (std::size_t i = 0; i < columns.size() + rows.size(); ++i) {
    LineNetwork shorter = *this;
    int& cells = i < columns.size() ? shorter.columns[i] : shorter.rows[i - columns.size()];
    if (cells == apart) continue;
    cells = apart;
    found.push_back(shorter);
  }
  if (start != stations().front()) {
    found.push_back(*this);
    found.back().start = stations().front();
  }
  return found;
}

int LineNetwork::column_of(int x) const {
  return std::accumulate(columns.begin(), columns.begin() + x, margin());
}
int LineNetwork::row_of(int y) const { return std::accumulate(rows.begin(), rows.begin() + y, margin()); }

std::vector<std::string> LineNetwork::cells() const {
  const int width = column_of(static_cast<int>(columns.size())) + margin() + 1;
  const int height = row_of(static_cast<int>(rows.size())) + margin() + 1;
  std::vector<std::string> cells(static_cast<std::size_t>(height),
                                 std::string(static_cast<std::size_t>(width), '_'));
  for (const Piece& piece : pieces)
    for (int y = row_of(piece.at.y); y <= row_of(piece.end().y); ++y)
      for (int x = column_of(piece.at.x); x <= column_of(piece.end().x); ++x)
        cells[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = '.';
  return cells;
}

std::string LineNetwork::map() const {
  std::vector<std::string> grid = cells();
  for (const Piece& piece : obstacles)
    grid[static_cast<std::size_t>((row_of(piece.at.y) + row_of(piece.end().y)) / 2)]
        [static_cast<std::size_t>((column_of(piece.at.x) + column_of(piece.end().x)) / 2)] = 'x';
  grid[static_cast<std::size_t>(row_of(start.y))][static_cast<std::size_t>(column_of(start.x))] = 'S';
  std::string text;
  for (const std::string& row : grid) text += row + '\n';
  return text;
}

LineNetwork grow(const GrowthLimits& limits, const RandomSource& rng) {
  // The lattice is large enough for growth, and small enough that lines become neighbours.
  int side = 3;
  while (side * side < 3 * limits.pieces) ++side;
  LineNetwork network;
  network.apart = limits.apart;
  network.most_ways = limits.most_ways;
  for (int i = 0; i + 1 < side; ++i) {
    network.columns.push_back(limits.apart + rng(2));
    network.rows.push_back(limits.apart + rng(2));
  }
  std::vector<Knot> knots{{rng(side), rng(side)}};
  int cycles = limits.cycles;
  for (int tries = 8 * limits.pieces; tries > 0 && static_cast<int>(network.pieces.size()) < limits.pieces;
       --tries) {
    const Knot from = knots[static_cast<std::size_t>(rng(static_cast<int>(knots.size())))];
    const Knot to = around(from)[static_cast<std::size_t>(rng(4))];
    if (to.x < 0 || to.y < 0 || to.x >= side || to.y >= side) continue;
    const auto ways = [&](Knot knot) { return static_cast<int>(network.neighbours(knot).size()); };
    const bool closes = std::find(knots.begin(), knots.end(), to) != knots.end();
    if (has(network.pieces, between(from, to)) || ways(from) >= limits.most_ways ||
        ways(to) >= limits.most_ways)
      continue;
    if (closes && (cycles == 0 || network.pieces.size() < 3)) continue;
    network.pieces.push_back(between(from, to));
    if (!closes) {
      knots.push_back(to);
    } else if (network.stations().empty()) {
      network.pieces.pop_back();
    } else {
      --cycles;
    }
  }
  if (network.pieces.empty()) {
    const Knot knot = knots[0];
    network.pieces.push_back(between(knot, {knot.x + (knot.x + 1 < side ? 1 : -1), knot.y}));
  }
  const std::vector<Knot> stations = network.stations();
  network.start = stations[static_cast<std::size_t>(rng(static_cast<int>(stations.size())))];
  for (int i = limits.obstacles > 0 ? rng(limits.obstacles + 1) : 0; i > 0; --i)
    network.obstacles.push_back(
        network.pieces[static_cast<std::size_t>(rng(static_cast<int>(network.pieces.size())))]);
  tidy(network);
  return network;
}

}  // namespace robosim::random_worlds
