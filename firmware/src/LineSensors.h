// Reads reflectance sensors that detect a line on the floor.
//
// Each sensor is an infrared lamp and a phototransistor. A dark line reflects little. There are three kinds,
// which differ in how the chip reads them:
//
//   AnalogLineSensors    a voltage, by analogRead. Shades of grey locate the line even between two
//                        sensors.
//   RcLineSensors        a time: the pin charges a small capacitor, then the phototransistor drains it,
//                        quickly over white, slowly over black. Resolves shades of grey on any digital
//                        pin, more slowly (up to `timeout_us` per reading).
//   DigitalLineSensors   a comparator's output, by digitalRead. Robust; reports the line only as "here"
//                        or "not here".
//
// List the pins from the LEFT end of the robot to the RIGHT.
//
// Values. read() converts every raw reading to 0 (floor) .. 1000 (line), with each sensor's own range,
// because sensors, light and height above the floor differ:
//
//   value = 1000 * (raw - floor) / (line - floor),   limited to 0 .. 1000
//
// Set the range with setRange(). Alternatively, calibrate() finds it while you move the robot across the line
// for a second or two.
//
// Position. position() is the mean of the sensors' places, weighted by each sensor's value:
//
//   position = sum(value * place) / sum(value),   place of sensor i = 1000 * i - 500 * (count - 1)
//
// in thousandths of the distance between two sensors. 0 is the middle of the array, negative left, positive
// right. Five sensors return -2000 to 2000.
//
// If no sensor detects the line, position() is the end of the array nearest to the line's last position. A
// robot that has run off the line therefore turns back. If the last position was more than 1000 (one sensor)
// away from both ends, the robot cannot have run off: this is a gap in the line. position() is then 0, so the
// robot crosses the gap without swerving.
//
// The sums have 32 bits: with five sensors sum(value * place) reaches millions, and an int on an Uno is
// limited to 32,767.
//
// Example:
//
//   const uint8_t pins[] = {A0, A1, A2, A3, A4};
//   AnalogLineSensors sensors(pins);
//   void setup() { sensors.begin(); sensors.setRange(100, 800); }
//   void loop() { sensors.read(); Serial.println(sensors.position()); delay(50); }
#ifndef LINEKIT_LINE_SENSORS_H
#define LINEKIT_LINE_SENSORS_H

#include <Arduino.h>

class LineSensors {
 public:
  static const uint8_t kMaxSensors = 8;
  static const uint16_t kFullScale = 1000;
  /// Values below this limit do not contribute to the position, since the bare floor never reads exactly 0.
  static const uint16_t kFaint = 50;
  /// A sensor detects the line if its value is at least this.
  static const uint16_t kSeen = 200;
  /// A sensor is on the line, not next to it, if its value is at least this.
  static const uint16_t kOnLine = 500;

  /// Sets the pins' modes. Call it in setup().
  void begin();
  /// Sets the pin that switches the sensors' lamps (CTRL, LEDON). Call it before begin(), which switches the
  /// lamps on.
  void setEmitterPin(uint8_t pin) { emitter_ = pin; }

  /// Sets the readings of all sensors on the bare floor and on the line. `line` may be the smaller value: for
  /// a white line on a black floor, or for sensors that return less voltage over black.
  void setRange(uint16_t floor, uint16_t line);
  /// Sets the range of one sensor.
  void setRange(uint8_t sensor, uint16_t floor, uint16_t line);

  /// Discards the range, so that calibrate() starts again. Pass true as `line_reads_high` if the line gives
  /// larger readings than the floor.
  void startCalibration(bool line_reads_high = true);
  /// Reads once and widens each sensor's range to include its reading. Call it many times while all sensors
  /// cross the line.
  void calibrate();

  /// Reads all sensors.
  void read();

  uint8_t count() const { return count_; }
  uint16_t raw(uint8_t sensor) const { return raw_[sensor]; }
  uint16_t value(uint8_t sensor) const { return value_[sensor]; }  ///< 0 floor .. 1000 line
  bool onLine(uint8_t sensor) const { return value_[sensor] >= kOnLine; }
  bool seesLine() const { return seen_; }  ///< whether any sensor detects the line
  int16_t position() const { return position_; }

  /// Apply the formulas above to any values.
  static uint16_t scaled(uint16_t raw, uint16_t floor, uint16_t line);
  static int16_t weightedPosition(const uint16_t* values, uint8_t count, int16_t if_not_seen);

 protected:
  LineSensors(const uint8_t* pins, uint8_t count, uint16_t floor, uint16_t line);
  virtual void beginPin(uint8_t pin) = 0;
  /// Fills `raw` with one value for each of pins_.
  virtual void readRaw(uint16_t* raw) = 0;

  uint8_t pins_[kMaxSensors];
  uint8_t count_;

 private:
  uint8_t emitter_ = 255;
  bool line_reads_high_ = true;
  bool seen_ = false;
  int16_t position_ = 0;
  uint16_t floor_[kMaxSensors];
  uint16_t line_[kMaxSensors];
  uint16_t raw_[kMaxSensors];
  uint16_t value_[kMaxSensors];
};

/// Reads by analogRead: raw is 0..1023.
class AnalogLineSensors : public LineSensors {
 public:
  template <uint8_t N>
  explicit AnalogLineSensors(const uint8_t (&pins)[N]) : LineSensors(pins, N, 0, 1023) {
    static_assert(N <= kMaxSensors, "at most 8 sensors");
  }

 protected:
  void beginPin(uint8_t pin) override;
  void readRaw(uint16_t* raw) override;
};

/// Reads by digitalRead: raw is 0 or 1.
class DigitalLineSensors : public LineSensors {
 public:
  /// `on_line` is the level that means "line", HIGH or LOW. Both kinds of module are sold.
  template <uint8_t N>
  explicit DigitalLineSensors(const uint8_t (&pins)[N], uint8_t on_line = HIGH)
      : LineSensors(pins, N, on_line == HIGH ? 0 : 1, on_line == HIGH ? 1 : 0) {
    static_assert(N <= kMaxSensors, "at most 8 sensors");
  }

 protected:
  void beginPin(uint8_t pin) override;
  void readRaw(uint16_t* raw) override;
};

/// Reads by timing the discharge: raw is microseconds, at most `timeout_us`.
class RcLineSensors : public LineSensors {
 public:
  /// A discharge longer than `timeout_us` counts as black; 1000..3000 is useful, 2500 is usual.
  template <uint8_t N>
  explicit RcLineSensors(const uint8_t (&pins)[N], uint16_t timeout_us = 2500)
      : LineSensors(pins, N, 0, timeout_us), timeout_us_(timeout_us) {
    static_assert(N <= kMaxSensors, "at most 8 sensors");
  }

 protected:
  void beginPin(uint8_t pin) override;
  void readRaw(uint16_t* raw) override;

 private:
  uint16_t timeout_us_;
};

#endif
