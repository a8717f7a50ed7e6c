#include "sim/campaign/random_worlds/track.h"

#include <algorithm>
#include <set>

namespace robosim::random_worlds {
namespace {

/// Moves the squares to the lattice's corner. Drops empty columns and rows, and drops gaps that are not on
/// the line. If the start is not on the line, moves it to the first piece.
void tidy(Track& track) {
  if (track.squares.empty()) return;
  std::sort(track.squares.begin(), track.squares.end());
  Knot low = track.squares[0], high = low;
  for (const Knot square : track.squares) {
    low = {std::min(low.x, square.x), std::min(low.y, square.y)};
    high = {std::max(high.x, square.x), std::max(high.y, square.y)};
  }
  const auto move = [&](Knot& knot) { knot = {knot.x - low.x, knot.y - low.y}; };
  for (Knot& square : track.squares) move(square);
  for (Piece& gap : track.gaps) move(gap.at);
  move(track.start.at);
  track.columns = std::vector<int>(track.columns.begin() + low.x, track.columns.begin() + high.x + 1);
  track.rows = std::vector<int>(track.rows.begin() + low.y, track.rows.begin() + high.y + 1);
  const std::vector<Piece> line = track.outline().pieces;
  std::erase_if(track.gaps, [&](const Piece& gap) { return !has(line, gap); });
  if (!has(line, track.start)) track.start = line.front();
  std::erase(track.gaps, track.start);
  std::sort(track.gaps.begin(), track.gaps.end());
  track.gaps.erase(std::unique(track.gaps.begin(), track.gaps.end()), track.gaps.end());
}

/// Returns the track with column, or row, `at` merged into the previous one.
Track folded(const Track& track, int at, bool across) {
  Track less = track;
  const auto move = [&](Knot knot) {
    int& where = across ? knot.y : knot.x;
    if (where >= at) --where;
    return knot;
  };
  std::set<Knot> squares;
  for (const Knot square : track.squares) squares.insert(move(square));
  less.squares.assign(squares.begin(), squares.end());
  std::vector<int>& widths = across ? less.rows : less.columns;
  widths.erase(widths.begin() + at);
  for (Piece& gap : less.gaps) gap.at = move(gap.at);
  less.start.at = move(less.start.at);
  return less;
}

}  // namespace

LineNetwork Track::outline() const {
  std::set<Piece> pieces;
  for (const Knot& s : squares) {
    // A side that two squares share is not part of the outline.
    for (const Piece side :
         {Piece{s, false}, Piece{s, true}, Piece{{s.x, s.y + 1}, false}, Piece{{s.x + 1, s.y}, true}})
      if (!pieces.insert(side).second) pieces.erase(side);
  }
  LineNetwork network;
  network.apart = apart;
  network.pieces.assign(pieces.begin(), pieces.end());
  network.columns = columns;
  network.rows = rows;
  return network;
}

bool Track::is_sound() const {
  const LineNetwork line = outline();
  if (!line.is_connected() || !has(line.pieces, start) || has(gaps, start)) return false;
  return std::all_of(line.pieces.begin(), line.pieces.end(), [&](const Piece& piece) {
    return line.neighbours(piece.at).size() == 2 && line.neighbours(piece.end()).size() == 2;
  });
}

std::vector<Track> Track::smaller() const {
  std::vector<Track> found;
  for (int column = 1; column < static_cast<int>(columns.size()); ++column)
    found.push_back(folded(*this, column, false));
  for (int row = 1; row < static_cast<int>(rows.size()); ++row) found.push_back(folded(*this, row, true));
  for (const Knot square : squares) {
    found.push_back(*this);
    std::erase(found.back().squares, square);
  }
  std::erase_if(found, [](const Track& track) { return track.squares.empty(); });
  for (Track& track : found) tidy(track);
  std::erase_if(found, [](const Track& track) { return !track.is_sound(); });
  std::stable_sort(found.begin(), found.end(),
                   [](const Track& a, const Track& b) { return a.squares.size() < b.squares.size(); });
  for (const Piece& gap : gaps) {
    found.push_back(*this);
    std::erase(found.back().gaps, gap);
  }
  for (std::size_t i = 0; i < columns.size() + rows.size(); ++i) {
    Track shorter = *this;
    int& cells = i < columns.size() ? shorter.columns[i] : shorter.rows[i - columns.size()];
    if (cells == apart) continue;
    cells = apart;
    found.push_back(shorter);
  }
  const Piece first = outline().pieces.front();
  if (start != first && !has(gaps, first)) {
    found.push_back(*this);
    found.back().start = first;
  }
  return found;
}

std::string Track::grid() const {
  const LineNetwork line = outline();
  std::vector<std::string> cells = line.cells();
  const auto middle = [&](const Piece& piece) -> char& {
    return cells[static_cast<std::size_t>((line.row_of(piece.at.y) + line.row_of(piece.end().y)) / 2)]
                [static_cast<std::size_t>((line.column_of(piece.at.x) + line.column_of(piece.end().x)) / 2)];
  };
  for (const Piece& gap : gaps) middle(gap) = '3';
  middle(start) = 'S';
  std::string text;
  for (const std::string& row : cells) text += row + '\n';
  return text;
}

Track lay_out(const TrackLimits& limits, const RandomSource& rng) {
  Track track;
  track.apart = limits.apart;
  const int side = limits.squares + 2;
  for (int i = 0; i < side; ++i) {
    track.columns.push_back(limits.apart + rng(limits.apart));
    track.rows.push_back(limits.apart + rng(limits.apart));
  }
  const auto pick = [&](const auto& from) {
    return from[static_cast<std::size_t>(rng(static_cast<int>(from.size())))];
  };
  track.squares = {{side / 2, side / 2}};
  track.start = {track.squares[0], false};
  for (int tries = 8 * limits.squares; tries > 0 && static_cast<int>(track.squares.size()) < limits.squares;
       --tries) {
    Knot next = pick(track.squares);
    (rng(2) ? next.x : next.y) += rng(2) ? 1 : -1;
    const bool free = std::find(track.squares.begin(), track.squares.end(), next) == track.squares.end();
    if (!free || next.x < 0 || next.y < 0 || next.x >= side || next.y >= side) continue;
    track.squares.push_back(next);
    track.start = track.outline().pieces.front();
    if (!track.is_sound()) track.squares.pop_back();
  }
  const std::vector<Piece> line = track.outline().pieces;
  for (int gaps = limits.gaps > 0 ? rng(limits.gaps + 1) : 0; gaps > 0; --gaps)
    track.gaps.push_back(pick(line));
  track.start = pick(line);
  tidy(track);
  return track;
}

}  // namespace robosim::random_worlds
