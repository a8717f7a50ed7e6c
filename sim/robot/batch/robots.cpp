#include "sim/robot/batch/robots.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "sim/base/error.h"
#include "sim/robot/describe.h"
#include "sim/robot/electronics.h"
#include "sim/robot/part_context.h"
#include "sim/robot/parts/reflectance.h"
#include "sim/robot/parts/wheel_motor.h"

namespace robosim::batch {
namespace {

// Computes the result of Body::pose_after().
ROBOSIM_LANES_FUNCTION void extrapolate(const BodyBlock& block, const Lanes& dt_s, SensorPoses& pose) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    const double dt = dt_s[i], v = block.v[i], u = block.u[i];
    const double a = block.omega[i] * dt;
    const double a2 = a * a;
    const double sine = a * (1.0 - a2 * (1.0 / 6.0 - a2 * (1.0 / 120.0)));
    const double cosine = 1.0 - a2 * (0.5 - a2 * (1.0 / 24.0));
    const double mean_sine = a * (0.5 - a2 * (1.0 / 24.0));
    const double mean_cosine = 1.0 - a2 * (1.0 / 6.0 - a2 * (1.0 / 120.0));
    const double hx = block.heading_x[i], hy = block.heading_y[i];
    const double tx = hx * cosine + -hy * sine, ty = hy * cosine + hx * sine;
    const double ahead = dt * (v * mean_cosine - u * mean_sine);
    const double aside = dt * (v * mean_sine + u * mean_cosine);
    const double norm = 1.5 - 0.5 * (tx * tx + ty * ty);
    pose.x[i] = block.x[i] + hx * ahead + -hy * aside;
    pose.y[i] = block.y[i] + hy * ahead + hx * aside;
    pose.heading_x[i] = tx * norm;
    pose.heading_y[i] = ty * norm;
  }
}

// Computes the result of Pose::to_world() for a sensor.
ROBOSIM_LANES_FUNCTION void find_places(const SensorPoses& pose, const SensorBlock& sensor, Lanes& x,
                                        Lanes& y) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    x[i] = pose.x[i] + pose.heading_x[i] * sensor.at_x[i] + -pose.heading_y[i] * sensor.at_y[i];
    y[i] = pose.y[i] + pose.heading_y[i] * sensor.at_x[i] + pose.heading_x[i] * sensor.at_y[i];
  }
}

// Computes the results of AnalogSensor::output().
ROBOSIM_LANES_FUNCTION void find_volts(const SensorBlock& sensor, const Lanes& dark, const Lanes& brightness,
                                       const Lanes& gauss, Lanes& volts) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    const double blackness = robot::blackness({.light = sensor.light[i],
                                               .white = 1.0 - dark[i],
                                               .brightness = brightness[i],
                                               .shift = sensor.shift[i],
                                               .noise = sensor.noise[i],
                                               .dark_noise = sensor.dark_noise[i],
                                               .gauss = gauss[i]});
    const double v = (sensor.white[i] + sensor.span[i] * blackness) * sensor.share[i];
    const double least = v < 0.0 ? 0.0 : v;
    volts[i] = v > sensor.supply[i] ? sensor.supply[i] : least;
  }
}

// Adds the ADC's noise.
void add_noise(const SensorBlock& sensor, Lanes& volts) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    if (!(sensor.adc_noise[i] > 0.0)) continue;
    volts[i] += sensor.adc_noise[i] * sensor.adc[i].gauss(sensor.samples * kMaxPins + sensor.pin[i]);
    volts[i] = std::clamp(volts[i], 0.0, sensor.supply[i]);
  }
}

[[noreturn]] void refuse(const robot::Description& robot, const std::string& what) {
  throw InputError({robot.file.string()}, what + " is not supported in a batch of robots");
}

}  // namespace

Robots::Robots(const world::World& world) : floor_(world.floor()), bodies_(world) {
  if (world.lighting().is_lit()) throw std::invalid_argument("a batch of robots needs a floor without lamps");
}

std::size_t Robots::add(const robot::Description& robot, std::uint64_t seed, Profile profile,
                        const Pose& start, std::uint32_t individual) {
  if (robot.battery.kind) refuse(robot, "[battery]");
  if (robot.chassis.steering.exists()) refuse(robot, "a robot with steered wheels");
  add_sensors(robot, seed, profile, individual);
  for (auto& side : commands_) side.emplace_back();
  return bodies_.add(robot::body_params(robot, seed, profile, individual), start);
}

void Robots::add_sensors(const robot::Description& robot, std::uint64_t seed, Profile profile,
                         std::uint32_t number) {
  struct Found {
    const robot::ReflectanceSpec* part;
    const robot::ReflectanceSpec::Element* element;
  };
  std::vector<Found> found;
  for (const auto& part : robot.parts) {
    if (part->type == "fan") refuse(robot, part->name + ", a fan,");
    const auto* spec = dynamic_cast<const robot::ReflectanceSpec*>(part.get());
    if (!spec) continue;
    if (spec->read != robot::ReflectanceSpec::Read::analog)
      refuse(robot, part->name + ", a sensor whose \"read\" is not \"analog\",");
    if (spec->emitter != kNoPin) refuse(robot, part->name + ", a sensor whose emitter is on a pin,");
    for (const auto& element : spec->elements) found.push_back({spec, &element});
  }
  const std::size_t robots = size(), lane = robots % kLanes;
  if (robots == 0) {
    sensors_ = found.size();
    sensor_blocks_.resize(sensors_);
    lags_.resize(sensors_);
  }
  if (found.size() != sensors_)
    throw InputError({robot.file.string()},
                     fmt::format("has {} reflectance sensors, and the first robot of its batch has {}",
                                 found.size(), sensors_));
  const robot::ParameterSampler sampler(seed, profile, number);
  const BoardSpec& board = *robot.board;
  const robot::Electronics& electronics = robot.electronics;
  const double steps =
      sampler.ideal() ? 0.0 : sampler.draw(electronics.adc_noise, "electronics", "adc_noise");
  const double battery = sampler.draw(robot.motors.supply, "motors", "supply");
  const robot::Supply supply =
      electronics.fed_by_battery ? robot::supply_at(battery, board) : robot::Supply{board.supply_volts};
  for (std::size_t i = 0; i < sensors_; ++i) {
    if (lane == 0) sensor_blocks_[i].emplace_back();
    SensorBlock& block = sensor_blocks_[i].back();
    const auto& [part, element] = found[i];
    const robot::ElementFigures figures(*part, *element, sampler);
    const double lag = robot::lag_of(*part, sampler) * 1e9;
    lags_[i] = lags_[i] || lag != 0.0;
    block.at_x[lane] = element->at.x;
    block.at_y[lane] = element->at.y;
    block.probe[lane] = figures.footprint;
    block.light[lane] = figures.light * supply.led;
    block.shift[lane] = figures.shift;
    block.noise[lane] = figures.noise;
    block.dark_noise[lane] = figures.dark_noise;
    block.white[lane] = sampler.draw(element->white, element->name, "white_volts");
    block.span[lane] = sampler.draw(element->black, element->name, "black_volts") - block.white[lane];
    block.supply[lane] = supply.volts;
    block.share[lane] = supply.volts / board.supply_volts;
    block.adc_noise[lane] = steps * board.supply_volts / board.adc_steps * block.share[lane];
    block.is_converted_noisily = block.is_converted_noisily || steps > 0.0;
    block.lag[lane] = static_cast<double>(static_cast<SimTime>(lag));
    block.stream[lane] = figures.stream;
    block.adc[lane] = sampler.noise("electronics", "adc");
    block.pin[lane] = element->pin;
  }
  if (lane == 0) poses_.emplace_back();
}

void Robots::tell(std::size_t robot, world::Side side, const world::WheelCommand& command) {
  world::WheelCommand& last = commands_[side][robot];
  if (command == last) return;
  last = command;
  bodies_.command(robot, side, robot::over_a_tick(command));
  told_.push_back({robot, side, command});
}

void Robots::find_poses(std::size_t sensor, SimTime t) {
  if (t == posed_at_ && !lags_[sensor]) return;
  posed_at_ = lags_[sensor] ? -1 : t;
  const std::vector<BodyBlock>& blocks = bodies_.blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    Lanes dt;
    for (std::size_t i = 0; i < kLanes; ++i)
      dt[i] = (static_cast<double>(t - now_) - sensor_blocks_[sensor][b].lag[i]) * 1e-9;
    extrapolate(blocks[b], dt, poses_[b]);
  }
}

void Robots::read(std::size_t number, SimTime t, std::span<double> volts) {
  find_poses(number, t);
  for (std::size_t b = 0; b < poses_.size(); ++b) {
    SensorBlock& sensor = sensor_blocks_[number][b];
    const std::size_t first = b * kLanes, count = std::min(kLanes, size() - first);
    Lanes x, y, dark, gauss, out;
    Lanes brightness = Lanes::all(1.0);
    find_places(poses_[b], sensor, x, y);
    for (std::size_t i = 0; i < kLanes; ++i) gauss[i] = sensor.stream[i].gauss(sensor.samples);
    for (std::size_t i = 0; i < count; ++i) dark[i] = floor_.darkness({x[i], y[i]}, sensor.probe[i]);
    if (floor_.varies())
      for (std::size_t i = 0; i < count; ++i) brightness[i] = floor_.brightness({x[i], y[i]});
    find_volts(sensor, dark, brightness, gauss, out);
    if (sensor.is_converted_noisily) add_noise(sensor, out);
    std::copy_n(out.of, count, volts.begin() + static_cast<std::ptrdiff_t>(first));
    ++sensor.samples;
  }
}

void Robots::step() {
  bodies_.step();
  now_ += kTick;
  posed_at_ = -1;
  for (const Told& told : told_) bodies_.command(told.robot, told.side, told.command);
  told_.clear();
}

}  // namespace robosim::batch
