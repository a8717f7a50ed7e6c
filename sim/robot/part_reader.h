// Reads one [[part]] table of a robot file, key by key.
#pragma once

#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/base/config.h"
#include "sim/base/parameter.h"
#include "sim/robot/description.h"
#include "sim/robot/netlist.h"

namespace robosim::robot {

constexpr double kDegree = std::numbers::pi / 180.0;  ///< rad

/// The function that a wire requires of its pin.
enum class PinUse {
  digital,  ///< any pin except those that are only analog inputs
  driven,   ///< a digital pin, or an output of a shift register or PWM driver, whose level the part follows
  analog,   ///< a pin with an ADC channel
};

/// The terminals to which wires may be connected.
struct Terminals {
  const BoardSpec* board;
  const BoardSpec* written_for;     ///< the file's own board, to which its pins and volts refer
  std::vector<Register> registers;  ///< of shift registers and PWM drivers, in the file's order
};

/// Reads a point such as ["70 mm", "0 mm"]. Throws InputError.
Vec2 as_point(const ConfigValue& value, const char* key);
/// Reads a pin by number or name, or an output such as "REG1.Q4" or "pwm.12". Throws InputError if the pin
/// does not exist, or does not support `use`.
Pin as_pin(const ConfigValue& value, const char* key, const Terminals&, PinUse use);

/// A table reader with access to the board and the motor driver. Records the part's wires.
class PartReader {
 public:
  PartReader(const ConfigValue& table, const Terminals&, const Driver&);

  const std::string& name() const { return name_; }
  const std::string& type() const { return type_; }
  const Terminals& terminals() const { return terminals_; }
  const Driver& driver() const { return driver_; }
  TableReader& table() { return table_; }

  Parameter figure(const char* key, Dimension dimension, Parameter fallback, double least, double most) {
    return read_parameter(table_, key, dimension, fallback, least, most);
  }
  /// Reads a voltage from 0 to the supply, or to `most` if `most` is less. `fallback` is a share of the
  /// supply. If the board is replaced, the voltage keeps its share of the supply.
  Parameter volts(const char* key, Parameter fallback = {}, double most = 1e3);
  /// Reads the parameter of each of `count` elements: one value for all elements, or a list of `count`
  /// values.
  std::vector<Parameter> figures(const char* key, Dimension dimension, Parameter fallback, double least,
                                 double most, std::size_t count);
  /// Reads a voltage of each of `count` elements, like volts().
  std::vector<Parameter> volts_of_each(const char* key, Parameter fallback, std::size_t count);
  /// Reads the key `source_ohms` of a source that an ADC converts (PinSource::source_ohms).
  Parameter source_ohms() { return figure("source_ohms", Dimension::resistance, {}, 0.0, 10e6); }
  Vec2 point(const char* key, Vec2 fallback);
  /// Reads an angle in rad; the bounds are inclusive.
  double angle(const char* key, double fallback = 0.0, double least = -2.0 * std::numbers::pi,
               double most = 2.0 * std::numbers::pi);
  /// Reads the wire of a required key.
  Pin pin(const char* key, PinUse use);
  /// Reads the wire of an optional key, or returns kNoPin.
  Pin optional_pin(const char* key, PinUse use);
  /// Connects the part to the board's SDA and SCL, which several parts may share. Throws InputError for a
  /// board without these pins.
  void take_two_wire();
  /// Reads the key `key` as an array of pins. The roles of the wires are `role` followed by 1, 2, … If
  /// `role` is empty, the part's name replaces it.
  std::vector<Pin> pin_list(PinUse use, std::size_t most, const char* key = "pins", const char* role = "");
  /// Reads the key `pins` as a table of roles, which must match one of `groups` exactly. Returns the pins in
  /// the group's order. Sets `chosen` to the group's index.
  std::vector<Pin> pin_table(const std::vector<std::vector<const char*>>& groups, std::size_t& chosen,
                             PinUse use = PinUse::digital);

  /// Reads the key `wheel`, "left" or "right". If the key is missing, finds the side in the part's name.
  Side wheel();
  /// Reads the key `key`, "high" or "low", and returns whether it is "high".
  bool high(const char* key, bool fallback);

  /// Fills in the members that all parts share. Throws InputError for unknown keys.
  std::shared_ptr<const PartSpec> finish(std::shared_ptr<PartSpec> spec);

 private:
  TableReader table_;
  const Terminals& terminals_;
  const Driver& driver_;
  std::string name_;
  std::string type_;
  std::vector<Wire> wires_;
};

/// One part type: its name in robot files, and the function that reads its table.
struct PartType {
  const char* name;
  std::shared_ptr<const PartSpec> (*read)(PartReader&);
};

/// Returns all part types.
const std::vector<PartType>& part_types();

}  // namespace robosim::robot
