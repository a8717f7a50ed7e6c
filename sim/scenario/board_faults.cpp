#include "sim/scenario/board_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hal/board/board_spec.h"
#include "sim/base/units.h"
#include "sim/scenario/script_line.h"

namespace robosim::scenario {
namespace {

enum class Argument { none, volts, bytes, bit, ppm };

struct Kind {
  const char* thing;
  const char* name;
  Argument argument;
  bool stays;  // cannot end by itself
};

constexpr Kind kKinds[] = {
    {"power", "ok", Argument::none, true},           {"power", "sag", Argument::volts, false},
    {"power", "brown-out", Argument::none, false},   {"serial", "ok", Argument::none, true},
    {"serial", "lost", Argument::bytes, false},      {"serial", "doubled", Argument::bytes, false},
    {"serial", "corrupted", Argument::bytes, false}, {"eeprom", "flip", Argument::bit, true},
    {"clock", "ok", Argument::none, true},           {"clock", "drift", Argument::ppm, false},
};
constexpr double kMostVolts = 60.0;
constexpr double kMostDrift = 100'000.0;  // ppm

const Kind& find_kind(const std::string& thing, const std::string& name) {
  std::vector<std::string> names;
  for (const Kind& kind : kKinds) {
    if (kind.thing != thing) continue;
    if (kind.name == name) return kind;
    names.emplace_back(kind.name);
  }
  throw InputError(fmt::format("{} has no fault {}; there are {}", thing, name, one_of(names)));
}

double parse_volts(const std::string& text) {
  const auto volts = parse_quantity(text, Dimension::voltage);
  if (!volts || *volts < 0.0 || *volts > kMostVolts)
    throw InputError(fmt::format("fault power sag {}: allowed is the battery's voltage, from 0V to {:g}V",
                                 text, kMostVolts));
  return *volts;
}

/// "3rd": 3; nothing if it is no such number.
std::optional<std::uint64_t> parse_ordinal(std::string_view text) {
  for (const char* ending : {"st", "nd", "rd", "th"}) {
    if (!text.ends_with(ending)) continue;
    const auto number = parse_whole(text.substr(0, text.size() - 2));
    return number && *number > 0 ? number : std::nullopt;
  }
  return std::nullopt;
}

int parse_ppm(const std::string& text) {
  const bool in_ppm = text.ends_with("ppm");
  const auto value = parse_quantity(in_ppm ? text.substr(0, text.size() - 3) : text, Dimension::ratio);
  const double ppm = value.value_or(kMostDrift + 1) * (in_ppm ? 1.0 : 1e6);
  if (!(std::abs(ppm) <= kMostDrift))
    throw InputError(
        fmt::format("fault clock drift {}: allowed is how much too fast it runs, from -{:g}ppm to "
                    "{:g}ppm",
                    text, kMostDrift, kMostDrift));
  return static_cast<int>(std::lround(ppm));
}

struct Bit {
  std::uint16_t address;
  int number;
};

Bit parse_bit(const std::vector<std::string>& arguments, std::size_t bytes) {
  const auto address = parse_whole(arguments[1]);
  const auto bit = parse_whole(arguments[2]);
  if (!address || *address >= bytes || !bit || *bit > 7)
    throw InputError(
        fmt::format("fault eeprom flip {} {}: allowed are an address from 0 to {} and a bit from 0 "
                    "to 7",
                    arguments[1], arguments[2], bytes - 1));
  return {static_cast<std::uint16_t>(*address), static_cast<int>(*bit)};
}

}  // namespace

BoardFaults::BoardFaults(exec::Executor& executor, robot::Robot& robot, std::uint64_t seed,
                         std::uint32_t number)
    : executor_(executor),
      robot_(robot),
      noise_(seed, number, "serial", "fault"),
      chip_volts_(executor.board().spec().supply_volts) {
  executor.board().watch_eeprom(*this);
}

const std::vector<std::string>& BoardFaults::names() {
  static const std::vector<std::string> names{"power", "serial", "eeprom", "clock"};
  return names;
}

bool BoardFaults::knows(const std::string& name) {
  return std::find(names().begin(), names().end(), name) != names().end();
}

BoardFaults::SerialFault BoardFaults::read_serial_fault(const std::vector<std::string>& arguments) {
  using enum SerialFault::Kind;
  SerialFault fault;
  fault.kind = arguments[0] == "lost" ? lost : arguments[0] == "doubled" ? doubled : corrupted;
  const auto nth = parse_ordinal(arguments[1]);
  const auto share = parse_quantity(arguments[1], Dimension::ratio);
  if (!nth && !(share && *share >= 0.0 && *share <= 1.0))
    throw InputError(
        fmt::format("fault serial {} {}: allowed are a share of the bytes, from 0 to 1 or 0% to "
                    "100%, and one of them: 1st, 2nd, 3rd, …",
                    arguments[0], arguments[1]));
  fault.nth = nth.value_or(0);
  fault.share = nth ? 0.0 : *share;
  return fault;
}

void BoardFaults::check(const std::string& name, const std::vector<std::string>& arguments, bool ends) const {
  const Kind& kind = find_kind(name, arguments.front());
  constexpr std::size_t kCount[] = {0, 1, 1, 2, 1};
  constexpr const char* kWanted[] = {"nothing more", "a voltage",
                                     "a share of the bytes, or which one: 1st, 2nd, 3rd, …",
                                     "an address and a bit", "a share: 5000ppm or 0.5%"};
  const auto argument = static_cast<std::size_t>(kind.argument);
  if (arguments.size() != kCount[argument] + 1)
    throw InputError(fmt::format("fault {} {} takes {}", name, kind.name, kWanted[argument]));
  if (ends && kind.stays)
    throw InputError(fmt::format("fault {} {} is no state that could end after a time", name, kind.name));
  if (kind.argument == Argument::volts) parse_volts(arguments[1]);
  if (kind.argument == Argument::bytes) read_serial_fault(arguments);
  if (kind.argument == Argument::ppm) parse_ppm(arguments[1]);
  if (name == "eeprom") check_eeprom();
  if (kind.argument == Argument::bit) parse_bit(arguments, executor_.probe().memory().size());
}

void BoardFaults::check_eeprom() const {
  if (!executor_.has_boards_eeprom())
    throw InputError(
        "eeprom: on this target scripts can neither break nor follow it; they can on host and avr");
}

void BoardFaults::fail(const std::string& name, const std::vector<std::string>& arguments, SimTime t) {
  const std::string& kind = arguments.front();
  if (name == "power") {
    const double low = std::min(robot_.battery(), kBrownOut + kRegulatorDrop - 0.1);
    set_battery(kind == "ok" ? robot_.battery() : kind == "sag" ? parse_volts(arguments[1]) : low, t);
    if (kind == "brown-out") chip_volts_ = std::min(chip_volts_, kBrownOut - 0.1);
    update_power(t);
  } else if (name == "serial") {
    serial_ = kind == "ok" ? SerialFault{} : read_serial_fault(arguments);
    bytes_before_ = bytes_;
  } else if (name == "clock") {
    executor_.set_clock_drift(kind == "ok" ? 0 : parse_ppm(arguments[1]), t);
  } else {
    const std::span<std::uint8_t> eeprom = executor_.probe().memory();
    const Bit bit = parse_bit(arguments, eeprom.size());
    eeprom[bit.address] = static_cast<std::uint8_t>(eeprom[bit.address] ^ 1 << bit.number);
  }
}

void BoardFaults::set_battery(double volts, SimTime t) {
  robot_.set_battery(volts);
  const double supply = executor_.board().spec().supply_volts;
  const bool feeds_board = robot_.battery() - kRegulatorDrop >= kBrownOut;
  chip_volts_ = feeds_board ? std::clamp(volts - kRegulatorDrop, 0.0, supply) : supply;
  const bool keeps = chip_volts_ >= kLogicKeeps;
  if (switched_on_ && keeps != keeps_) robot_.power(keeps, t);
  keeps_ = keeps;
}

void BoardFaults::switch_power(bool on, SimTime t) {
  if (on == switched_on_) return;
  switched_on_ = on;
  if (keeps_) robot_.power(on, t);
  update_power(t);
}

void BoardFaults::update_power(SimTime t) {
  const bool powered = switched_on_ && chip_volts_ >= kBrownOut;
  if (powered == powered_) return;
  powered_ = powered;
  if (powered) {
    ++boots_;
    executor_.power_on(t);
  } else {
    executor_.power_off(t);
  }
}

std::optional<wire::PowerLost::HalfWritten> BoardFaults::leave_half_written(const HalfWritten& what,
                                                                            SimTime t) {
  if (!last_write_ || t >= last_write_->began + kEepromWriteTime) return std::nullopt;
  std::uint8_t& byte = executor_.probe().memory()[last_write_->address];
  if (what.kind == HalfWritten::Kind::before) byte = last_write_->before;
  if (what.kind == HalfWritten::Kind::value) byte = what.value;
  return wire::PowerLost::HalfWritten{last_write_->address, byte};
}

void BoardFaults::send(const std::string& bytes, SimTime t) {
  using enum SerialFault::Kind;
  RobotPort& board = executor_.board();
  for (const char c : bytes) {
    auto byte = static_cast<std::uint8_t>(c);
    const std::uint64_t n = bytes_++;
    const bool hit = serial_.kind != none && (serial_.nth > 0 ? n - bytes_before_ + 1 == serial_.nth
                                                              : noise_.uniform(2 * n) < serial_.share);
    if (hit && serial_.kind == lost) continue;
    if (hit && serial_.kind == corrupted)
      byte = static_cast<std::uint8_t>(byte ^ 1 << (noise_.bits(2 * n + 1) & 7));
    board.receive_byte(byte, t);
    if (hit && serial_.kind == doubled) board.receive_byte(byte, t);
  }
}

void BoardFaults::eeprom_written(std::uint16_t address, std::uint8_t before, std::uint8_t, SimTime t) {
  ++writes_;
  last_write_ = {address, before, t};
}

}  // namespace robosim::scenario
