// type = "reflectance" and "reflectance-array": infra-red sensors that look at the floor.
//
// For an element at `at` with footprint f, c is the darkness of the floor in the footprint: 0 for white, 1
// for black (world::Floor::darkness). The element's phototransistor reports the blackness
//   b = 1 - e s v (1 - c) - ambient - x L + noise n g
//
//   e         brightness of the emitter (1, or as its pin is driven)
//   s         the share of light that remains at this height
//   v         brightness of the floor at this place (world::Floor::brightness)
//   ambient   stray light
//   x L       ambient light L, times the exposure x at this height (world/lighting.h)
//   n         factor of the noise: 1 over white, less over black
//   g         standard normal, a new sample for every read
//
// From the profile typical@2 on:
//   s = the curve of a TCRT5000 (Vishay 83760 rev. 1.7, fig. 9), 1 at 2.5 mm    n = 0.4 + 0.6 (1 - c)
// In earlier profiles, and in `ideal`:
//   s = min(1, (3 mm / height)^2)                                               n = 1
// On hills, the height is the sensor's height above the ground below it. This height determines s and x. If
// the robot file sets no footprint, the height also determines f.
//
// A phototransistor is slow. `rise` is the time from 10 to 90 % of a step of light. The lag is
//   tau = rise / ln 9
// The reading follows the floor with a delay of tau. This is exact for light that changes linearly. After the
// emitter is switched, the reading approaches its new value exponentially.
//
// The output depends on `read`:
//   analog   volts = white_volts + (black_volts - white_volts) b, within 0 .. supply
//   digital  a comparator of b with `threshold`, with `hysteresis` (full width) around it. Its state
//            persists between reads. black = "high" or "low" is its output over black
//   rc       a capacitor: see reflectance_rc.h
// A reading is computed only when firmware reads the sensor or listens for the sensor's edges.
#pragma once

#include "sim/base/noise.h"
#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_reflectance(PartReader&);
std::shared_ptr<const PartSpec> read_reflectance_array(PartReader&);

/// The quantities in the formula for the blackness (see above).
struct BlacknessTerms {
  double light;             ///< e s: the emitter's brightness, times the share of light at this height, 0..1
  double white;             ///< 1 - c: the share of the footprint that reflects light
  double brightness = 1.0;  ///< v, relative to the floor's mean
  double shift = 0.0;       ///< -ambient
  double room_light = 0.0;  ///< x L
  double noise = 0.0;       ///< standard deviation of the blackness over white
  double dark_noise = 1.0;  ///< share of the noise that remains over black, 0..1
  double gauss = 0.0;       ///< g
};

/// Returns the blackness: 0 for white, 1 for black. Noise and stray light can push it beyond these values.
inline double blackness(const BlacknessTerms& q) {
  const double n = q.dark_noise + (1.0 - q.dark_noise) * q.white;
  return 1.0 - q.light * q.white * q.brightness + q.shift - q.room_light + q.noise * n * q.gauss;
}

/// Returns the light that a sensor at `height` (m) receives from a white floor, as a fraction of the maximum.
/// From typical@2 on, the curve is that of a TCRT5000.
double light_from(double height, Profile profile);

class ReflectanceSpec final : public PartSpec {
 public:
  enum class Read { analog, digital, rc };
  struct Element {
    std::string name;
    Vec2 at;  ///< m
    Pin pin;
    Parameter white, black;  ///< output over white and over black: volts (analog), s (rc)
  };

  Read read = Read::analog;
  bool black_high = true;
  Parameter threshold;    ///< digital: blackness at which the output changes
  Parameter hysteresis;   ///< digital: full width, as blackness
  Parameter noise;        ///< standard deviation of blackness
  Parameter ambient;      ///< subtracted from the blackness
  Parameter height;       ///< m
  Parameter footprint;    ///< m; 0 = depends on the height (reflectance.cpp, docs/explanation/models.md)
  Parameter source_ohms;  ///< analog
  Parameter rise;         ///< s, from 10 to 90 % of a step of light
  Pin emitter = kNoPin;
  std::vector<Element> elements;

  std::unique_ptr<Part> make(PartContext&) const override;
  std::vector<SensorPlace> sensors() const override;
};

/// The sampled parameters of one element of one robot.
struct ElementFigures {
  ElementFigures(const ReflectanceSpec&, const ReflectanceSpec::Element&, const ParameterSampler&);

  double height, footprint;  ///< m
  double light;              ///< share of light that white returns
  double shift;              ///< added to the blackness
  double noise;              ///< standard deviation of blackness
  double dark_noise;         ///< share of the noise that remains over black
  NoiseStream stream;        ///< noise of the readings
};

/// Returns tau, the lag of a part's phototransistors, s.
double lag_of(const ReflectanceSpec&, const ParameterSampler&);

/// The emitter LEDs of a part. While no output drives their pin, the LEDs have full brightness: the gate of
/// their transistor is pulled up on the sensor board.
class Emitter final : public PinWatcher {
 public:
  /// `lag_s` is tau of the phototransistors, s.
  Emitter(SnapshotRegistry& snapshots, double lag_s) : lag_(lag_s * 1e9) { snapshots.add(state_); }
  void pin_changed(Pin, const PinDrive&, SimTime) override;
  /// Returns the brightness at `t` as the phototransistors measure it.
  double brightness(SimTime t) const {
    return lag_ == 0.0 || state_.from == state_.brightness ? state_.brightness : lagging(t);
  }
  /// Returns the brightness that the measured brightness approaches.
  double brightness() const { return state_.brightness; }
  /// Returns tau, ns.
  double lag() const { return lag_; }

 private:
  double lagging(SimTime t) const;

  const double lag_;  // ns
  struct State {
    double brightness = 1.0;
    double from = 1.0;  // the measured brightness at `since`
    SimTime since = 0;
  };
  State state_;
};

/// One element, without its output stage.
class Sensor : public Breakable {
 public:
  Sensor(const ReflectanceSpec&, const ReflectanceSpec::Element&, const PartContext&, const Emitter&);
  virtual ~Sensor() = default;

  const std::string& name() const override { return name_; }
  /// Returns the name of the sensor's part.
  const std::string& part() const { return part_; }
  Vec2 at() const { return state_.at; }
  void cover(bool covered) { state_.covered = covered; }
  /// Returns the share of the footprint that is on the line at the start of the tick.
  double coverage() const {
    const world::Body& body = *context_.view.body;
    return body.lifted() ? 0.0 : context_.view.floor->on_line(body.pose().to_world(state_.at), state_.probe);
  }
  /// Returns the value for display: 0 white .. 1 black.
  double shown() const;
  virtual void connect(PartContext&, Pin) = 0;
  virtual void begin_tick(SimTime) {}

  std::span<const FaultKind> fault_kinds() const override;
  void fail(const Fault&) override;

 protected:
  /// Returns the blackness. Consumes a sample of noise.
  double blackness(SimTime t);
  bool stuck() const { return state_.stuck >= 0.0; }
  /// Returns the argument of `fault NAME stuck`.
  double stuck_at() const { return state_.stuck; }
  /// Returns the blackness at which the sensor would output stuck_at(), for display.
  virtual double stuck_blackness() const = 0;

  const PartContext& context_;

 private:
  Sensor(const ReflectanceSpec&, const ReflectanceSpec::Element&, const ElementFigures&, const PartContext&,
         const Emitter&);
  /// Returns whether no light returns: a finger covers the sensor, or the robot is held up in the air.
  bool dark() const { return state_.covered || context_.view.body->lifted(); }
  /// Returns the terms of the blackness without noise. `emitted` is the emitter's brightness.
  BlacknessTerms terms(const Pose&, double emitted, SimTime) const;
  /// The effects of the sensor's height: the mounting height or, on hills, the local height.
  struct Optics {
    double light, footprint, exposure;
  };
  Optics optics(const Pose& pose) const {
    return hilly_ ? optics_on_hills(pose) : Optics{state_.now.light, footprint_, exposure_};
  }
  Optics optics_on_hills(const Pose&) const;
  void swap_with(Sensor*);

  struct Figures {
    double light, shift, noise, dark_noise;  // as in ElementFigures
  };
  struct State {
    Vec2 at;                  // place whose reading is on the sensor's wire
    Sensor* other = nullptr;  // the sensor with which the wire is swapped
    Figures now;
    double stuck = -1.0;
    std::uint64_t samples = 0;
    bool covered = false;
    world::FloorProbe probe;
  };

  const std::string& name_;
  const std::string& part_;
  const Emitter& emitter_;
  const Vec2 home_;  // mounting place
  const double height_, footprint_, exposure_;
  const SimTime lag_;
  const bool hilly_, widens_;  // whether the floor has hills, and whether the footprint depends on the height
  const Figures healthy_;
  const NoiseStream stream_;
  State state_;
};

/// A sensor with `read = "analog"`.
class AnalogSensor final : public Sensor, public PinSource {
 public:
  AnalogSensor(const ReflectanceSpec&, const ReflectanceSpec::Element&, const PartContext&, const Emitter&);
  void connect(PartContext&, Pin) override;
  Source output(SimTime t, double supply) override {
    if (stuck()) return {(stuck_at() + 0.5) * step_volts_ * (supply / supply_), source_ohms_};
    const double v = (white_ + span_ * blackness(t)) * (supply / supply_);
    return {v < 0.0 ? 0.0 : v > supply ? supply : v, source_ohms_};
  }
  bool level(SimTime t) override { return output(t, supply_).volts > 0.5 * supply_; }

 private:
  double stuck_blackness() const override { return ((stuck_at() + 0.5) * step_volts_ - white_) / span_; }

  const double white_, span_;
  const double supply_;  // nominal, V
  const double step_volts_, source_ohms_;
};

/// A sensor with `read = "digital"`.
class DigitalSensor final : public Sensor, public PinSource {
 public:
  DigitalSensor(const ReflectanceSpec&, const ReflectanceSpec::Element&, const PartContext&, const Emitter&);
  void connect(PartContext&, Pin) override;
  void begin_tick(SimTime) override;
  bool level(SimTime t) override {
    if (stuck()) return stuck_at() > 0.0;
    state_.dark = blackness(t) > (state_.dark ? falls_ : rises_);
    return state_.dark == black_high_;
  }

 private:
  double stuck_blackness() const override { return (stuck_at() > 0.0) == black_high_ ? 1.0 : 0.0; }

  struct State {
    bool dark = false;
  };

  const double threshold_, hysteresis_, rises_, falls_;
  const bool black_high_;
  RobotPort* board_ = nullptr;
  Pin pin_ = kNoPin;
  State state_;
};

}  // namespace robosim::robot
