#include "sim/map/path.h"

#include <algorithm>
#include <cmath>

#include "sim/base/deterministic_trig.h"

namespace robosim::map {
namespace {

constexpr double kLeastCosine = 0.99619469809174555;  // cosine of 5 degrees

}  // namespace

Pose PathPiece::at(double along) const {
  if (turn == 0.0) return {begin.position + begin.heading * along, begin.heading};
  if (length == 0.0) return {begin.position, robosim::turned(begin.heading, unit_vector(turn))};
  const Vec2 by = unit_vector(turn * (along / length));
  return {centre() + robosim::turned(begin.position - centre(), by), robosim::turned(begin.heading, by)};
}

void Path::add_straight(double length, bool is_gap) { add(length, 0.0, 0.0, is_gap); }

void Path::add_arc(double radius, double turn, bool is_gap) {
  add(radius * std::fabs(turn), turn, radius, is_gap);
}

void Path::add_corner(double turn) { add(0.0, turn, 0.0, false); }

void Path::add(double length, double turn, double radius, bool is_gap) {
  pieces_.push_back({end_, length, turn, radius, is_gap, 0});
  begins_.push_back(length_);
  end_ = pieces_.back().at(length);
  end_.heading = end_.heading * (1.0 / robosim::length(end_.heading));
  length_ += length;
}

bool Path::is_closed(double most) const {
  return !pieces_.empty() && robosim::length(end_.position - begin().position) <= most &&
         dot(end_.heading, begin().heading) >= kLeastCosine;
}

Pose Path::at(double along, bool closed) const {
  if (pieces_.empty()) return end_;
  if (closed) along -= std::floor(along / length_) * length_;
  const auto after = std::upper_bound(begins_.begin(), begins_.end(), along);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - begins_.begin() - 1, 0));
  return pieces_[i].at(std::clamp(along - begins_[i], 0.0, pieces_[i].length));
}

}  // namespace robosim::map
