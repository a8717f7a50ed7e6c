#include "sim/batch/bodies.h"

#include <cmath>
#include <stdexcept>

#include "sim/world/step.h"

namespace robosim::batch {

using world::kDt;
using world::kMaxSpeed;
using world::kMaxTurn;
using world::kSkidShare;
using world::left;
using world::right;
using world::Side;

namespace {

constexpr double kStill = 1e-6;  // as in body.cpp

// world::bounded(), without a branch.
inline double bounded(double x, double bound) {
  const double low = x < -bound ? -bound : x;
  const double both = x > bound ? bound : low;
  return both == both ? both : 0.0;
}

// Body::step() of each body that rolls on, as it is written there; where no comment says otherwise, what is
// left out here has no part in that. The others are as they were, and `done` is 0 of them.
ROBOSIM_LANES_FUNCTION void roll(BodyBlock& block, Lanes& done) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    const double v = block.v[i], omega = block.omega[i];
    const double s0 = block.surface[0][i], s1 = block.surface[1][i];

    // motor()
    const bool is_driven0 = block.direction[0][i] * s0 < block.push_until[0][i];
    const bool is_driven1 = block.direction[1][i] * s1 < block.push_until[1][i];
    const bool is_braked0 = std::fabs(s0) > block.brake_from[0][i];
    const bool is_braked1 = std::fabs(s1) > block.brake_from[1][i];
    double push0 = is_driven0 ? block.push[0][i] : 0.0, drag0 = is_driven0 ? block.drag[0][i] : 0.0;
    double push1 = is_driven1 ? block.push[1][i] : 0.0, drag1 = is_driven1 ? block.drag[1][i] : 0.0;
    push0 += is_braked0 ? std::copysign(block.brake_push[0][i], s0) : 0.0;
    drag0 += is_braked0 ? block.brake_drag[0][i] : 0.0;
    push1 += is_braked1 ? std::copysign(block.brake_push[1][i], s1) : 0.0;
    drag1 += is_braked1 ? block.brake_drag[1][i] : 0.0;

    double ok = block.rolls[i];
    const double at_rest = std::fabs(v) + std::fabs(omega) + std::fabs(s0) + std::fabs(s1);
    const double drives = block.drives[0][i] + block.drives[1][i];
    // A body that stands, and is not driven, stays as it is.
    ok = block.u[i] == 0.0 ? ok : 0.0;
    double rests = at_rest == 0.0 ? ok : 0.0;
    rests = drives == 0.0 ? rests : 0.0;

    const double travel = (std::fabs(v) + std::fabs(omega) * block.bound_radius[i]) * kDt;
    ok = travel <= block.stride[i] ? ok : 0.0;
    const double free_way = block.free_way[i] - block.way_per_travel[i] * travel;
    ok = free_way > 0.0 ? ok : 0.0;  // else it looks for walls

    // advance(), pose_after()
    const double a = omega * kDt;
    const double a2 = a * a;
    const double sine = a * (1.0 - a2 * (1.0 / 6.0 - a2 * (1.0 / 120.0)));
    const double cosine = 1.0 - a2 * (0.5 - a2 * (1.0 / 24.0));
    const double mean_sine = a * (0.5 - a2 * (1.0 / 24.0));
    const double mean_cosine = 1.0 - a2 * (1.0 / 6.0 - a2 * (1.0 / 120.0));
    const double hx = block.heading_x[i], hy = block.heading_y[i];
    const double tx = hx * cosine + -hy * sine, ty = hy * cosine + hx * sine;
    const double ahead = kDt * (v * mean_cosine), aside = kDt * (v * mean_sine);
    const double x = block.x[i] + hx * ahead + -hy * aside, y = block.y[i] + hy * ahead + hx * aside;
    const double norm = 1.5 - 0.5 * (tx * tx + ty * ty);
    const double nx = tx * norm, ny = ty * norm;
    const double side_free = -((hx * ny - hy * nx) * v);
    const double angle0 = block.angle[0][i] + s0 * block.per_radius[0][i] * kDt;
    const double angle1 = block.angle[1][i] + s1 * block.per_radius[1][i] * kDt;
    const double wheel_travel = block.wheel_travel[i] + 0.5 * (std::fabs(s0) + std::fabs(s1)) * kDt;
    const double distance = block.distance[i] + std::fabs(v) * kDt;

    // accelerate()
    const double sideways = -side_free * block.mass[i];
    const double limit0 = block.grip_limit[0][i], limit1 = block.grip_limit[1][i];
    ok = std::fabs(sideways) <= kSkidShare * (limit0 + limit1) ? ok : 0.0;  // else it skids
    const double own = block.mass_own[i], other = block.mass_cross[i], half_track = block.half_track[i];
    const double ground0 = v - omega * half_track, ground1 = v + omega * half_track;
    const double momentum0 = own * ground0 + other * ground1, momentum1 = other * ground0 + own * ground1;
    const double impulse0 = momentum0 + block.inertia[0][i] * s0 + push0;
    const double impulse1 = momentum1 + block.inertia[1][i] * s1 + push1;
    const double own0 = own + block.inertia[0][i] + drag0, own1 = own + block.inertia[1][i] + drag1;
    const double per_determinant = 1.0 / (own0 * own1 - other * other);
    const double p0 = impulse0 - std::copysign(block.turning_friction[0][i], s0);
    const double p1 = impulse1 - std::copysign(block.turning_friction[1][i], s1);
    const double y0 = (own1 * p0 - other * p1) * per_determinant;
    const double y1 = (own0 * p1 - other * p0) * per_determinant;
    ok = y0 * s0 > 0.0 ? ok : 0.0;  // else friction may hold a wheel
    ok = y1 * s1 > 0.0 ? ok : 0.0;
    const double traction0 = own * y0 + other * y1 - momentum0;
    const double traction1 = other * y0 + own * y1 - momentum1;
    const double side0 = block.side_share[0][i] * sideways, side1 = block.side_share[1][i] * sideways;
    ok = traction0 * traction0 <= limit0 * limit0 - side0 * side0 ? ok : 0.0;  // else it slips
    ok = traction1 * traction1 <= limit1 * limit1 - side1 * side1 ? ok : 0.0;
    const double next0 = bounded(y0, kMaxSpeed), next1 = bounded(y1, kMaxSpeed);
    const double next_v = 0.5 * (next0 + next1);
    const double next_omega = bounded((next1 - next0) * block.per_track[i], kMaxTurn);

    // draw_energy()
    const double joules0 = block.joule0[0][i] - block.joule1[0][i] * (block.direction[0][i] * next0);
    const double joules1 = block.joule0[1][i] - block.joule1[1][i] * (block.direction[1][i] * next1);
    double energy = block.energy[i] + block.drives[0][i] * (joules0 < 0.0 ? 0.0 : joules0);
    energy += block.drives[1][i] * (joules1 < 0.0 ? 0.0 : joules1);
    // It may come to rest.
    const double fastest = std::fabs(next0) < std::fabs(next1) ? std::fabs(next1) : std::fabs(next0);
    const double goes = drives > 0.0 ? 1.0 : fastest < kStill ? 0.0 : 1.0;
    ok = goes > 0.0 ? ok : 0.0;

    const bool moves = ok > 0.0;
    done[i] = ok > 0.0 ? ok : rests;
    block.x[i] = moves ? x : block.x[i];
    block.y[i] = moves ? y : block.y[i];
    block.heading_x[i] = moves ? nx : hx;
    block.heading_y[i] = moves ? ny : hy;
    block.v[i] = moves ? next_v : v;
    block.omega[i] = moves ? next_omega : omega;
    block.surface[0][i] = moves ? next0 : s0;
    block.surface[1][i] = moves ? next1 : s1;
    block.angle[0][i] = moves ? angle0 : block.angle[0][i];
    block.angle[1][i] = moves ? angle1 : block.angle[1][i];
    block.wheel_travel[i] = moves ? wheel_travel : block.wheel_travel[i];
    block.distance[i] = moves ? distance : block.distance[i];
    block.energy[i] = moves ? energy : block.energy[i];
    block.free_way[i] = moves ? free_way : block.free_way[i];
    block.slips[i] = moves ? 0.0 : block.slips[i];
  }
}

}  // namespace

Bodies::Bodies(const world::World& world) : walls_(world.walls()) {
  if (world.ground()) throw std::invalid_argument("a batch of bodies needs a floor that is plane");
}

std::size_t Bodies::add(const world::BodyParams& params, const Pose& pose) {
  const std::size_t number = bodies_.size(), lane = number % kLanes;
  bodies_.push_back(std::make_unique<world::Body>(params, pose));
  world::Body& body = *bodies_.back();
  body.place(pose);
  if (lane == 0) blocks_.emplace_back();
  BodyBlock& block = blocks_.back();
  for (const Side side : {left, right}) {
    const world::Body::Unit& unit = body.unit_[side];
    block.per_radius[side][lane] = unit.per_radius;
    block.inertia[side][lane] = unit.inertia;
    block.turning_friction[side][lane] = unit.friction[0];
    block.joule0[side][lane] = unit.joule0;
    block.joule1[side][lane] = unit.joule1;
    block.push_until[side][lane] = unit.push_until;
    block.brake_from[side][lane] = unit.brake_from;
    block.grip_limit[side][lane] = body.grip_limit_[side];
    block.side_share[side][lane] = body.side_share_[side];
    read_command(number, side);
  }
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
  read_command(number, side);
}

void Bodies::read_command(std::size_t number, Side side) {
  const world::Body::Unit& unit = bodies_[number]->unit_[side];
  BodyBlock& block = blocks_[number / kLanes];
  const std::size_t lane = number % kLanes;
  block.direction[side][lane] = std::copysign(1.0, unit.drive);
  block.drives[side][lane] = std::fabs(unit.drive);
  block.push[side][lane] = unit.drive * unit.push;
  block.drag[side][lane] = std::fabs(unit.drive) * unit.drag;
  block.brake_push[side][lane] = unit.brake * unit.brake_push;
  block.brake_drag[side][lane] = unit.brake * unit.drag;
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

// To the body itself.
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
  const bool is_ordinary = !body.winds_ && !(body.params_.centre_height_m > 0.0) &&
                           !(body.params_.steer_base_m > 0.0) && !(body.scrub_rolling_ > 0.0);
  block.rolls[lane] = is_ordinary && !body.in_contact_ ? 1.0 : 0.0;
}

void Bodies::step_alone(std::size_t number) {
  write(number);
  bodies_[number]->step(walls_, nullptr);
  bodies_[number]->settle_contact();
  read(number);
}

void Bodies::step() {
  const bool obstacles = !walls_.discs().empty();
  for (std::size_t first = 0; first < bodies_.size(); first += kLanes) {
    BodyBlock& block = blocks_[first / kLanes];
    Lanes done;
    if (!obstacles) roll(block, done);
    for (std::size_t lane = 0; lane < kLanes && first + lane < bodies_.size(); ++lane)
      if (done[lane] == 0.0) step_alone(first + lane);
  }
}

}  // namespace robosim::batch
