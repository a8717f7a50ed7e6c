#include "sim/world/lighting.h"

#include <cmath>

namespace robosim::world {
namespace {

constexpr double kBehindEdge = 0.005;  // m
constexpr double kUsualHeight = 0.003;

double under_edge(double height) { return height * height / (height * height + kBehindEdge * kBehindEdge); }

double share(const map::Light& light, Vec2 p, double seconds) {
  if (!light.at) return 1.0;
  const Vec2 off = p - *light.at - light.moves * seconds;
  if (light.radius > 0.0) return dot(off, off) <= light.radius * light.radius ? 1.0 : 0.0;
  const double cosine_square = light.height * light.height / (light.height * light.height + dot(off, off));
  return cosine_square * std::sqrt(cosine_square);
}

}  // namespace

Lighting::Lighting(const std::vector<map::Light>& lights) {
  for (const map::Light& light : lights) lights_.push_back({light, 0.0});
}

void Lighting::draw_phases(const NoiseStream& noise) {
  for (std::size_t i = 0; i < lights_.size(); ++i) lights_[i].phase = noise.uniform(i);
}

std::vector<bool> Lighting::save() const {
  std::vector<bool> on;
  for (const Lit& light : lights_) on.push_back(light.on);
  return on;
}

void Lighting::restore(const std::vector<bool>& on) {
  for (std::size_t i = 0; i < lights_.size(); ++i) lights_[i].on = on[i];
}

double Lighting::at(Vec2 p, SimTime t) const {
  const double seconds = static_cast<double>(t) * 1e-9;
  double sum = 0.0;
  for (const auto& [light, phase, on] : lights_) {
    if (!on) continue;
    double level = light.level * share(light, p, seconds);
    if (light.flicker > 0.0 && level > 0.0) {
      const double periods = light.frequency * seconds + phase;
      const double u = periods - std::floor(periods);
      level *= 1.0 - light.flicker * (1.0 - 4.0 * u * (1.0 - u));
    }
    sum += level;
  }
  return sum;
}

double exposure(double height_m) { return under_edge(height_m) / under_edge(kUsualHeight); }

}  // namespace robosim::world
