#include "sim/robot/parts/mpu6050.h"

#include <algorithm>
#include <cmath>

#include "sim/base/trig_series.h"
#include "sim/base/units.h"

namespace robosim::robot {
namespace {

constexpr int kUsualMpuAddress = 0x68;
constexpr std::uint8_t kDivider = 0x19, kConfig = 0x1A, kGyroConfig = 0x1B, kAccelConfig = 0x1C,
                       kIntStatus = 0x3A, kAccel = 0x3B, kTemperature = 0x41, kGyro = 0x43, kPower = 0x6B,
                       kFifoCount = 0x72, kWhoAmI = 0x75;
constexpr std::uint8_t kReset = 0x80, kSleep = 0x40, kDataReady = 0x01;
constexpr std::uint8_t kIdentity = 0x68;
constexpr double kGyroScale = 131.0;     // LSB per deg/s
constexpr double kAccelScale = 16384.0;  // LSB per g
constexpr double kAccelNoise = 0.0039;   // g
constexpr double kCodeAt25 = (25.0 - 36.53) * 340.0;
constexpr Parameter kBias{0.0, 20.0 * kDegree}, kGyroNoise{0.05 * kDegree, 0.0};
constexpr Parameter kScale{1.0, 0.0, Spread{1.0, 0.03}}, kAccelBias{0.0, 0.0, Spread{0.0, 0.05}};

// Returns the LSB per unit that bits 3 and 4 of the configuration select.
double scale(double finest, std::uint8_t config) { return finest / (1 << (config >> 3 & 3)); }

}  // namespace

std::shared_ptr<const PartSpec> read_mpu6050(PartReader& reader) {
  auto spec = std::make_shared<Mpu6050Spec>();
  spec->address = read_two_wire(reader, kUsualMpuAddress);
  spec->facing = reader.angle("facing");
  spec->bias = reader.figure("bias", Dimension::rotation_rate, kBias, -1.0, 1.0);
  spec->scale = reader.figure("scale", Dimension::ratio, kScale, 0.9, 1.1);
  spec->accel_bias = reader.figure("accel_bias", Dimension::ratio, kAccelBias, -0.2, 0.2);
  spec->gyro_noise = reader.figure("noise", Dimension::rotation_rate, kGyroNoise, 0.0, 1.0);
  return reader.finish(spec);
}

std::unique_ptr<Part> Mpu6050Spec::make(PartContext& context) const {
  return std::make_unique<Mpu6050Part>(*this, context);
}

Mpu6050Part::Mpu6050Part(const Mpu6050Spec& spec, PartContext& context)
    : RegisterDevice(spec.address, state_.cursor),
      spec_(spec),
      context_(context),
      stream_(context.sampler.noise(spec.name, "sample")),
      axis_(direction_of(spec.facing)),
      bias_{context.sampler.draw(spec.bias, spec.name, "bias x"),
            context.sampler.draw(spec.bias, spec.name, "bias y"),
            context.sampler.draw(spec.bias, spec.name, "bias")},
      accel_bias_{context.sampler.draw(spec.accel_bias, spec.name, "accel_bias x"),
                  context.sampler.draw(spec.accel_bias, spec.name, "accel_bias y"),
                  context.sampler.draw(spec.accel_bias, spec.name, "accel_bias z")},
      scale_(context.sampler.draw(spec.scale, spec.name, "scale")),
      gyro_noise_(context.sampler.ideal() ? 0.0 : context.sampler.draw(spec.gyro_noise, spec.name, "noise")) {
  reset();
  context.snapshots.add(state_);
}

void Mpu6050Part::reset() {
  state_.registers.fill(0);
  at(kPower) = kSleep;
  at(kWhoAmI) = kIdentity;
}

bool Mpu6050Part::asleep() const { return state_.registers[kPower] & kSleep; }

void Mpu6050Part::register_with(PartRegistry& registry) {
  context_.board.connect(*this);
  registry.ticking.push_back(this);
}

void Mpu6050Part::begin_tick(SimTime) {
  const double speed = context_.view.body->speed();
  state_.acceleration = (speed - state_.speed) / (1e-9 * kTick);
  state_.speed = speed;
}

void Mpu6050Part::put(std::uint8_t number, double value) {
  const auto code = static_cast<int>(std::lround(std::clamp(value, -32768.0, 32767.0)));
  at(number) = static_cast<std::uint8_t>(code >> 8);
  at(static_cast<std::uint8_t>(number + 1)) = static_cast<std::uint8_t>(code);
}

// Stores the newest sample, unless an earlier transfer has stored it already.
void Mpu6050Part::hold(SimTime t) {
  if (asleep()) return;
  const bool filters = (at(kConfig) & 7) != 0 && (at(kConfig) & 7) != 7;
  const SimTime period = (filters ? 1000 : 125) * kMicrosecond * (1 + at(kDivider));
  const SimTime sampled_at = t / period * period;
  if (sampled_at == state_.sampled_at) return;
  state_.sampled_at = sampled_at;
  const world::Body& body = *context_.view.body;
  const bool noisy = !context_.sampler.ideal();
  const auto noise = [&] { return noisy ? stream_.gauss(state_.samples++) : 0.0; };
  const world::Lean& lean = body.lean();
  const auto own = [this](Vec2 v) { return Vec2{dot(v, axis_), dot(v, left_of(axis_))}; };
  const Vec2 pull = own(
      {state_.acceleration / kGravity - lean.low.x, body.speed() * body.turn_rate() / kGravity - lean.low.y});
  const Vec2 tip = own(left_of(lean.rate));  // tilting ahead is a rotation about the axis to the left
  const double g[3] = {pull.x, pull.y, lean.level};
  const double turn[3] = {tip.x, tip.y, body.turn_rate()};
  const double of_gyro = scale(kGyroScale, at(kGyroConfig)) / kDegree;
  const double of_accel = scale(kAccelScale, at(kAccelConfig));
  for (std::uint8_t i = 0; i < 3; ++i) {
    put(static_cast<std::uint8_t>(kAccel + 2 * i),
        of_accel * (g[i] + accel_bias_[i] + kAccelNoise * noise()));
    put(static_cast<std::uint8_t>(kGyro + 2 * i),
        of_gyro * (scale_ * turn[i] + bias_[i] + gyro_noise_ * noise()));
  }
  put(kTemperature, kCodeAt25);
  at(kIntStatus) |= kDataReady;
}

void Mpu6050Part::set(std::uint8_t number, std::uint8_t value, SimTime) {
  const bool is_read_only = (number >= kIntStatus && number < kGyro + 6) || number == kFifoCount ||
                            number == kFifoCount + 1 || number == kWhoAmI;
  if (number >= state_.registers.size() || is_read_only) return;
  at(number) = value;
  if (number == kPower && value & kReset) reset();
}

std::uint8_t Mpu6050Part::get(std::uint8_t number, SimTime) {
  if (number >= state_.registers.size()) return 0;
  const std::uint8_t value = at(number);
  if (number == kIntStatus) at(number) = 0;
  return value;
}

void Mpu6050Part::read(std::vector<Reading>& readings) const {
  readings.push_back({spec_.name, (scale_ * context_.view.body->turn_rate() + bias_[2]) / kDegree});
}

}  // namespace robosim::robot
