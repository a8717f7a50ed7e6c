#include "sim/robot/parts/reflectance.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/function_multiversioning.h"
#include "sim/robot/parts/motor_driver.h"
#include "sim/robot/parts/reflectance_rc.h"

namespace robosim::robot {
namespace {

using Read = ReflectanceSpec::Read;

constexpr double kLowest = 0.0005, kHighest = 0.06;  // in metres: the limits of the height on hills
constexpr double kBestHeight = 0.003;                // in metres; Pololu, QTR-8A and QTR-8RC user's guide

// The share of light that white returns, by height (reflectance.h). The points beyond 15 mm continue the
// power law of 5 to 12 mm, whose exponent is -1.24.
struct Light {
  double height;  // m
  double share;
};
constexpr Light kLight[] = {{0.0005, 0.64}, {0.001, 0.83}, {0.002, 0.99}, {0.0025, 1.00}, {0.003, 0.98},
                            {0.004, 0.89},  {0.005, 0.78}, {0.006, 0.66}, {0.008, 0.48},  {0.010, 0.36},
                            {0.012, 0.27},  {0.015, 0.20}, {0.020, 0.14}, {0.030, 0.085}};

// The default footprint, relative to the height. All elements of a part share one value. Readings measured
// across a line's edge suggest ratios of 0.3 and 0.97 (docs/explanation/fidelity.md).
constexpr Parameter kSpot{2.0, 0.0, Spread{0.6, 0.36}};
constexpr Parameter kDarkNoise{1.0, 0.0, Spread{0.4, 0.0}};
constexpr double kLagOfRise = 0.4551196133134187;  // 1 / ln 9: tau relative to the time from 10 to 90 %
constexpr std::size_t kMostElements = 16;

constexpr FaultKind kReflectanceFaults[] = {
    {Failure::ok, "works again"},
    {Failure::stuck, "always reads this value: a code (analog), 0 or 1 (digital), microseconds (rc)",
     FaultKind::Argument::number, 0.0, 1e6},
    {Failure::dead, "its emitter is dark: it sees black everywhere"},
    {Failure::swapped, "the wires of both sensors are exchanged, until either sensor gets another fault",
     FaultKind::Argument::sensor},
    {Failure::noisy, "adds noise of this standard deviation, as a share of the range from white to black",
     FaultKind::Argument::number, 0.0, 1.0},
    {Failure::offset, "adds this share of the range from white to black", FaultKind::Argument::number, -1.0,
     1.0},
};

void read_common(PartReader& reader, ReflectanceSpec& spec) {
  const std::string read = reader.table().choice("read", "analog", {"analog", "digital", "rc"});
  spec.read = read == "analog" ? Read::analog : read == "digital" ? Read::digital : Read::rc;
  spec.noise = reader.figure("noise", Dimension::ratio, {0.005, 0.0, Spread{0.011, 0.004}}, 0.0, 0.5);
  spec.ambient = reader.figure("ambient", Dimension::ratio, {0.0, 0.0}, 0.0, 0.9);
  spec.height = reader.figure("height", Dimension::length, {kBestHeight, 0.0}, 0.0005, 0.03);
  spec.footprint = reader.figure("footprint", Dimension::length, {}, 0.0005, 0.03);
  spec.rise = reader.figure("rise", Dimension::time, {0.0, 0.0}, 0.0, 1e-3);
  spec.emitter = reader.optional_pin("emitter", PinUse::driven);
  if (spec.read == Read::rc) return;
  spec.black_high = reader.high("black", true);
  if (spec.read == Read::analog) {
    spec.source_ohms = reader.source_ohms();
    return;
  }
  spec.threshold = reader.figure("threshold", Dimension::ratio, {0.5, 0.0}, 0.02, 0.98);
  spec.hysteresis = reader.figure("hysteresis", Dimension::ratio, {0.1, 0.0}, 0.0, 0.9);
}

// Reads the levels of each element over white and over black, after the number of elements is known.
void read_levels(PartReader& reader, ReflectanceSpec& spec) {
  const std::size_t count = spec.elements.size();
  std::vector<Parameter> white(count), black(count);
  if (spec.read == Read::rc) {
    white = reader.figures("white_time", Dimension::time, {200e-6, 0.0}, 5e-6, 0.1, count);
    black = reader.figures("black_time", Dimension::time, {2500e-6, 0.0}, 5e-6, 0.1, count);
  } else if (spec.read == Read::analog) {
    const Parameter light{0.08, 0.0};  // share of the supply
    const Parameter dark{0.9, 0.0};
    white = reader.volts_of_each("white_volts", spec.black_high ? light : dark, count);
    black = reader.volts_of_each("black_volts", spec.black_high ? dark : light, count);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Parameter &w = white[i], &b = black[i];
    if (spec.read == Read::rc && w.value + w.spread >= b.value - b.spread)
      throw InputError(reader.table().table().place,
                       fmt::format("{}: expected white_time shorter than black_time, including their spreads",
                                   spec.elements[i].name));
    if (spec.read == Read::analog && (b.value > w.value) != spec.black_high)
      throw InputError(reader.table().table().place,
                       fmt::format("{}: black = \"{}\" contradicts white_volts and black_volts",
                                   spec.elements[i].name, spec.black_high ? "high" : "low"));
    spec.elements[i].white = w;
    spec.elements[i].black = b;
  }
}

PinUse use_of(const ReflectanceSpec& spec) {
  return spec.read == Read::analog ? PinUse::analog : PinUse::digital;
}

class ReflectancePart final : public Part {
 public:
  ReflectancePart(const ReflectanceSpec& spec, PartContext& context)
      : spec_(spec), context_(context), emitter_(context.snapshots, lag_of(spec, context.sampler)) {
    for (const ReflectanceSpec::Element& element : spec.elements) {
      switch (spec.read) {
        case Read::analog:
          add<AnalogSensor>(element);
          break;
        case Read::digital:
          add<DigitalSensor>(element);
          break;
        case Read::rc:
          add<RcSensor>(element);
          break;
      }
    }
  }

  void register_with(PartRegistry& registry) override {
    if (spec_.read == Read::rc) registry.ticking.push_back(this);
    if (spec_.read == Read::digital) registry.edge_makers.push_back(this);
    if (spec_.emitter != kNoPin) {
      context_.netlist.watch(spec_.emitter, emitter_);
      emitter_.pin_changed(spec_.emitter, context_.netlist.drive(spec_.emitter), 0);
    }
    for (std::size_t i = 0; i < sensors_.size(); ++i) {
      sensors_[i]->connect(context_, spec_.elements[i].pin);
      registry.sensors.push_back(sensors_[i].get());
      registry.breakable.push_back(sensors_[i].get());
    }
  }

  void begin_tick(SimTime t) override {
    for (const auto& sensor : sensors_) sensor->begin_tick(t);
  }

 private:
  template <typename Kind>
  void add(const ReflectanceSpec::Element& element) {
    sensors_.push_back(std::make_unique<Kind>(spec_, element, context_, emitter_));
  }

  const ReflectanceSpec& spec_;
  PartContext& context_;
  Emitter emitter_;
  std::vector<std::unique_ptr<Sensor>> sensors_;
};

double footprint_of(const ReflectanceSpec& spec, const ParameterSampler& sampler, const std::string& element,
                    double height) {
  if (spec.footprint.value == 0.0) return sampler.draw(kSpot, spec.name, "footprint") * height;
  const bool each = sampler.profile() < Profile::typical_2;
  return sampler.draw(spec.footprint, each ? element : spec.name, "footprint");
}

// Returns e^-x within 1e-4, for x >= 0.
double decay(double x) {
  const double part = x / 16.0;
  const double once = 1.0 / (1.0 + part * (1.0 + part / 2.0 * (1.0 + part / 3.0)));
  const double square = once * once, fourth = square * square, eighth = fourth * fourth;
  return eighth * eighth;
}

double clamp01(double x) { return std::clamp(x, 0.0, 1.0); }

}  // namespace

double light_from(double height, Profile profile) {
  if (profile < Profile::typical_2) {
    const double far = kBestHeight / height;
    return far < 1.0 ? far * far : 1.0;
  }
  const Light* above = std::lower_bound(std::begin(kLight) + 1, std::end(kLight) - 1, height,
                                        [](const Light& light, double h) { return light.height < h; });
  const Light& below = above[-1];
  const double share = (height - below.height) / (above->height - below.height);
  return std::max(below.share + share * (above->share - below.share), 0.0);
}

std::shared_ptr<const PartSpec> read_reflectance(PartReader& reader) {
  auto spec = std::make_shared<ReflectanceSpec>();
  read_common(reader, *spec);
  reader.table().require("at");
  const Vec2 at = reader.point("at", {});
  spec->elements.push_back({reader.name(), at, reader.pin("pin", use_of(*spec)), {}, {}});
  read_levels(reader, *spec);
  return reader.finish(spec);
}

std::shared_ptr<const PartSpec> read_reflectance_array(PartReader& reader) {
  auto spec = std::make_shared<ReflectanceSpec>();
  read_common(reader, *spec);
  reader.table().require("at");
  const Vec2 at = reader.point("at", {});
  const double pitch = as_quantity(reader.table().require("pitch"), "pitch", Dimension::length, 0.002, 0.1);
  const bool from_left = reader.table().choice("first", "left", {"left", "right"}) == "left";
  const std::vector<Pin> pins = reader.pin_list(use_of(*spec), kMostElements);
  for (std::size_t i = 0; i < pins.size(); ++i) {
    const double places = 0.5 * static_cast<double>(pins.size() - 1) - static_cast<double>(i);
    const double y = places * pitch;
    spec->elements.push_back(
        {reader.name() + std::to_string(i + 1), at + Vec2{0.0, from_left ? y : -y}, pins[i], {}, {}});
  }
  read_levels(reader, *spec);
  return reader.finish(spec);
}

std::unique_ptr<Part> ReflectanceSpec::make(PartContext& context) const {
  return std::make_unique<ReflectancePart>(*this, context);
}

std::vector<SensorPlace> ReflectanceSpec::sensors() const {
  std::vector<SensorPlace> places;
  const double given = footprint.in(Profile::typical).value;
  const double seen = given > 0.0 ? given : kSpot.in(Profile::typical).value * height.value;
  for (const Element& element : elements) places.push_back({element.name, element.at, seen});
  return places;
}

void Emitter::pin_changed(Pin, const PinDrive& drive, SimTime t) {
  state_.from = brightness(t);
  state_.brightness = drive.mode == PinMode::output ? high_share(drive) : 1.0;
  state_.since = t;
}

double Emitter::lagging(SimTime t) const {
  const double x = static_cast<double>(t - state_.since) / lag_;
  return state_.brightness + (state_.from - state_.brightness) * decay(x);
}

double lag_of(const ReflectanceSpec& spec, const ParameterSampler& sampler) {
  return kLagOfRise * sampler.draw(spec.rise, spec.name, "rise");
}

ElementFigures::ElementFigures(const ReflectanceSpec& spec, const ReflectanceSpec::Element& element,
                               const ParameterSampler& sampler)
    : height(sampler.draw(spec.height, element.name, "height")),
      footprint(footprint_of(spec, sampler, element.name, height)),
      light(light_from(height, sampler.profile())),
      shift(-sampler.draw(spec.ambient, element.name, "ambient")),
      noise(sampler.ideal() ? 0.0 : sampler.draw(spec.noise, element.name, "noise")),
      dark_noise(sampler.draw(kDarkNoise, element.name, "dark_noise")),
      stream(sampler.noise(element.name, "reading")) {}

Sensor::Sensor(const ReflectanceSpec& spec, const ReflectanceSpec::Element& element,
               const PartContext& context, const Emitter& emitter)
    : Sensor(spec, element, ElementFigures(spec, element, context.sampler), context, emitter) {}

Sensor::Sensor(const ReflectanceSpec& spec, const ReflectanceSpec::Element& element,
               const ElementFigures& figures, const PartContext& context, const Emitter& emitter)
    : context_(context),
      name_(element.name),
      part_(spec.name),
      emitter_(emitter),
      home_(element.at),
      height_(figures.height),
      footprint_(figures.footprint),
      exposure_(world::exposure(height_)),
      lag_(static_cast<SimTime>(emitter.lag())),
      hilly_(context.view.world && context.view.world->ground()),
      widens_(spec.footprint.value == 0.0),
      healthy_{figures.light, figures.shift, figures.noise, figures.dark_noise},
      stream_(figures.stream),
      state_{.at = home_, .now = healthy_, .probe = footprint_} {
  context.snapshots.add(state_);
}

inline BlacknessTerms Sensor::terms(const Pose& pose, double emitted, SimTime t) const {
  const world::Floor& floor = *context_.view.floor;
  const world::Lighting& lighting = context_.view.world->lighting();
  const Optics optics = this->optics(pose);
  const Vec2 at = pose.to_world(state_.at);
  const double darkness = dark() ? 1.0
                          : optics.footprint == state_.probe.footprint()
                              ? floor.darkness(at, state_.probe)
                              : floor.darkness(at, optics.footprint);
  return {.light = optics.light * context_.view.supply.led * emitted,
          .white = 1.0 - darkness,
          .brightness = floor.brightness(at),
          .shift = state_.now.shift,
          .room_light = lighting.is_lit() && !state_.covered ? optics.exposure * lighting.at(at, t) : 0.0};
}

ROBOSIM_ALSO_FOR("avx") double Sensor::blackness(SimTime t) {
  BlacknessTerms terms = this->terms(context_.view.pose_at(t - lag_), emitter_.brightness(t), t);
  if (state_.now.noise > 0.0) {
    terms.noise = state_.now.noise;
    terms.dark_noise = state_.now.dark_noise;
    terms.gauss = stream_.gauss(state_.samples++);
  }
  return robot::blackness(terms);
}

double Sensor::shown() const {
  return clamp01(stuck() ? stuck_blackness()
                         : robot::blackness(terms(context_.view.body->pose(), emitter_.brightness(),
                                                  context_.view.tick_start)));
}

Sensor::Optics Sensor::optics_on_hills(const Pose& pose) const {
  const double higher =
      context_.view.body->raised(state_.at) - context_.view.world->ground()->height(pose.to_world(state_.at));
  if (higher == 0.0) return {state_.now.light, footprint_, exposure_};
  const double height = std::clamp(height_ + higher, kLowest, kHighest);
  const Profile profile = context_.sampler.profile();
  return {state_.now.light * light_from(height, profile) / light_from(height_, profile),
          widens_ ? footprint_ * height / height_ : footprint_, world::exposure(height)};
}

std::span<const FaultKind> Sensor::fault_kinds() const { return kReflectanceFaults; }

// Swaps the wires of this sensor and `other`. First undoes earlier swaps of these sensors. If `other` is
// null, only undoes an earlier swap.
void Sensor::swap_with(Sensor* other) {
  for (Sensor* sensor : {this, other}) {
    if (!sensor || !sensor->state_.other) continue;
    Sensor& partner = *sensor->state_.other;
    partner.state_.at = partner.home_;
    partner.state_.other = nullptr;
    sensor->state_.at = sensor->home_;
    sensor->state_.other = nullptr;
  }
  if (!other) return;
  state_.at = other->home_;
  other->state_.at = home_;
  state_.other = other;
  other->state_.other = this;
}

void Sensor::fail(const Fault& fault) {
  swap_with(fault.failure == Failure::swapped ? fault.sensor : nullptr);
  state_.stuck = fault.failure == Failure::stuck ? fault.number : -1.0;
  state_.now.noise = healthy_.noise + (fault.failure == Failure::noisy ? fault.number : 0.0);
  state_.now.dark_noise = fault.failure == Failure::noisy ? 1.0 : healthy_.dark_noise;
  state_.now.shift = healthy_.shift + (fault.failure == Failure::offset ? fault.number : 0.0);
  state_.now.light = fault.failure == Failure::dead ? 0.0 : healthy_.light;
}

AnalogSensor::AnalogSensor(const ReflectanceSpec& spec, const ReflectanceSpec::Element& element,
                           const PartContext& context, const Emitter& emitter)
    : Sensor(spec, element, context, emitter),
      white_(context.sampler.draw(element.white, name(), "white_volts")),
      span_(context.sampler.draw(element.black, name(), "black_volts") - white_),
      supply_(context.description.board->supply_volts),
      step_volts_(supply_ / context.description.board->adc_steps),
      source_ohms_(context.sampler.draw(spec.source_ohms, name(), "source_ohms")) {}

void AnalogSensor::connect(PartContext& context, Pin pin) { context.connect_analog(pin, *this); }

DigitalSensor::DigitalSensor(const ReflectanceSpec& spec, const ReflectanceSpec::Element& element,
                             const PartContext& context, const Emitter& emitter)
    : Sensor(spec, element, context, emitter),
      threshold_(context.sampler.draw(spec.threshold, name(), "threshold")),
      hysteresis_(context.sampler.draw(spec.hysteresis, name(), "hysteresis")),
      rises_(threshold_ + 0.5 * hysteresis_),
      falls_(threshold_ - 0.5 * hysteresis_),
      black_high_(spec.black_high) {
  context.snapshots.add(state_);
}

void DigitalSensor::connect(PartContext& context, Pin pin) {
  RobotPort& board = context.board;
  board_ = &board;
  pin_ = pin;
  board.connect(pin, *this);
}

void DigitalSensor::begin_tick(SimTime t) {
  if (board_->wants_edges(pin_)) board_->schedule_edge(pin_, level(t), t);
}

}  // namespace robosim::robot
