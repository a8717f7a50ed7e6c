#include "sim/world/near_bodies.h"

#include <algorithm>
#include <cmath>

#include "sim/world/walls.h"

namespace robosim::world {
namespace {

// Up to this number of bodies, all pairs are compared.
constexpr std::size_t kFew = 8;
// Margin: two bodies that are pushed apart may come closer to a third body.
constexpr double kPushed_m = 0.02;
constexpr int kMostSquares = 512;  // maximum number of squares in a row or column

}  // namespace

void NearBodies::make_squares(const std::vector<std::unique_ptr<Body>>& bodies) {
  count_ = bodies.size();
  double radius = 0.0;
  for (const auto& body : bodies) radius = std::max(radius, body->bound_radius());
  double side = 2.0 * radius + Walls::kNear + kPushed_m;
  side = std::max(side, std::max(width_m_, height_m_) / (kMostSquares - 2));
  per_side_ = 1.0 / side;
  columns_ = static_cast<int>(width_m_ * per_side_) + 2;
  rows_ = static_cast<int>(height_m_ * per_side_) + 2;
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1);
  next_.resize(count_);
  square_.resize(count_);
}

std::size_t NearBodies::square_of(Vec2 p) const {
  const auto index = [&](double metres, int most) {
    return static_cast<std::size_t>(std::clamp(metres * per_side_, 0.0, static_cast<double>(most - 1)));
  };
  return index(p.y, rows_) * static_cast<std::size_t>(columns_) + index(p.x, columns_);
}

const std::vector<NearBodies::Pair>& NearBodies::pairs(const std::vector<std::unique_ptr<Body>>& bodies) {
  const auto count = static_cast<std::uint32_t>(bodies.size());
  pairs_.clear();
  const auto add_if_near = [&](std::uint32_t i, std::uint32_t j) {
    const double reach = bodies[i]->bound_radius() + bodies[j]->bound_radius() + Walls::kNear + kPushed_m;
    const Vec2 d = bodies[i]->circle_centre() - bodies[j]->circle_centre();
    if (dot(d, d) < reach * reach) pairs_.push_back({i, j});
  };
  if (count <= kFew) {
    for (std::uint32_t i = 0; i < count; ++i)
      for (std::uint32_t j = i + 1; j < count; ++j) add_if_near(i, j);
  } else {
    look_in_squares(bodies, add_if_near);
  }
  const auto is_before = [&](std::uint32_t i, std::uint32_t j) {
    const Vec2 a = bodies[i]->circle_centre(), b = bodies[j]->circle_centre();
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  };
  for (Pair& pair : pairs_)
    if (is_before(pair.second, pair.first)) std::swap(pair.first, pair.second);
  if (pairs_.size() > 1)
    std::sort(pairs_.begin(), pairs_.end(), [&](const Pair& one, const Pair& other) {
      if (one.first != other.first) return is_before(one.first, other.first);
      return is_before(one.second, other.second);
    });
  return pairs_;
}

template <class Take>
void NearBodies::look_in_squares(const std::vector<std::unique_ptr<Body>>& bodies, const Take& take) {
  const auto count = static_cast<std::uint32_t>(bodies.size());
  if (count != count_) make_squares(bodies);
  for (std::uint32_t i = count; i-- > 0;) {
    square_[i] = square_of(bodies[i]->circle_centre());
    next_[i] = first_[square_[i]];
    first_[square_[i]] = static_cast<std::int32_t>(i);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const int column = static_cast<int>(square_[i]) % columns_, row = static_cast<int>(square_[i]) / columns_;
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, rows_ - 1); ++y)
      for (int x = std::max(column - 1, 0); x <= std::min(column + 1, columns_ - 1); ++x)
        for (std::int32_t j = first_[static_cast<std::size_t>(y * columns_ + x)]; j >= 0;
             j = next_[static_cast<std::size_t>(j)])
          if (static_cast<std::uint32_t>(j) > i) take(i, static_cast<std::uint32_t>(j));
  }
  for (std::uint32_t i = 0; i < count; ++i) first_[square_[i]] = -1;
}

}  // namespace robosim::world
