#include "sim/world/batch/bodies.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/world/rolling_step.h"

namespace robosim::batch {

using world::left;
using world::right;
using world::Roller;
using world::Rolling;
using world::Side;
using world::Two;

namespace {

Two of(const Lanes (&figure)[2], std::size_t lane) { return {figure[0][lane], figure[1][lane]}; }

// Computes each body's motion as if the body kept rolling. Sets `moves` to a value above 0 for each body that
// really keeps rolling. Sets `done` to a value above 0 for each body that keeps rolling or stands without
// being driven, and to 0 for all others.
//
// The output is separate from the input. Otherwise compilers would create masked stores, which write only the
// lanes that move. Some processors take 20 times as long for such stores.
ROBOSIM_LANES_FUNCTION void roll(const BodyBlock& block, BodyMotion& after, Lanes& moves, Lanes& done) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    const Roller<Two> body = {
        of(block.direction, i),    of(block.drives, i),           of(block.push, i),
        of(block.drag, i),         of(block.push_until, i),       of(block.brake_push, i),
        of(block.brake_drag, i),   of(block.brake_from, i),       of(block.per_radius, i),
        of(block.inertia, i),      of(block.turning_friction, i), of(block.joule0, i),
        of(block.joule1, i),       of(block.side_share, i),       of(block.owns, i),
        of(block.grip_squares, i), block.skids_from[i],           block.mass[i],
        block.mass_own[i],         block.mass_cross[i],           block.half_track[i],
        block.per_track[i],        block.bound_radius[i],         block.way_per_travel[i]};
    const Rolling<Two> now = {block.x[i],           block.y[i],         block.heading_x[i],
                              block.heading_y[i],   block.v[i],         block.omega[i],
                              of(block.surface, i), of(block.angle, i), block.wheel_travel[i],
                              block.distance[i],    block.energy[i],    block.free_way[i]};
    const double may = block.u[i] == 0.0 ? block.rolls[i] : 0.0;
    const double at_rest =
        std::fabs(now.v) + std::fabs(now.omega) + std::fabs(now.surface.l) + std::fabs(now.surface.r);
    double rests = at_rest == 0.0 ? may : 0.0;
    rests = body.drives.l + body.drives.r == 0.0 ? rests : 0.0;
    Rolling<Two> next;
    const double rolls = world::roll(body, block.stride[i], now, next).holds();
    const double ok = rolls > 0.0 ? may : 0.0;
    moves[i] = ok;
    done[i] = ok > 0.0 ? ok : rests;
    after.x[i] = next.x;
    after.y[i] = next.y;
    after.heading_x[i] = next.heading_x;
    after.heading_y[i] = next.heading_y;
    after.v[i] = next.v;
    after.u[i] = block.u[i];
    after.omega[i] = next.omega;
    after.surface[0][i] = next.surface.l;
    after.surface[1][i] = next.surface.r;
    after.angle[0][i] = next.angle.l;
    after.angle[1][i] = next.angle.r;
    after.wheel_travel[i] = next.wheel_travel;
    after.distance[i] = next.distance;
    after.energy[i] = next.energy;
    after.free_way[i] = next.free_way;
    after.slips[i] = 0.0;
  }
}

// Simulates a tick of each body that keeps rolling, or that stands without being driven. All other bodies
// stay unchanged; their `done` is 0. `after` is scratch memory.
void roll(BodyBlock& block, BodyMotion& after, Lanes& done) {
  Lanes moves;
  roll(block, after, moves, done);
  if (std::all_of(moves.of, moves.of + kLanes, [](double each) { return each > 0.0; })) {
    static_cast<BodyMotion&>(block) = after;
    return;
  }
  for (std::size_t i = 0; i < kLanes; ++i)
    if (moves[i] > 0.0) block.take(after, i);
}

}  // namespace

void BodyMotion::take(const BodyMotion& other, std::size_t i) {
  for (Lanes BodyMotion::*const figure :
       {&BodyMotion::x, &BodyMotion::y, &BodyMotion::heading_x, &BodyMotion::heading_y, &BodyMotion::v,
        &BodyMotion::u, &BodyMotion::omega, &BodyMotion::wheel_travel, &BodyMotion::distance,
        &BodyMotion::energy, &BodyMotion::free_way, &BodyMotion::slips})
    (this->*figure)[i] = (other.*figure)[i];
  for (const Side side : {left, right}) {
    surface[side][i] = other.surface[side][i];
    angle[side][i] = other.angle[side][i];
  }
}

Bodies::Bodies(const world::World& world) : walls_(world.walls()) {
  if (world.ground()) throw std::invalid_argument("a batch of bodies requires a plane floor");
}

std::size_t Bodies::add(const world::BodyParams& params, const Pose& pose) {
  const std::size_t number = bodies_.size(), lane = number % kLanes;
  bodies_.push_back(std::make_unique<world::Body>(params, pose));
  world::Body& body = *bodies_.back();
  body.place(pose);
  if (lane == 0) blocks_.emplace_back();
  BodyBlock& block = blocks_.back();
  for (const Side side : {left, right}) read_figures(number, side);
  block.skids_from[lane] = body.roller_.skids_from;
  block.mass[lane] = body.params_.mass_kg;
  block.mass_own[lane] = body.mass_own_;
  block.mass_cross[lane] = body.mass_cross_;
  block.half_track[lane] = body.half_track_;
  block.per_track[lane] = body.per_track_;
  block.bound_radius[lane] = body.bound_radius_;
  block.way_per_travel[lane] = body.way_per_travel_;
  block.stride[lane] = walls_.stride(body.bound_radius_);
  read(number);
  return number;
}

void Bodies::command(std::size_t number, Side side, const world::WheelCommand& command) {
  bodies_[number]->command(side, command);
  read_figures(number, side);
}

void Bodies::read_figures(std::size_t number, Side side) {
  const Roller<world::Pair>& roller = bodies_[number]->roller_;
  BodyBlock& block = blocks_[number / kLanes];
  const std::size_t lane = number % kLanes;
  block.direction[side][lane] = roller.direction[side];
  block.drives[side][lane] = roller.drives[side];
  block.push[side][lane] = roller.push[side];
  block.drag[side][lane] = roller.drag[side];
  block.push_until[side][lane] = roller.push_until[side];
  block.brake_push[side][lane] = roller.brake_push[side];
  block.brake_drag[side][lane] = roller.brake_drag[side];
  block.brake_from[side][lane] = roller.brake_from[side];
  block.per_radius[side][lane] = roller.per_radius[side];
  block.inertia[side][lane] = roller.inertia[side];
  block.turning_friction[side][lane] = roller.turning_friction[side];
  block.joule0[side][lane] = roller.joule0[side];
  block.joule1[side][lane] = roller.joule1[side];
  block.side_share[side][lane] = roller.side_share[side];
  block.owns[side][lane] = roller.owns[side];
  block.grip_squares[side][lane] = roller.grip_squares[side];
}

void Bodies::place(std::size_t number, const Pose& pose) {
  write(number);
  bodies_[number]->place(pose);
  read(number);
}

const world::Body& Bodies::body(std::size_t number) const {
  write(number);
  return *bodies_[number];
}

// Writes the state from the block to the body itself.
void Bodies::write(std::size_t number) const {
  const BodyBlock& block = blocks_[number / kLanes];
  const std::size_t lane = number % kLanes;
  world::Body& body = *bodies_[number];
  body.pose_ = {{block.x[lane], block.y[lane]}, {block.heading_x[lane], block.heading_y[lane]}};
  body.v_ = block.v[lane];
  body.u_ = block.u[lane];
  body.omega_ = block.omega[lane];
  for (const Side side : {left, right}) {
    body.surface_[side] = block.surface[side][lane];
    body.angle_[side] = block.angle[side][lane];
  }
  body.wheel_travel_ = block.wheel_travel[lane];
  body.distance_ = block.distance[lane];
  body.energy_ = block.energy[lane];
  body.free_way_ = block.free_way[lane];
  body.slips_ = block.slips[lane] > 0.0;
}

void Bodies::read(std::size_t number) {
  BodyBlock& block = blocks_[number / kLanes];
  const std::size_t lane = number % kLanes;
  const world::Body& body = *bodies_[number];
  block.x[lane] = body.pose_.position.x;
  block.y[lane] = body.pose_.position.y;
  block.heading_x[lane] = body.pose_.heading.x;
  block.heading_y[lane] = body.pose_.heading.y;
  block.v[lane] = body.v_;
  block.u[lane] = body.u_;
  block.omega[lane] = body.omega_;
  for (const Side side : {left, right}) {
    block.surface[side][lane] = body.surface_[side];
    block.angle[side][lane] = body.angle_[side];
  }
  block.wheel_travel[lane] = body.wheel_travel_;
  block.distance[lane] = body.distance_;
  block.energy[lane] = body.energy_;
  block.free_way[lane] = body.free_way_;
  block.slips[lane] = body.slips_ ? 1.0 : 0.0;
  block.rolls[lane] = body.is_ordinary_ && !body.in_contact_ ? 1.0 : 0.0;
}

void Bodies::step_alone(std::size_t number) {
  write(number);
  bodies_[number]->step_closely(walls_, nullptr);
  bodies_[number]->settle_contact();
  read(number);
}

void Bodies::step() {
  const bool obstacles = !walls_.discs().empty();
  BodyMotion after;
  for (std::size_t first = 0; first < bodies_.size(); first += kLanes) {
    BodyBlock& block = blocks_[first / kLanes];
    Lanes done;
    if (!obstacles) roll(block, after, done);
    for (std::size_t lane = 0; lane < kLanes && first + lane < bodies_.size(); ++lane)
      if (done[lane] == 0.0) step_alone(first + lane);
  }
}

}  // namespace robosim::batch
