#include "sim/world/world.h"

#include <algorithm>

namespace robosim::world {

World::World(const map::Map& map)
    : floor_(map),
      ground_(map),
      lighting_(map.lights),
      walls_(map),
      near_(map.width * map.cell_m, map.height * map.cell_m) {}

std::size_t World::add_body(const BodyParams& params, const Pose& pose) {
  bodies_.push_back(std::make_unique<Body>(params, pose));
  bodies_.back()->place(pose);
  return bodies_.size() - 1;
}

std::optional<std::size_t> World::first_overlap(std::size_t number) const {
  const Body& body = *bodies_[number];
  for (std::size_t i = 0; i < number; ++i) {
    const double radii = body.bound_radius() + bodies_[i]->bound_radius();
    const Vec2 d = bodies_[i]->circle_centre() - body.circle_centre();
    if (dot(d, d) < radii * radii) return i;
  }
  return std::nullopt;
}

World::State World::save() const {
  State state{{}, walls_.save(), ground_.save(), radio_.save(), floor_.patches().save(), lighting_.save()};
  state.bodies.reserve(bodies_.size());
  for (const auto& body : bodies_) state.bodies.push_back(*body);
  return state;
}

void World::restore(const State& saved) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) *bodies_[i] = saved.bodies[i];
  walls_.restore(saved.walls);
  ground_.restore(saved.ground);
  radio_.restore(saved.radio);
  floor_.patches().restore(saved.patches);
  lighting_.restore(saved.lights);
}

bool World::is_still() const {
  return ground_.plain() &&
         std::all_of(bodies_.begin(), bodies_.end(), [](const auto& body) { return body->is_still(); });
}

void World::step() {
  Ground* const ground = ground_.plain() ? nullptr : &ground_;
  if (bodies_.size() == 1 && !ground) return step_alone(0);
  step_all(ground);
}

[[gnu::noinline]] void World::step_all(Ground* ground) {
  for (const auto& body : bodies_) body->step(walls_, ground);
  if (ground) ground->settle();
  if (bodies_.size() > 1) collide_bodies();
  for (const auto& body : bodies_) body->settle_contact();
}

void World::step_together(const std::vector<std::size_t>& numbers) {
  for (const std::size_t number : numbers) bodies_[number]->step(walls_, nullptr);
  if (numbers.size() > 1) collide_bodies();
  for (const std::size_t number : numbers) bodies_[number]->settle_contact();
}

// Treats bodies as circles. Pushes overlapping bodies apart and cancels their approach, in inverse proportion
// to their masses.
void World::collide_bodies() {
  for (const auto& [i, j] : near_.pairs(bodies_)) {
    Body &a = *bodies_[i], &b = *bodies_[j];
    if (a.lifted_ || b.lifted_) continue;
    const Vec2 d = b.circle_centre() - a.circle_centre();
    const double radii = a.bound_radius_ + b.bound_radius_;
    const double reach = radii + Walls::kNear;
    const double square = dot(d, d);
    if (square >= reach * reach) continue;
    a.near_ = b.near_ = true;
    if (square >= radii * radii) continue;
    a.touched_ = b.touched_ = a.touched_body_ = b.touched_body_ = true;
    const double away = std::sqrt(square);
    const Vec2 n = away > 0.0 ? d * (1.0 / away) : Vec2{1.0, 0.0};
    // Computes each share by its own quotient, so that exchanging a and b does not change any bit.
    const double both = a.per_mass_ + b.per_mass_;
    const double share_a = a.per_mass_ / both, share_b = b.per_mass_ / both;
    const double approach = dot(a.velocity() - b.velocity(), n);
    const double depth = radii - away;
    a.meet(n * -1.0, depth * share_a, approach * share_a);
    b.meet(n, depth * share_b, approach * share_b);
  }
}

}  // namespace robosim::world
