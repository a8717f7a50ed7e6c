// Finds pairs of bodies that are near enough to touch, without testing every pair. Divides the floor into
// large squares: two bodies that touch are in the same square or in neighbouring squares.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "sim/world/body.h"

namespace robosim::world {

class NearBodies {
 public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  NearBodies(double width_m, double height_m) : width_m_(width_m), height_m_(height_m) {}

  /// Returns all pairs that may touch, sorted from west to east. Each pair begins with its western body. The
  /// order does not depend on the bodies' numbers. The result is valid until the next call.
  const std::vector<Pair>& pairs(const std::vector<std::unique_ptr<Body>>& bodies);

 private:
  void make_squares(const std::vector<std::unique_ptr<Body>>& bodies);
  std::size_t square_of(Vec2 p) const;
  template <class Take>
  void look_in_squares(const std::vector<std::unique_ptr<Body>>& bodies, const Take& take);

  double width_m_, height_m_;
  // Number of bodies for which the squares were made.
  std::size_t count_ = 0;
  double per_side_ = 0.0;
  int columns_ = 0, rows_ = 0;
  // Used only during a call.
  std::vector<std::int32_t> first_, next_;  ///< first body in a square; next body in that square; -1 = none
  std::vector<std::size_t> square_;         ///< square of each body
  std::vector<Pair> pairs_;
};

}  // namespace robosim::world
