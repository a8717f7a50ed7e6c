// type = "mpu-6050": gyroscope and accelerometer (InvenSense PS-MPU-6000A-00, register map RM-MPU-6000A-00).
// The sensor lies flat on the robot, with its x axis ahead, y to the left and z up.
//
//   gyro         z: the robot's turn rate; x, y: rate of its lean; each times scale, plus bias and noise
//                131 LSB/(deg/s) at +-250, halved with each step of FS_SEL
//   accel        x: dv/dt; y: v w; z: 1 g (during a lean, gravity acts on all axes); each + bias + noise
//                16384 LSB/g at +-2 g, halved with each step of AFS_SEL
//   temperature  always 25 degrees; the register holds (T - 36.53) 340
//   bias         +-20 deg/s at most (zero rate output, 6.1), one per axis and robot
//   scale        1 +- 3 % from profile typical@2 on (6.1), one for all axes; 1 in earlier profiles
//   accel_bias   +-50 mg from typical@2 on (6.2, which states 80 for z), one per axis; 0 in earlier profiles
//   noise        gyro: 0.05 deg/s RMS; accel: 400 ug / sqrt(Hz) in 94 Hz gives 3.9 mg (mg: 0.001 g)
//
// v is the robot's speed, w its turn rate, and dv/dt its acceleration in the last tick. The robot leans on
// hills and in a manual tilt. Numbers such as 6.1 are sections of the data sheet. The sampling rate is 8 kHz,
// or 1 kHz with a low-pass filter, divided by 1 + SMPLRT_DIV. Each transfer returns the newest sample. After
// power-on the sensor is asleep (PWR_MGMT_1 = 0x40) and measures nothing. Other registers store any value
// written.
//
// Not modelled: FIFO (its count stays 0), motion processor, interrupts on pin INT, the low-pass filter,
// vibration.
#pragma once

#include "sim/base/noise.h"
#include "sim/robot/parts/two_wire.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_mpu6050(PartReader&);

class Mpu6050Spec final : public PartSpec {
 public:
  std::uint8_t address = 0;
  double facing = 0.0;   ///< rad, direction of the x axis: 0 ahead, counter-clockwise
  Parameter bias;        ///< rad/s
  Parameter scale;       ///< gyroscope reading per rad/s
  Parameter accel_bias;  ///< g
  Parameter gyro_noise;  ///< rad/s, standard deviation of a sample

  std::unique_ptr<Part> make(PartContext&) const override;
  std::vector<Gauge> gauges() const override { return {{name, "deg/s"}}; }
};

class Mpu6050Part final : public Part, public RegisterDevice {
 public:
  Mpu6050Part(const Mpu6050Spec&, PartContext&);

  void register_with(PartRegistry&) override;
  void begin_tick(SimTime) override;
  /// Appends the measured turn rate, without noise.
  void read(std::vector<Reading>&) const override;
  using RegisterDevice::read;

 private:
  void set(std::uint8_t number, std::uint8_t value, SimTime) override;
  std::uint8_t get(std::uint8_t number, SimTime) override;
  void hold(SimTime t) override;
  void put(std::uint8_t number, double value);
  std::uint8_t& at(std::uint8_t number) { return state_.registers[number]; }
  void reset();
  bool asleep() const;

  struct State {
    std::array<std::uint8_t, 128> registers{};
    Cursor cursor;
    double speed = 0.0, acceleration = 0.0;  // m/s, m/s2, forward
    SimTime sampled_at = -1;
    std::uint64_t samples = 0;
  };

  const Mpu6050Spec& spec_;
  PartContext& context_;
  const NoiseStream stream_;
  const Vec2 axis_;
  const std::array<double, 3> bias_, accel_bias_;
  const double scale_, gyro_noise_;
  State state_;
};

}  // namespace robosim::robot
