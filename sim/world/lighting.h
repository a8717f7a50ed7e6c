// Models ambient light, as the map's [[light]] tables describe it and floor sensors measure it.
//
// At a point p of the floor a light contributes
//   L(p, t) = level d(p, t) (1 - flicker (1 - w(t)))
//
//   d, daylight   1
//   d, lamp       (h^2 / (h^2 + r^2))^(3/2) at height h above a point r away: a small lamp's illuminance of a
//                 plane (Lambert's cosine law and the inverse square), relative to the point below the lamp
//   d, sun        1 within `radius` of `at` + `moves` t, else 0: a patch of sun
//   w             4 u (1 - u), u = the fractional part of frequency t + phase: parabolas that approximate a
//                 rectified sine within 0.057
//
// A sensor receives L times its exposure x. Light enters from the side, through the gap between floor and
// robot:
//   x(h) = (h^2 / (h^2 + 5^2)) / (3^2 / (3^2 + 5^2)),  h = the sensor's height in mm
// This is the light of a uniform sky on a point 5 mm behind an edge at height h (Lambert). It is relative to
// the light at h = 3 mm. The 5 mm are estimated as half a sensor board's width.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/base/noise.h"
#include "sim/base/vec.h"
#include "sim/map/light.h"
#include "sim/world/step_constants.h"

namespace robosim::world {

class Lighting {
 public:
  /// Creates the lights. Each lamp's flicker begins with phase 0.
  explicit Lighting(const std::vector<map::Light>& lights);

  /// Draws the initial phase of each lamp's flicker.
  void draw_phases(const NoiseStream& noise);
  std::size_t count() const { return lights_.size(); }
  /// Switches a light off, or on again.
  void switch_light(std::size_t number, bool on) { lights_[number].on = on; }
  /// Returns the state that changes during a run: which lights are on.
  std::vector<bool> save() const;
  void restore(const std::vector<bool>& on);
  bool is_lit() const { return !lights_.empty(); }
  /// Returns the sum of L over all lights: the share of the white-to-black range by which the floor at p
  /// looks whiter at `t`. Valid for a sensor 3 mm above the floor.
  double at(Vec2 p, SimTime t) const;

 private:
  struct Lit {
    map::Light light;
    double phase;  // periods; initial phase of the flicker
    bool on = true;
  };
  std::vector<Lit> lights_;
};

/// Returns x: a sensor's exposure to ambient light at this height, relative to a height of 3 mm.
double exposure(double height_m);

}  // namespace robosim::world
