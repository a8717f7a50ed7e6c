#include "sim/robot/battery.h"

#include <algorithm>
#include <cmath>

#include "hal/board/sim_time.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {
namespace {

constexpr BatteryKind kKinds[] = {
    {"li-ion", 0.03, {4.172, 4.040, 3.929, 3.830, 3.749, 3.662, 3.627, 3.600, 3.548, 3.459, 3.180}},
    {"nimh", 0.03, {1.40, 1.32, 1.29, 1.27, 1.26, 1.25, 1.24, 1.23, 1.21, 1.17, 1.00}},
    {"alkaline", 0.2, {1.60, 1.50, 1.42, 1.36, 1.31, 1.27, 1.24, 1.20, 1.16, 1.10, 0.90}}};
constexpr double kCollapse = 0.02;  // the voltage falls to 0 V at a charge of -kCollapse
constexpr double kPerMah = 3.6;     // A s per mAh
constexpr int kMostPieces = 4;      // Newton steps: one for each linear piece of the current, and one more

}  // namespace

Battery read_battery(const ConfigValue& table) {
  TableReader reader(table, "[battery]");
  std::vector<std::string> names;
  for (const BatteryKind& kind : kKinds) names.emplace_back(kind.name);
  for (const char* key : {"kind", "cells", "capacity_mAh", "resistance", "charge", "board"}) reader.find(key);
  reader.refuse_misspelt();
  reader.require("kind");
  reader.require("cells");
  reader.require("capacity_mAh");
  const std::string name = reader.choice("kind", "", names);
  Battery battery;
  for (const BatteryKind& kind : kKinds)
    if (name == kind.name) battery.kind = &kind;
  battery.cells = static_cast<double>(reader.integer("cells", 1, 1, 12));
  battery.resistance = read_parameter(reader, "resistance", Dimension::resistance,
                                      {battery.cells * battery.kind->ohms, 0.0}, 0.0, 20.0);
  battery.capacity_as =
      read_parameter(reader, "capacity_mAh", Dimension::ratio, {}, 1.0, 1e5).scaled(kPerMah);
  battery.charge = read_parameter(reader, "charge", Dimension::ratio, {1.0, 0.0}, 0.0, 1.0);
  battery.board = read_parameter(reader, "board", Dimension::current, {0.05, 0.0}, 0.0, 2.0);
  reader.finish();
  return battery;
}

double Cells::rest_volts(double charge) const {
  if (charge <= 0.0) return cells * kind->volts[10] * std::max(1.0 + charge / kCollapse, 0.0);
  const double place = 10.0 * (1.0 - std::min(charge, 1.0));
  const auto after = std::min(static_cast<std::size_t>(place), std::size_t{9});
  const double share = place - static_cast<double>(after);
  return cells * (kind->volts[after] + share * (kind->volts[after + 1] - kind->volts[after]));
}

Cells::Load Cells::under(const world::Body& motors, double charge) const {
  const double rest = rest_volts(charge);
  // Uses Newton's method, starting above the solution. The current is convex in the voltage: its pieces get
  // steeper as the voltage rises. Therefore no step ends below the solution.
  double volts = rest;
  for (int piece = 0; piece < kMostPieces; ++piece) {
    const world::Body::Draw draw = motors.draw(volts);
    volts -= (volts - rest + ohms * (board_amps + draw.amps)) / (1.0 + ohms * draw.amps_per_volt);
  }
  volts = std::max(volts, 0.0);
  const double amps = board_amps + motors.draw(volts).amps;
  return {volts, amps * (1e-9 * static_cast<double>(kTick)) / capacity_as};
}

}  // namespace robosim::robot
