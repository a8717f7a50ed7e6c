// Resolves a body's contacts with walls, obstacles and other bodies.
#include <algorithm>

#include "sim/world/body.h"
#include "sim/world/step_constants.h"
#include "sim/world/walls.h"

namespace robosim::world {

namespace {

constexpr int kContactRounds = 4;  // a push out of one wall of a corner may lead into the other wall
constexpr double kAhead = 0.5;     // cosine of 60 degrees; a wall within this angle is ahead

}  // namespace

void Body::collide(const Walls& walls) {
  const bool obstacles = !walls.discs().empty();
  const Vec2 centre = circle_centre();
  const double reach = bound_radius_ + Walls::kNear;
  free_way_ = walls.clearance(centre) - reach;
  if (free_way_ > 0.0 && !(obstacles && walls.near_disc(centre, reach))) return;
  const Contacts contacts = contacts_with(walls);
  if (contacts.empty()) return;
  near_ = true;
  for (const Contact& contact : contacts)
    near_ahead_ |= !contact.embedded && dot(contact.normal, pose_.heading) < -kAhead;
  const Vec2 from = pose_.position;
  bool pushed = false;
  for (int round = 0; round < kContactRounds; ++round) {
    for (const Contact& contact : contacts) pushed |= push_out(contact, pose_.position - from);
  }
  if (!pushed) return;
  free_way_ = 0.0;
  touched_ = true;
  grip_after_contact();
}

Contacts Body::contacts_with(const Walls& walls) {
  const Vec2 centre = circle_centre();
  if (params_.outline.empty()) return walls.touch(centre, bound_radius_);
  corners_.clear();
  for (const Vec2 p : params_.outline) corners_.push_back(pose_.to_world(p));
  return walls.touch(corners_, centre, bound_radius_);
}

// Moves the body out of an overlap. Limits the body's approach so that at most the remaining gap closes
// within a tick. `moved` is the body's movement since the contact was found.
bool Body::push_out(const Contact& contact, Vec2 moved) {
  if (contact.embedded) {
    v_ = u_ = omega_ = surface_[0] = surface_[1] = 0.0;
    return true;
  }
  const Vec2 n = contact.normal, t = left_of(n);
  const double depth = contact.depth - dot(moved, n);
  if (depth > 0.0) pose_.position = pose_.position + n * depth;
  const Vec2 arm = contact.point + moved - pose_.position;
  Vec2 velocity = this->velocity();
  const double arm_n = cross(arm, n), arm_t = cross(arm, t);
  const double into = dot(velocity, n) + omega_ * arm_n + std::max(-depth, 0.0) * (1.0 / kDt);
  if (!(into < 0.0)) return depth > 0.0;
  const double push = -into / (per_mass_ + arm_n * arm_n * per_inertia_);
  velocity = velocity + n * (push * per_mass_);
  omega_ += arm_n * push * per_inertia_;
  const double along = dot(velocity, t) + omega_ * arm_t;
  const double rub =
      bounded(-along / (per_mass_ + arm_t * arm_t * per_inertia_), params_.wall_friction * push);
  omega_ = bounded(omega_ + arm_t * rub * per_inertia_, kMaxTurn);
  set_velocity(velocity + t * (rub * per_mass_));
  return true;
}

void Body::meet(Vec2 normal, double depth, double approach) {
  near_ahead_ |= dot(normal, pose_.heading) < -kAhead;
  pose_.position = pose_.position + normal * depth;
  free_way_ = 0.0;
  if (!(approach > 0.0)) return;
  set_velocity(velocity() + normal * approach);
  grip_after_contact();
}

void Body::set_velocity(Vec2 velocity) {
  v_ = along_free_ = bounded(dot(velocity, pose_.heading), kMaxSpeed);
  u_ = side_free_ = bounded(dot(velocity, left_of(pose_.heading)), kMaxSpeed);
}

// Adapts the treads' speeds to the body's speed after a contact. The floor's grip limits the change in a
// tick. Ignores the treads' push on the body, because the wall takes it up.
void Body::grip_after_contact() {
  const double ground[2] = {v_ - omega_ * half_track_, v_ + omega_ * half_track_};
  for (int i = 0; i < 2; ++i) {
    const double most = grip_limit_[i] / unit_[i].inertia;
    const double slip = ground[i] - surface_[i];
    if (std::fabs(slip) <= most) {
      surface_[i] = ground[i];
    } else {
      surface_[i] += slip > 0.0 ? most : -most;
    }
  }
}

void Body::settle_touch() {
  if (touched_ && !in_contact_) {
    ++collisions_;
    collided_with_body_ = touched_body_;
  }
  in_contact_ = touched_ || (in_contact_ && near_);
  pressed_ahead_ = in_contact_ && near_ahead_;
  touched_ = touched_body_ = near_ = near_ahead_ = false;
}

}  // namespace robosim::world
