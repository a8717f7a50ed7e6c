#include "sim/robot/robot.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/did_you_mean.h"
#include "sim/base/error.h"
#include "sim/base/units.h"
#include "sim/robot/description.h"
#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/parts/button.h"
#include "sim/robot/parts/fan.h"
#include "sim/robot/parts/reflectance.h"
#include "sim/robot/parts/servo.h"
#include "sim/robot/parts/wheel_motor.h"
#include "sim/world/world.h"

namespace robosim::robot {
namespace {

template <typename Things>
std::vector<std::string> list_of(const Things& things) {
  std::vector<std::string> names;
  for (const auto* thing : things) names.push_back(thing->name());
  return names;
}

template <typename Things>
auto find_named(const Things& things, const std::string& name) {
  const auto found =
      std::find_if(things.begin(), things.end(), [&](const auto* t) { return t->name() == name; });
  return found == things.end() ? nullptr : *found;
}

}  // namespace

struct Robot::Impl {
  Impl(const Description& d, world::World& world, std::size_t body_number, RobotPort& board,
       std::uint64_t seed, Profile profile, std::uint32_t number)
      : description(d),
        body(world.body(body_number)),
        sampler(seed, profile, number),
        view{&world.floor(), &body, 0, 1.0, {d.board->supply_volts}, &world, body_number, &world.radio()},
        netlist(board, d.registers.size(), snapshots),
        analog(analog_inputs(board)),
        context(d, board, netlist, view, sampler, snapshots, analog.get()) {
    begin_battery();
    find_supply();
    if (d.electronics.fed_by_battery) board.feed(view.supply.volts);
    snapshots.add(view);
    snapshots.add(state);
  }

  // Returns null if the ADC adds no noise.
  std::unique_ptr<AnalogInputs> analog_inputs(RobotPort& board) {
    const double steps =
        sampler.ideal() ? 0.0 : sampler.draw(description.electronics.adc_noise, "electronics", "adc_noise");
    if (steps <= 0.0) return nullptr;
    return std::make_unique<AnalogInputs>(board, steps * board.spec().supply_volts / board.spec().adc_steps,
                                          sampler.noise("electronics", "adc"), snapshots);
  }
  void begin_battery() {
    const Battery& battery = description.battery;
    if (!battery.kind) return;
    const auto own = [this](const Parameter& figure, const char* key) {
      return sampler.draw(figure, "battery", key);
    };
    cells = {battery.kind, battery.cells, own(battery.resistance, "resistance"),
             own(battery.capacity_as, "capacity"), own(battery.board, "board")};
    state.charge = own(battery.charge, "charge");
    feed();
  }
  // Computes the battery's voltage for the tick that begins.
  void feed() {
    const Cells::Load load = cells.under(body, state.charge);
    state.charge -= load.taken;
    view.battery = load.volts / body.params().supply_volts;
    body.supply(load.volts);
    find_supply();
  }
  // Connects the steering servo to the body's wheels, and registers the servo for begin_tick() in each tick.
  void find_steering() {
    const Chassis& chassis = description.chassis;
    const Steering& steering = chassis.steering;
    if (!steering.exists()) return;
    const world::BodyParams& params = body.params();
    const double inner = sampler.draw(steering.limit, "chassis", "steering.limit");
    const double most =
        steering.ackermann ? world::steered_middle(inner, params.track_m, params.steer_base_m) : inner;
    const double ratio = sampler.draw(steering.ratio, "chassis", "steering.ratio");
    for (ServoPart* servo : registry.servos) {
      if (servo->name() != steering.servo) continue;
      servo->turn_wheels(body, ratio, most);
      registry.ticking.push_back(servo);
    }
  }
  bool feeds() const { return cells.kind && !state.is_forced; }
  bool is_steady() const {
    const auto steady = [](const WheelMotor* motor) { return !motor || motor->steady(); };
    return steady(registry.motor[world::left]) && steady(registry.motor[world::right]);
  }
  void find_supply() {
    if (description.electronics.fed_by_battery)
      view.supply = supply_at(view.battery * body.params().supply_volts, *description.board);
  }

  [[noreturn]] void refuse_name(const char* what, const std::string& name,
                                const std::vector<std::string>& known) const;
  Pressable& pressable(const std::string& name) const;
  Receiver& receiver(const std::string& name) const;
  void hold(const std::string& name, bool down, SimTime t);
  std::vector<Sensor*> covered_by(const std::string& name) const;
  Breakable& breakable(const std::string& name) const;
  PartFault read_fault(Breakable&, const std::string& kind, const std::vector<std::string>& arguments) const;

  struct State {
    std::vector<ButtonPart*> bouncing;
    bool edges = false;  // the board requested edges in the last tick
    world::WheelCommand command[2];
    double strongest[2] = {0.0, 0.0};  // largest absolute commands so far
    std::size_t last_seen = 0;         // index of the sensor that last detected the line
    double charge = 0.0;               // charge of the battery, 0..1
    bool is_forced = false;            // a script sets the battery's voltage
  };

  const Description& description;
  world::Body& body;
  const ParameterSampler sampler;
  Cells cells;  // empty without [battery]; values sampled for this robot
  SnapshotRegistry snapshots;
  View view;
  Netlist netlist;
  const std::unique_ptr<AnalogInputs> analog;
  PartContext context;
  std::vector<std::unique_ptr<Part>> parts;
  PartRegistry registry;
  State state;
};

void Robot::Impl::refuse_name(const char* what, const std::string& name,
                              const std::vector<std::string>& known) const {
  const std::string unknown = fmt::format("unknown {} of robot “{}”", what, description.name);
  if (known.empty()) throw InputError(fmt::format("{}: the robot has none, got “{}”", unknown, name));
  throw InputError(fmt::format("{}: {}", unknown, expected_one_of(name, known)));
}

Pressable& Robot::Impl::pressable(const std::string& name) const {
  if (Pressable* thing = find_named(registry.pressable, name)) return *thing;
  refuse_name("button", name, list_of(registry.pressable));
}

Receiver& Robot::Impl::receiver(const std::string& name) const {
  if (Receiver* part = find_named(registry.receivers, name)) return *part;
  refuse_name("receiver", name, list_of(registry.receivers));
}

void Robot::Impl::hold(const std::string& name, bool down, SimTime t) {
  Pressable& thing = pressable(name);
  thing.hold(down, t);
  ButtonPart* const button = thing.bounces();
  if (!button) return;
  std::erase(state.bouncing, button);
  state.bouncing.push_back(button);
}

std::vector<Sensor*> Robot::Impl::covered_by(const std::string& name) const {
  std::vector<Sensor*> sensors;
  for (Sensor* sensor : registry.sensors)
    if (sensor->name() == name || sensor->part() == name) sensors.push_back(sensor);
  if (!sensors.empty()) return sensors;
  refuse_name("reflectance sensor", name, list_of(registry.sensors));
}

Breakable& Robot::Impl::breakable(const std::string& name) const {
  if (Breakable* thing = find_named(registry.breakable, name)) return *thing;
  refuse_name("part for a fault", name, list_of(registry.breakable));
}

PartFault Robot::Impl::read_fault(Breakable& thing, const std::string& kind_name,
                                  const std::vector<std::string>& arguments) const {
  using enum FaultKind::Argument;
  const auto kinds = thing.fault_kinds();
  const auto kind = std::find_if(kinds.begin(), kinds.end(),
                                 [&](const FaultKind& k) { return name_of(k.failure) == kind_name; });
  if (kind == kinds.end()) {
    std::vector<std::string> names;
    for (const FaultKind& k : kinds) names.emplace_back(name_of(k.failure));
    throw InputError(fmt::format("unknown fault of {}: {}", thing.name(), expected_one_of(kind_name, names)));
  }
  const std::string what = fmt::format("fault {} {}", thing.name(), kind_name);
  if (arguments.size() != (kind->argument == none ? 0u : 1u))
    throw InputError(fmt::format("{}: expected {} after it ({})", what,
                                 kind->argument == none     ? "nothing"
                                 : kind->argument == number ? "one number"
                                                            : "the name of another sensor",
                                 kind->meaning));
  Fault fault{kind->failure};
  if (kind->argument == number) {
    const auto value = parse_quantity(arguments[0], Dimension::ratio);
    if (!value || *value < kind->least || *value > kind->most)
      throw InputError(fmt::format("{}: expected a number from {:g} to {:g} ({}), got “{}”", what,
                                   kind->least, kind->most, kind->meaning, arguments[0]));
    fault.number = *value;
  } else if (kind->argument == sensor) {
    fault.sensor = find_named(registry.sensors, arguments[0]);
    if (!fault.sensor || fault.sensor->name() == thing.name()) {
      std::vector<std::string> others = list_of(registry.sensors);
      std::erase(others, thing.name());
      throw InputError(
          others.empty()
              ? fmt::format("{}: expected another sensor, but the robot has none", what)
              : fmt::format("{}: another sensor: {}", what, expected_one_of(arguments[0], others)));
    }
  }
  return {&thing, fault};
}

Robot::Robot(const Description& description, world::World& world, std::size_t body, RobotPort& board,
             std::uint64_t seed, Profile profile, std::uint32_t number)
    : impl_(std::make_unique<Impl>(description, world, body, board, seed, profile, number)) {
  for (const auto& spec : description.parts) impl_->parts.push_back(spec->make(impl_->context));
  for (const auto& part : impl_->parts) part->register_with(impl_->registry);
  for (const auto& part : impl_->parts) part->resolve_mounts(impl_->registry);
  for (FanPart* fan : impl_->registry.fans) fan->press_on(impl_->body);
  impl_->find_steering();
  command_ = impl_->state.command;
  for (const Side side : {world::left, world::right})
    driven_from_[side] = std::min(0.5 * impl_->body.turning_drive(side), kSmallestPulse);
  has_battery_ = impl_->cells.kind;
  has_text_outputs_ = !impl_->registry.text_outputs.empty();
}

Robot::~Robot() = default;

void Robot::begin_idle_tick(SimTime t) { impl_->view.tick_start = t; }

void Robot::begin_tick(SimTime t) {
  impl_->view.tick_start = t;
  for (Part* part : impl_->registry.ticking) part->begin_tick(t);
  const bool edges = impl_->context.board.wants_any_edges();
  if (edges || impl_->state.edges)
    for (Part* part : impl_->registry.edge_makers) part->begin_tick(t);
  impl_->state.edges = edges;
  if (impl_->state.bouncing.empty()) return;
  for (ButtonPart* part : impl_->state.bouncing) part->begin_tick(t);
  std::erase_if(impl_->state.bouncing, [](const ButtonPart* part) { return part->settled(); });
}

bool Robot::end_tick(SimTime t) { return (!impl_->is_steady() || has_battery_) && take_commands(t); }

bool Robot::idles() const {
  const Impl& in = *impl_;
  return !has_battery_ && !in.state.edges && in.state.bouncing.empty() && in.is_steady() &&
         !in.context.board.wants_any_edges() && in.registry.idles();
}

[[gnu::noinline]] bool Robot::take_commands(SimTime t) {
  Impl& in = *impl_;
  bool changed = false;
  for (const Side side : {world::left, world::right}) {
    WheelMotor* motor = in.registry.motor[side];
    if (!motor || motor->steady()) continue;
    const world::WheelCommand command = motor->take(in.view.tick_start, t);
    if (command == in.state.command[side]) continue;
    changed = true;
    in.state.command[side] = command;
    in.state.strongest[side] = std::max(in.state.strongest[side], std::abs(command.drive));
    in.body.command(side, command);
    if (!in.registry.differential) continue;
    in.state.command[world::right] = command;
    in.state.strongest[world::right] = in.state.strongest[world::left];
    in.body.command(world::right, command);
  }
  if (in.feeds()) in.feed();
  return changed;
}

double Robot::sight() const { return impl_->registry.sight(); }

std::optional<double> Robot::fed_volts() const {
  if (!impl_->feeds()) return std::nullopt;
  return volts();
}

double Robot::volts() const { return impl_->view.battery * battery(); }

std::optional<double> Robot::charge() const {
  if (!impl_->cells.kind) return std::nullopt;
  return impl_->state.charge;
}

SnapshotRegistry::Snapshot Robot::save() const { return impl_->snapshots.save(); }

void Robot::restore(const SnapshotRegistry::Snapshot& saved) { impl_->snapshots.restore(saved); }

bool Robot::sees_line() const {
  const auto& sensors = impl_->registry.sensors;
  if (impl_->state.last_seen < sensors.size() && sensors[impl_->state.last_seen]->coverage() > 0.0)
    return true;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (sensors[i]->coverage() <= 0.0) continue;
    impl_->state.last_seen = i;
    return true;
  }
  return false;
}

bool Robot::straddles_line(double off_m) const {
  constexpr double kStep = 0.003;  // m, less than the width of any line
  const auto& sensors = impl_->registry.sensors;
  if (sensors.size() < 2 || impl_->body.in_hand()) return false;
  const auto is_left = [](const auto& a, const auto& b) { return a->at().y < b->at().y; };
  const auto [last, first] = std::minmax_element(sensors.begin(), sensors.end(), is_left);
  const Vec2 from = (*first)->at(), row = (*last)->at() - from;
  const double width = length(row);
  if (off_m > width) return false;
  const int steps = static_cast<int>(width / kStep) + 1;
  const world::FloorProbe probe(kStep);
  for (int i = 0; i <= steps; ++i)
    if (impl_->view.floor->on_line(impl_->body.pose().to_world(from + row * (1.0 * i / steps)), probe) > 0.0)
      return true;
  return false;
}

double Robot::line_side() const {
  double sum = 0.0, weight = 0.0;
  for (const auto& sensor : impl_->registry.sensors) {
    const double coverage = sensor->coverage();
    sum += coverage * sensor->at().y;
    weight += coverage;
  }
  return weight > 0.0 ? sum / weight : 0.0;
}

bool Robot::has_line_sensors() const { return !impl_->registry.sensors.empty(); }

Vec2 Robot::sensor_midpoint() const {
  Vec2 sum;
  double count = 0.0;
  for (const auto& part : impl_->description.parts)
    for (const SensorPlace& sensor : part->sensors()) {
      sum = sum + sensor.at;
      count += 1.0;
    }
  return count > 0.0 ? sum * (1.0 / count) : Vec2{};
}

void Robot::press(const std::string& part, SimTime t) { impl_->hold(part, true, t); }

void Robot::release(const std::string& part, SimTime t) { impl_->hold(part, false, t); }

void Robot::send(const std::string& part, const Message& message, SimTime t) {
  impl_->receiver(part).send(message, t);
}

void Robot::poll_text(SimTime t, std::vector<PartText>& told) {
  for (TextOutput* output : impl_->registry.text_outputs)
    if (std::string text = output->poll_text(t); !text.empty())
      told.push_back({output->name(), std::move(text)});
}

void Robot::power(bool on, SimTime t) {
  for (Part* part : impl_->registry.supplied) part->power(on, t);
}

double Robot::battery() const { return impl_->body.params().supply_volts; }

void Robot::set_battery(std::optional<double> volts) {
  impl_->state.is_forced = volts.has_value();
  impl_->view.battery = volts.value_or(battery()) / battery();
  impl_->find_supply();
  impl_->body.supply(volts.value_or(battery()));
}

std::vector<std::string> Robot::breakable() const {
  std::vector<std::string> names;
  for (const Breakable* thing : impl_->registry.breakable) names.push_back(thing->name());
  return names;
}

void Robot::cover(const std::string& part, bool covered) {
  for (Sensor* sensor : impl_->covered_by(part)) sensor->cover(covered);
}

void Robot::fault(const std::string& part, const std::string& kind,
                  const std::vector<std::string>& arguments) {
  fault(read_fault(part, kind, arguments));
}

PartFault Robot::read_fault(const std::string& part, const std::string& kind,
                            const std::vector<std::string>& arguments) const {
  return impl_->read_fault(impl_->breakable(part), kind, arguments);
}

void Robot::fault(const PartFault& fault) {
  fault.part->fail(fault.fault);
  for (const Side side : {world::left, world::right})
    if (const WheelMotor* motor = impl_->registry.motor[impl_->registry.differential ? world::left : side])
      impl_->body.block(side, motor->blocked());
}

void Robot::check_press(const std::string& part) const { impl_->pressable(part); }

void Robot::check_send(const std::string& part, const Message& message) const {
  impl_->receiver(part).check(message);
}

void Robot::check_tells(const std::string& part) const {
  if (!find_named(impl_->registry.text_outputs, part))
    impl_->refuse_name("part with text output", part, list_of(impl_->registry.text_outputs));
}

void Robot::check_cover(const std::string& part) const { impl_->covered_by(part); }

void Robot::read(std::vector<Reading>& readings) const {
  for (const Sensor* sensor : impl_->registry.sensors) readings.push_back({sensor->name(), sensor->shown()});
  for (const auto& part : impl_->parts) part->read(readings);
}

double Robot::strongest_command(world::Side side) const { return impl_->state.strongest[side]; }

std::vector<WiredPin> Robot::wiring() const { return wiring_of(impl_->description); }

std::vector<WiredPin> wiring_of(const Description& robot) {
  std::vector<WiredPin> pins;
  if (robot.driver.standby != kNoPin)
    pins.push_back({"driver", robot.driver.chip->name, "standby", robot.driver.standby});
  for (const auto& part : robot.parts) {
    const int wheel = part->driven_wheel() == kBothWheels ? -1 : part->driven_wheel();
    const bool steers = part->name == robot.chassis.steering.servo;
    for (const Wire& wire : part->wires)
      pins.push_back({part->name, part->type, wire.role, wire.pin, wire.may_float, wheel, steers});
  }
  return pins;
}

}  // namespace robosim::robot
