// Simulates one robot's body: two driven wheels, a caster and an outline. The body has a differential drive
// with motors, friction and grip.
//
// A tick lasts dt = 1 ms. It starts with the velocities v (forward), u (to the left), omega
// (counter-clockwise), and w of each wheel:
//   1. The pose moves with these velocities, along their arc, exactly to pose_after(1 ms).
//   2. Motors, friction and grip change the velocities.
//   3. Walls, obstacles and other bodies push the outline out, and stop its velocity towards them.
// Velocities are therefore constant inside a tick. Sensors can extrapolate exactly from the tick's start.
//
// Each wheel of radius r has these constants; m is the body's mass. All torques are at the wheel's axle. A
// motor's data sheet gives nominal_volts, stall_current, stall_torque, no_load_current and no_load_rate.
//   R    = nominal_volts / stall_current                                   terminal resistance
//   k_t  = stall_torque / (stall_current - no_load_current)                torque per ampere
//   k_e  = (nominal_volts - R no_load_current) / no_load_rate              volts per rad/s
//   T_c  = k_t no_load_current + T_r, T_r = rolling_resistance m g r / 2   friction while it turns
//   T_s  = static_friction k_t no_load_current + T_r                       friction that holds it at rest
// At nominal_volts, a lifted wheel turns at no_load_rate, and a blocked wheel exerts stall_torque.
//
// The current depends on the driver's state:
//   driven (share |drive| of the tick):  i = max(0, supply - drop - k_e w) / (R + driver_ohms), for drive > 0
//   shorted (share brake):               i = -max(0, k_e w - drop) / (R + driver_ohms), for w > 0
//   open (the rest):                     i = 0
// If the winding's inductance is given, motor_winding.h computes i instead (body_winding.cpp). In both cases,
//   J dw/dt = k_t i - friction - r F,    J = wheel_inertia + rotor_inertia gear_ratio^2
// where F is the force of the wheel on the ground:
//   m dv/dt = F_left + F_right,   I domega/dt = (F_right - F_left) track / 2,   m v omega = S_left + S_right
//   F^2 + S^2 <= (grip (load_share m g + downforce) / 2)^2     S: the wheel's half of the sideways force
// While F is below that limit, the wheel rolls (r w = ground speed). At the limit the wheel slips: the speeds
// of wheel and ground differ. If S alone exceeds the share kSkidShare of the grip, the body skids sideways.
// The step is implicit in the velocities, and therefore stable for all parameters.
//
// Other files describe hills, surfaces and shifting loads (body_ground.cpp), skid steering (body_skid.cpp),
// and steered wheels (body_steer.cpp).
#pragma once

#include <cmath>
#include <vector>

#include "sim/base/vec.h"
#include "sim/world/floor_gaps.h"
#include "sim/world/motor_winding.h"
#include "sim/world/rolling_step.h"

namespace robosim::batch {
class Bodies;
}

namespace robosim::world {

class Ground;
class Contacts;
class Walls;
struct Contact;

/// A motor driver's output, averaged over one tick.
struct WheelCommand {
  double drive = 0.0;  ///< -1..1: signed fraction of time (or PWM duty) with the supply across the motor
  double brake =
      0.0;  ///< 0..1: fraction of time with the motor's terminals shorted; the rest is open (coasting)
  // Used only if a winding has inductance. `brake` includes twice the fraction `against`: without inductance,
  // equal times in both directions act like a short (motor_driver.h).
  double against = 0.0;   ///< 0..1: fraction of time driven in the direction opposite to `drive`
  double period_s = 0.0;  ///< s, PWM period; 0 = no PWM, or an unknown period

  bool operator==(const WheelCommand&) const = default;
};

enum Side { left = 0, right = 1 };

/// One wheel and its gear motor. Rates and torques apply to the gear's output, as in data sheets.
struct WheelParams {
  double nominal_volts = 0.0;       ///< V at which the next four values apply
  double no_load_rate = 0.0;        ///< rad/s
  double no_load_current = 0.0;     ///< A; consumed by friction in motor and gear
  double stall_torque = 0.0;        ///< N m
  double stall_current = 0.0;       ///< A; more than no_load_current
  double static_friction = 0.0;     ///< motor and gear: ratio of static to kinetic friction; at least 1
  double gear_ratio = 0.0;          ///< motor turns for each turn of the wheel
  double rotor_inertia_kgm2 = 0.0;  ///< motor rotor
  double wheel_inertia_kgm2 = 0.0;  ///< wheel about its axle
  double radius_m = 0.0;            ///< wheel radius
  double inductance_h = 0.0;        ///< H of the winding; 0 = ignored
};

/// All parameters of a body. Zero is not a default: start from default_body_params(), or set every field.
struct BodyParams {
  WheelParams wheel[2];            ///< left, right
  double supply_volts = 0.0;       ///< V at the driver's supply pin, until supply() changes it
  double driver_drop_volts = 0.0;  ///< V lost in bipolar switches at any current (L298N 1.4; MOSFETs 0)
  double driver_ohms = 0.0;        ///< ohm of both switches in series with the motor (L298N 1.15, TB6612 0.5)
  double driver_diode_volts = 0.0;  ///< V lost in each freewheeling diode
  bool driver_both_ways = true;     ///< switches conduct both ways (MOSFETs); false: one way, with diodes
  bool driver_single = false;       ///< the driver is a single switch, with a diode across the motor
  double track_m = 0.0;             ///< m between the wheels' contact points
  double mass_kg = 0.0;             ///< kg, total; centred on the axle's centre
  double yaw_inertia_kgm2 = 0.0;    ///< kg m2 about the axle's centre, without the wheels' own spin
  double load_share = 0.0;  ///< 0..1 of the weight on the driven wheels, half on each; the rest on the caster
  double rolling_resistance = 0.0;  ///< force / weight: tyres and caster
  double grip = 0.0;                ///< friction coefficient between tyre and floor
  double wall_friction = 0.0;       ///< friction coefficient between outline and wall
  /// Outline in the body's frame (x forward, y left, axle's centre at 0,0). A convex polygon,
  /// counter-clockwise; or empty, which means a circle of `radius_m` about `centre`.
  std::vector<Vec2> outline;
  double radius_m = 0.0;  ///< m; the circle's radius; unused with a polygon
  Vec2 centre;            ///< m; the circle's centre; unused with a polygon
  // Used on hills, with shifting loads, and by bodies with skid steering, fans or steered wheels.
  double caster_m = -0.05;         ///< m; the caster's position ahead of the axle; not 0
  double caster_radius_m = 0.008;  ///< m; radius of the caster, a ball
  double centre_height_m = 0.0;    ///< m; height of the centre of mass; 0 = loads do not shift
  double wheelbase_m = 0.0;        ///< m between front and rear wheel of a skid-steered body; 0 = caster
  double downforce_n = 0.0;        ///< N from fans, until press() changes it; half on each wheel
  double steer_base_m = 0.0;       ///< m from the axle to the steered wheels ahead; 0 = no steered wheels
  bool differential = false;       ///< steered bodies: one motor gives each wheel half of its torque
};

/// Returns the parameters of a small robot with two wheels: TT gear motors (1:48) with 65 mm wheels on an
/// L298N at 7.4 V. Sources: docs/evidence/models.md.
BodyParams default_body_params();

/// Returns the effective track width, m, of a body that turns by skidding (body_skid.cpp).
double effective_track(double track, double wheelbase);

/// Returns the steering angle at the body's middle, rad. `inner` is the angle of the inner steered wheel. The
/// two steered wheels are `track` apart (body_steer.cpp).
double steered_middle(double inner, double track, double steer_base);

/// How a body has fallen over.
enum class Toppled { no, over, off_an_edge };

/// A body's lean and its rate of change, in the body's frame (x ahead, y to the left).
struct Lean {
  Vec2 low;            ///< sine of the angle, towards the lowest side
  double level = 1.0;  ///< cosine of the angle
  Vec2 rate;           ///< rad/s by which the angle grows, towards the side that sinks
};

class Body {
 public:
  /// Throws std::invalid_argument for meaningless values (see BodyParams), not for unusual ones.
  Body(const BodyParams&, const Pose&);

  const BodyParams& params() const { return params_; }

  /// Returns the pose at the beginning of the current tick. The next functions refer to the same time.
  const Pose& pose() const { return pose_; }
  /// Returns the pose `dt_s` seconds after the beginning of the current tick, extrapolated with constant
  /// velocities. The pose lies on an arc of angle a = omega dt:
  ///   position + heading (v sin a - u (1 - cos a)) / omega + left (v (1 - cos a) + u sin a) / omega
  /// Sine and cosine are polynomials (error below a^5 / 120 of the distance), and the heading is
  /// renormalised.
  Pose pose_after(double dt_s) const;
  /// Returns the pose of a body that does not move, at any time in the tick.
  Pose standing_pose() const {
    const Vec2 h = pose_.heading;
    return {pose_.position, h * (1.5 - 0.5 * dot(h, h))};
  }
  double speed() const { return v_; }                     ///< m/s, forward
  double side_speed() const { return u_; }                ///< m/s, to the left; 0 except in skids
  double turn_rate() const { return omega_; }             ///< rad/s, counter-clockwise
  double wheel_angle(Side s) const { return angle_[s]; }  ///< rad since the start, forward positive
  /// Returns the wheel's rate during the tick, rad/s. Within the tick, wheel_angle(s) + wheel_rate(s) dt is
  /// exact.
  double wheel_rate(Side s) const { return surface_[s] * unit_[s].per_radius; }
  double tread_speed(Side s) const { return surface_[s]; }  ///< m/s at the tread, also in slip
  /// Returns whether a tyre slips on the floor, lengthwise or sideways.
  bool slips() const { return slips_; }
  double distance() const { return distance_; }  ///< m travelled by the axle's centre; only grows
  /// Returns the mean distance that the two wheels have turned through, m. It only grows, even during slip or
  /// spin.
  double wheel_travel() const { return wheel_travel_; }
  double energy() const { return energy_; }            ///< J drawn from the battery by the motors
  double energy_back() const { return energy_back_; }  ///< J returned to the battery by the motors
  /// Returns the number of contacts with walls, edges, obstacles and other bodies. A lasting contact counts
  /// once.
  int collisions() const { return collisions_; }
  /// Returns whether the latest counted contact was with another body.
  bool collided_with_body() const { return collided_with_body_; }
  bool in_contact() const { return in_contact_; }
  /// Returns the present contacts with walls, obstacles and the map's edge.
  Contacts contacts_with(const Walls& walls);
  /// Returns whether something presses against the body from within 60 degrees of straight ahead, as a bumper
  /// would detect.
  bool pressed_ahead() const { return pressed_ahead_; }
  /// Returns whether the body's outline covers a point of the floor.
  bool covers(Vec2 p) const;
  /// Returns the centre of the circle that bounds the outline, m. The circle is centred on the outline's
  /// middle.
  Vec2 circle_centre() const { return pose_.to_world(bound_centre_); }
  double bound_radius() const { return bound_radius_; }
  /// Returns an upper bound, m, for the movement of circle_centre() within a duration. The bound is twice the
  /// movement that speeds and grip allow on a plane floor without outside influence.
  double reach(double seconds) const;
  /// Returns the kinetic energy of body and wheels, J.
  double kinetic_energy() const;

  /// Sets a motor's command until the next call. Clamps the command's values to -1..1 or 0..1.
  void command(Side, const WheelCommand&);
  void place(const Pose&);  ///< lifts the body and puts it down at rest

  // The next functions set outside influences. Each lasts until the same function is called again.
  /// Sets the driver's supply, V; the initial value is params().supply_volts.
  void supply(double supply_volts);
  /// Sets a downforce in addition to the body's weight, N.
  void press(double downforce_n);
  /// Sets the angle of the steered wheels, rad, positive to the left; limited to 80 degrees.
  void steer(double angle);
  double steered() const { return steered_; }
  /// The current that the motors draw from a given supply voltage, with their present commands and speeds.
  struct Draw {
    double amps = 0.0, amps_per_volt = 0.0;
  };
  Draw draw(double supply_volts) const;
  /// Returns the least share of full power at which the motor turns its wheel from rest with the present
  /// supply. The value may exceed 1. To turn on the spot, a robot may need more power.
  double turning_drive(Side side) const { return unit_[side].friction[1] / unit_[side].push; }
  /// Blocks a wheel: it does not turn, whatever its motor and the floor do. The motor stalls.
  void block(Side, bool blocked);
  /// Lifts the body: it stays in place and touches nothing. Its wheels turn freely, without rolling
  /// resistance. place() puts it down.
  void lift(bool lifted);
  /// Moves the lifted body over the floor. During this manual move its sensors see the floor. lift() and
  /// place() end the move.
  void carry(const Pose&);
  /// Tilts the lifted body. lift(), carry() and place() level it. On hills the body leans as the floor does.
  void tilt(const Lean&);
  const Lean& lean() const { return lean_; }
  /// Returns whether and how the body has fallen over, its wheels in the air; place() puts it upright.
  Toppled toppled() const { return stance_.toppled; }
  /// Returns how much higher a point of the chassis (in the body's frame) is than on a plane floor, m.
  double raised(Vec2 own) const { return stance_.axle + stance_.pitch * own.x + stance_.roll * own.y; }
  bool lifted() const { return lifted_ && !carried_; }
  bool in_hand() const { return lifted_; }  ///< lifted or carried
  /// Returns whether the next tick would change nothing, on a plane floor without outside influence.
  bool is_still() const {
    return v_ == 0.0 && omega_ == 0.0 && u_ == 0.0 && surface_[0] == 0.0 && surface_[1] == 0.0 && !driven() &&
           !lifted_ && !in_contact_ && stance_.toppled == Toppled::no &&
           (stance_.eases || !(params_.centre_height_m > 0.0));
  }

 private:
  friend class World;
  friend class batch::Bodies;  // computes the same tick for many bodies at once

  // Constants derived from a wheel's parameters. Forces and speeds apply at the tyre's tread. Impulses are
  // per tick.
  struct Unit {
    double per_radius;
    double inertia;      // kg: J / r^2
    double friction[2];  // N s per tick: turning, at rest
    // If the motor is driven for a whole tick, the impulse is push - drag * speed, N s. The energy is
    // joule0 - joule1 * speed, J. These formulas apply if the speed in the direction of `drive` is below
    // push_until; else impulse and energy are 0. If the motor is shorted for a whole tick, the impulse is
    // brake_push - drag * speed. This formula applies if the speed is above brake_from.
    double push, drag, push_until, brake_push, brake_from, joule0, joule1;
    double drive, brake;  // from the command
    double per_ohm, volts_per_speed;
  };
  struct Motor {
    double push, drag;
  };
  // The state of a motor whose winding has inductance.
  struct Winding {
    double seconds = 0.0;  // L / R
    double tau = 0.0;      // seconds / the command's period
    double against = 0.0;  // from the command
    int phases = 0;
    struct {
      int what;
      double share, decay;
    } phase[4] = {};
    MeanCurrent current;  // at the wheel's speed at the tick's beginning
    Motor pull = {0.0, 0.0};
    double emf = 0.0;  // V, back-EMF at the tick's beginning
  };

  // How the body stands on a floor that is not plane.
  struct Stance {
    bool known = false;                  // whether the other members are valid for the present place
    double height[3] = {0.0, 0.0, 0.0};  // m; left wheel, right wheel, caster
    Vec2 rise[3];                        // gradients of these heights
    double sunk[3] = {0.0, 0.0, 0.0};    // m below the floor, in gaps between boards
    double axle = 0.0;                   // m; height of the chassis at the axle
    bool is_at_face = false;             // whether a vertical face of the ground stops a wheel
    Pose face;                           // the pose at that face
    double pitch = 0.0, roll = 0.0;      // sines; positive: front up, left side up
    bool eases = false;                  // neither slope nor tipping accelerates the body
    double speed = 0.0;                  // m/s: v in the previous tick, plus gains that shift no load
    double gain = 0.0;                   // m/s2; smoothed acceleration
    double tip[2] = {0.0, 0.0};          // rad by which the caster [0], or a wheel [1], has left the floor
    double tip_rate[2] = {0.0, 0.0};     // rad/s
    Toppled toppled = Toppled::no;
  };

  // Computes one tick. `ground` is null if the floor is a plane with one surface.
  void step(const Walls& walls, Ground* ground) {
    if (ground || !roll_on(walls)) step_closely(walls, ground);
  }
  bool roll_on(const Walls&);
  void step_closely(const Walls&, Ground*);
  bool stand(Ground* ground, const Pose& before, double travel);
  bool halt();
  double foot_radius(int i) const;
  double hub_share(int i) const;
  void find_footing(const Ground*, Vec2* at, Vec2* rises);
  void set_scrub();
  void scrub();
  void bump(const Vec2* before, const Vec2* rises);
  void jolt(const FloorGaps&, const Pose& before, const Stance& last, const Vec2* at, Vec2* rises);
  double share_on(int i) const;
  FloorGaps::Roller roller(int i) const;
  void pull(const Vec2* at, const Vec2* rises);
  void share_load(Ground*, const Vec2* at);
  void tip(int which, double push, double arm);
  void rub(Side);
  void set_grip();
  void spin();
  void advance(double dt);
  void accelerate();
  void accelerate_steered();
  Motor motor(Side) const;
  void tell_roller(Side);
  void set_roller(Side);
  void set_winding(Side, const WheelCommand&);
  MeanCurrent current_of(int side, double supply_volts) const;
  void find_currents();
  Motor pull_of_winding(Side) const;
  void draw_by_windings();
  void solve_friction(double* speed, const double* impulse, const double* friction, const Motor* m) const;
  void solve_slip(const Motor* m, const double* friction, const double* limit);
  void draw_energy();
  bool driven() const { return unit_[left].drive != 0.0 || unit_[right].drive != 0.0; }
  void collide(const Walls&);
  bool push_out(const Contact&, Vec2 moved);
  void meet(Vec2 normal, double depth, double approach);
  Vec2 velocity() const { return pose_.heading * v_ + left_of(pose_.heading) * u_; }
  void set_velocity(Vec2 velocity);
  void grip_after_contact();
  void settle_contact() {
    if (touched_ | near_ | in_contact_) [[unlikely]]
      settle_touch();
  }
  void settle_touch();

  Pose pose_;
  double v_ = 0.0, u_ = 0.0, omega_ = 0.0;
  double surface_[2] = {0.0, 0.0};  // tread speeds, m/s: w r
  double angle_[2] = {0.0, 0.0};
  Unit unit_[2] = {};
  Roller<Pair> roller_ = {};  // inputs of rolling_step.h, from unit_ and the other members
  bool is_ordinary_ = false;  // the body may use rolling_step.h
  double mass_own_ = 0.0,
         mass_cross_ = 0.0;  // kg: a wheel's impulse per its own ground speed, and per the other wheel's
  double half_track_ = 0.0, per_track_ = 0.0;
  double grip_limit_[2] = {0.0, 0.0};                  // N s per tick, for each wheel
  double side_share_[2] = {0.5, 0.5};                  // each wheel's share of a sideways force
  double rolling_[2] = {0.0, 0.0};                     // N at each wheel's tread
  double scrub_rolling_ = 0.0, scrub_slipping_ = 0.0;  // rad/s per tick
  double per_mass_ = 0.0, per_inertia_ = 0.0;
  double bound_radius_ = 0.0;  // radius of the bounding circle about bound_centre_
  Vec2 bound_centre_;
  double way_per_travel_ = 0.0;  // maximum movement of the circle's centre per m of travel in step(), m
  double free_way_ = 0.0;        // m that the circle may move before it can touch a wall; ignores discs
  bool slips_ = false;
  bool lifted_ = false, carried_ = false;
  Lean lean_;
  Stance stance_;
  bool blocked_[2] = {false, false};
  bool touched_ = false, near_ = false, in_contact_ = false;
  bool near_ahead_ = false, pressed_ahead_ = false;
  int collisions_ = 0;
  bool touched_body_ = false, collided_with_body_ = false;
  double distance_ = 0.0;
  double wheel_travel_ = 0.0;
  double energy_ = 0.0, energy_back_ = 0.0;
  bool winds_ = false;   // a winding has inductance
  double supply_ = 0.0;  // V
  Winding winding_[2];
  double steered_ = 0.0, steer_cosine_ = 1.0, steer_sine_ = 0.0;  // rad; angle of the steered wheels
  double curvature_ = 0.0;                                        // 1/m; curvature of the steered path
  double steer_limit_ = 0.0;                                      // N s per tick; grip of the steered wheels
  double side_free_ = 0.0, along_free_ = 0.0;  // u and v in the turned frame of the new pose
  BodyParams params_;
  std::vector<Vec2> corners_;  // outline in the world frame, if near something
};

inline Body::Motor Body::motor(Side side) const {
  if (winds_) [[unlikely]]
    return winding_[side].pull;
  const Unit& unit = unit_[side];
  const double speed = surface_[side];
  Motor m{0.0, 0.0};
  if (std::copysign(1.0, unit.drive) * speed < unit.push_until) {
    m = {unit.drive * unit.push, std::fabs(unit.drive) * unit.drag};
  }
  if (unit.brake != 0.0 && std::fabs(speed) > unit.brake_from) {
    m.push += unit.brake * std::copysign(unit.brake_push, speed);
    m.drag += unit.brake * unit.drag;
  }
  return m;
}

[[gnu::always_inline]] inline Pose Body::pose_after(double dt_s) const {
  const double a = omega_ * dt_s;
  const double a2 = a * a;
  const double sine = a * (1.0 - a2 * (1.0 / 6.0 - a2 * (1.0 / 120.0)));
  const double cosine = 1.0 - a2 * (0.5 - a2 * (1.0 / 24.0));
  const double mean_sine = a * (0.5 - a2 * (1.0 / 24.0));                  // (1 - cos a) / a
  const double mean_cosine = 1.0 - a2 * (1.0 / 6.0 - a2 * (1.0 / 120.0));  // sin a / a
  const Vec2 h = pose_.heading;
  const Vec2 turned = h * cosine + left_of(h) * sine;
  const double ahead = dt_s * (v_ * mean_cosine - u_ * mean_sine);
  const double aside = dt_s * (v_ * mean_sine + u_ * mean_cosine);
  return {pose_.position + h * ahead + left_of(h) * aside, turned * (1.5 - 0.5 * dot(turned, turned))};
}

}  // namespace robosim::world
