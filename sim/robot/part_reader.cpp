#include "sim/robot/part_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/did_you_mean.h"
#include "sim/robot/netlist.h"

namespace robosim::robot {
namespace {

constexpr double kFarthest = 0.5;  // in metres: the greatest distance of a part from the axle

std::string analog_pins(const BoardSpec& board) {
  std::vector<std::string> names;
  for (int pin = 0; pin < board.pin_count; ++pin)
    if (board.pins[pin].analog_channel >= 0) names.emplace_back(board.pins[pin].name);
  return one_of(names);
}

std::string written(const ConfigValue& value) {
  return value.kind == ConfigValue::Kind::string ? '"' + value.string + '"' : std::to_string(value.integer);
}

// Reads "NAME.Qn", an output of a shift register, or "NAME.n", an output of a PWM driver.
Pin as_output(const ConfigValue& value, const char* key, const Terminals& terminals, PinUse use) {
  const auto& registers = terminals.registers;
  const std::size_t dot = value.string.rfind('.');
  const std::string name = value.string.substr(0, dot);
  std::string number = value.string.substr(dot + 1);
  const auto found = register_of(registers, name);
  if (!found) {
    std::vector<std::string> names;
    for (const Register& r : registers)
      if (r.first_channel <= 0) names.push_back(r.part);
    const std::string unknown =
        fmt::format("{}: unknown shift register or PWM driver in {}", key, written(value));
    throw InputError(value.place, names.empty()
                                      ? fmt::format("{}: the robot has none", unknown)
                                      : fmt::format("{}: {}", unknown, expected_one_of(name, names)));
  }
  const bool shifts = registers[static_cast<std::size_t>(*found)].first_channel < 0;
  const int outputs = shifts ? kRegisterOutputs : 2 * kRegisterOutputs;
  if (shifts && !number.empty()) number = number[0] == 'Q' ? number.substr(1) : "";
  const bool digits =
      !number.empty() && number.size() <= 2 && number.find_first_not_of("0123456789") == std::string::npos;
  if (!digits || std::stoi(number) >= outputs)
    throw InputError(value.place,
                     fmt::format("{}: expected an output of {}, {}.{}0 to {}.{}{}, got {}", key, name, name,
                                 shifts ? "Q" : "", name, shifts ? "Q" : "", outputs - 1, written(value)));
  if (use != PinUse::driven)
    throw InputError(value.place, fmt::format("{}: expected a pin of the board, got {}, an output of a {}",
                                              key, written(value), shifts ? "shift register" : "PWM driver"));
  return output_pin(*found, std::stoi(number));
}

void check_use(const ConfigValue& value, const char* key, const BoardSpec& board, Pin pin, PinUse use) {
  if (pin >= board.pin_count)
    throw InputError(value.place,
                     fmt::format("{}: expected a pin of board {}, 0 to {} or {}, got {}", key, board.name,
                                 board.analog_pin_0 - 1, analog_pins(board), written(value)));
  const PinSpec& spec = board.pins[pin];
  if (use == PinUse::analog && spec.analog_channel < 0)
    throw InputError(value.place,
                     fmt::format("{}: expected a pin with an analog input on board {}, {}, got {}", key,
                                 board.name, analog_pins(board), written(value)));
  if (use != PinUse::analog && !spec.digital)
    throw InputError(
        value.place,
        fmt::format("{}: expected a digital pin of board {}, 0 to {}, got {}, which is an analog "
                    "input only",
                    key, board.name, last_digital_pin(board), written(value)));
}

}  // namespace

Vec2 as_point(const ConfigValue& value, const char* key) {
  if (value.kind != ConfigValue::Kind::array || value.items.size() != 2)
    throw InputError(value.place,
                     fmt::format("{}: expected two lengths, forward and left of the axle's centre, such as "
                                 "[\"70 mm\", \"0 mm\"]",
                                 key));
  return {as_quantity(value.items[0], key, Dimension::length, -kFarthest, kFarthest),
          as_quantity(value.items[1], key, Dimension::length, -kFarthest, kFarthest)};
}

Pin as_pin(const ConfigValue& value, const char* key, const Terminals& terminals, PinUse use) {
  if (value.kind == ConfigValue::Kind::string && value.string.find('.') != std::string::npos)
    return as_output(value, key, terminals, use);
  const BoardSpec& board = *terminals.written_for;
  Pin pin = kNoPin;
  if (value.kind == ConfigValue::Kind::integer) {
    if (value.integer >= 0 && value.integer < board.pin_count) pin = static_cast<Pin>(value.integer);
  } else if (value.kind == ConfigValue::Kind::string) {
    pin = find_pin(board, value.string.c_str());
  } else {
    throw InputError(value.place, fmt::format("{}: expected a pin such as 5 or \"A0\", got {}", key,
                                              to_string(value.kind)));
  }
  check_use(value, key, board, pin, use);
  if (terminals.board == &board) return pin;
  const Pin there = find_pin(*terminals.board, board.pins[pin].name);
  check_use(value, key, *terminals.board, there, use);
  return there;
}

PartReader::PartReader(const ConfigValue& table, const Terminals& terminals, const Driver& driver)
    : table_(table, "[[part]]"), terminals_(terminals), driver_(driver) {
  const ConfigValue& name = table_.require("name");
  name_ = as_string(name, "name");
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  };
  if (name_.empty() || name_.size() > 40 || !std::all_of(name_.begin(), name_.end(), plain))
    throw InputError(
        name.place,
        "name: expected 1 to 40 letters, digits, '_', '-' or '.', without spaces, because scripts use it");
  type_ = as_string(table_.require("type"), "type");
}

Parameter PartReader::volts(const char* key, Parameter fallback, double most) {
  const double own = terminals_.written_for->supply_volts;
  const Parameter volts = figure(key, Dimension::voltage, fallback.scaled(own), 0.0, std::min(most, own));
  return volts.scaled(terminals_.board->supply_volts / own);
}

std::vector<Parameter> PartReader::figures(const char* key, Dimension dimension, Parameter fallback,
                                           double least, double most, std::size_t count) {
  const ConfigValue* value = table_.find(key);
  if (!value || value->kind != ConfigValue::Kind::array)
    return std::vector<Parameter>(count,
                                  value ? as_parameter(*value, key, dimension, least, most) : fallback);
  if (value->items.size() != count)
    throw InputError(
        value->place,
        fmt::format("{}: expected {} values, one for each pin of {}, got {}; or give one value for "
                    "all pins, without brackets",
                    key, count, name_, value->items.size()));
  std::vector<Parameter> all;
  for (const ConfigValue& item : value->items) all.push_back(as_parameter(item, key, dimension, least, most));
  return all;
}

std::vector<Parameter> PartReader::volts_of_each(const char* key, Parameter fallback, std::size_t count) {
  const double own = terminals_.written_for->supply_volts;
  const double share = terminals_.board->supply_volts / own;
  std::vector<Parameter> all = figures(key, Dimension::voltage, fallback.scaled(own), 0.0, own, count);
  for (Parameter& volts : all) volts = volts.scaled(share);
  return all;
}

Vec2 PartReader::point(const char* key, Vec2 fallback) {
  const ConfigValue* value = table_.find(key);
  return value ? as_point(*value, key) : fallback;
}

double PartReader::angle(const char* key, double fallback, double least, double most) {
  const ConfigValue* value = table_.find(key);
  return value ? as_quantity(*value, key, Dimension::angle, least, most) : fallback;
}

Pin PartReader::pin(const char* key, PinUse use) {
  const ConfigValue& value = table_.require(key);
  wires_.push_back({key, as_pin(value, key, terminals_, use), value.place});
  return wires_.back().pin;
}

Pin PartReader::optional_pin(const char* key, PinUse use) {
  const ConfigValue* value = table_.find(key);
  return value ? pin(key, use) : kNoPin;
}

void PartReader::take_two_wire() {
  const TwiSpec& own = terminals_.written_for->chip->twi;
  if (own.address == 0)
    throw InputError(table_.table().place,
                     fmt::format("{} {} requires a two-wire bus (I2C), which is simulated "
                                 "for boards with an ATmega; this robot has the board {}",
                                 type_, name_, terminals_.written_for->name));
  const BoardSpec& board = *terminals_.board;
  for (const auto& [role, pin] : {std::pair{"sda", board.chip->twi.data}, {"scl", board.chip->twi.clock}})
    if (const Pin number = find_pin(board, pin); number != kNoPin)
      wires_.push_back({role, number, table_.table().place, true});
}

std::vector<Pin> PartReader::pin_list(PinUse use, std::size_t most, const char* key, const char* role) {
  const ConfigValue& value = table_.require(key);
  if (value.kind != ConfigValue::Kind::array || value.items.empty() || value.items.size() > most)
    throw InputError(value.place,
                     fmt::format("{}: expected a list of 1 to {} pins, such as [\"A0\", \"A1\"]", key, most));
  const std::string prefix = *role ? role : name_;
  std::vector<Pin> pins;
  for (const ConfigValue& item : value.items) {
    pins.push_back(as_pin(item, key, terminals_, use));
    wires_.push_back({prefix + std::to_string(pins.size()), pins.back(), item.place});
  }
  return pins;
}

std::vector<Pin> PartReader::pin_table(const std::vector<std::vector<const char*>>& groups,
                                       std::size_t& chosen, PinUse use) {
  const ConfigValue& value = table_.require("pins");
  std::vector<std::string> allowed;
  for (const auto& group : groups) {
    std::string names = "{";
    for (const char* role : group) names += fmt::format("{}{} = ...", names.size() > 1 ? ", " : " ", role);
    allowed.push_back(names + " }");
  }
  if (value.kind == ConfigValue::Kind::table) {
    for (chosen = 0; chosen < groups.size(); ++chosen) {
      const auto& group = groups[chosen];
      if (group.size() != value.members.size()) continue;
      if (!std::all_of(group.begin(), group.end(), [&](const char* role) { return value.find(role); }))
        continue;
      std::vector<Pin> pins;
      for (const char* role : group) {
        const ConfigValue& item = *value.find(role);
        pins.push_back(as_pin(item, role, terminals_, use));
        wires_.push_back({role, pins.back(), item.place});
      }
      return pins;
    }
  }
  throw InputError(value.place,
                   fmt::format("pins: expected a table of exactly these pins: {}", one_of(allowed)));
}

Side PartReader::wheel() {
  std::string fallback;
  for (const char* side : {"left", "right"})
    if (name_.find(side) != std::string::npos) fallback = fallback.empty() ? side : "";
  const std::string wheel = table_.choice("wheel", fallback, {"left", "right"});
  if (wheel.empty())
    throw InputError(table_.table().place,
                     fmt::format("{} {} requires the key wheel: \"left\" or \"right\"", type_, name_));
  return wheel == "left" ? world::left : world::right;
}

bool PartReader::high(const char* key, bool fallback) {
  return table_.choice(key, fallback ? "high" : "low", {"high", "low"}) == "high";
}

std::shared_ptr<const PartSpec> PartReader::finish(std::shared_ptr<PartSpec> spec) {
  table_.finish();
  spec->name = name_;
  spec->type = type_;
  spec->place = table_.table().place;
  spec->wires = std::move(wires_);
  return spec;
}

}  // namespace robosim::robot
