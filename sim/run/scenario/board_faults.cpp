#include "sim/run/scenario/board_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "hal/board/board_spec.h"
#include "sim/base/did_you_mean.h"
#include "sim/base/units.h"
#include "sim/run/scenario/script_line.h"

namespace robosim::scenario {
namespace {

constexpr double kMostVolts = 60.0;
constexpr double kMostDrift = 100'000.0;  // ppm

/// The kind of a fault and its arguments, as in the script.
using Words = std::vector<std::string>;

template <typename Fault>
BoardFault read_whole(const Words&, std::size_t) {
  return Fault{};
}

BoardFault read_sag(const Words& words, std::size_t) {
  const auto volts = parse_quantity(words[1], Dimension::voltage);
  if (!volts || *volts < 0.0 || *volts > kMostVolts)
    throw InputError(fmt::format("fault power sag: expected the battery's voltage from 0V to {:g}V, got “{}”",
                                 kMostVolts, words[1]));
  return PowerFault{PowerFault::Kind::sag, *volts};
}

BoardFault read_brown_out(const Words&, std::size_t) { return PowerFault{PowerFault::Kind::brown_out}; }

/// Parses "3rd" to 3; returns nullopt for other texts.
std::optional<std::uint64_t> parse_ordinal(std::string_view text) {
  for (const char* ending : {"st", "nd", "rd", "th"}) {
    if (!text.ends_with(ending)) continue;
    const auto number = parse_unsigned(text.substr(0, text.size() - 2));
    return number && *number > 0 ? number : std::nullopt;
  }
  return std::nullopt;
}

template <SerialFault::Kind kind>
BoardFault read_bytes(const Words& words, std::size_t) {
  const auto nth = parse_ordinal(words[1]);
  const auto share = parse_quantity(words[1], Dimension::ratio);
  if (!nth && !(share && *share >= 0.0 && *share <= 1.0))
    throw InputError(
        fmt::format("fault serial {}: expected a share of the bytes, from 0 to 1 or 0% to 100%, or one of "
                    "them, 1st, 2nd, 3rd, ..., got “{}”",
                    words[0], words[1]));
  return SerialFault{kind, nth ? 0.0 : *share, nth.value_or(0)};
}

BoardFault read_flip(const Words& words, std::size_t eeprom_bytes) {
  const auto address = parse_unsigned(words[1]);
  const auto bit = parse_unsigned(words[2]);
  if (!address || *address >= eeprom_bytes || !bit || *bit > 7)
    throw InputError(
        fmt::format("fault eeprom flip: expected an address from 0 to {} and a bit from 0 to 7, got “{} {}”",
                    eeprom_bytes - 1, words[1], words[2]));
  return EepromFlip{static_cast<std::uint16_t>(*address), static_cast<int>(*bit)};
}

BoardFault read_used(const Words&, std::size_t) { return EepromUsed{}; }

BoardFault read_drift(const Words& words, std::size_t) {
  const std::string& text = words[1];
  const bool in_ppm = text.ends_with("ppm");
  const auto value = parse_quantity(in_ppm ? text.substr(0, text.size() - 3) : text, Dimension::ratio);
  const double ppm = value.value_or(kMostDrift + 1) * (in_ppm ? 1.0 : 1e6);
  if (!(std::abs(ppm) <= kMostDrift))
    throw InputError(fmt::format(
        "fault clock drift: expected the amount by which the clock is too fast, from -{:g}ppm to {:g}ppm, "
        "got “{}”",
        kMostDrift, kMostDrift, text));
  return ClockDrift{static_cast<int>(std::lround(ppm))};
}

enum class Argument { none, volts, bytes, bit, ppm };

struct Kind {
  const char* thing;
  const char* name;
  Argument argument;
  bool stays;  // the fault does not end by itself
  BoardFault (*read)(const Words& words, std::size_t eeprom_bytes);
};

constexpr Kind kKinds[] = {
    {"power", "ok", Argument::none, true, read_whole<PowerFault>},
    {"power", "sag", Argument::volts, false, read_sag},
    {"power", "brown-out", Argument::none, false, read_brown_out},
    {"serial", "ok", Argument::none, true, read_whole<SerialFault>},
    {"serial", "lost", Argument::bytes, false, read_bytes<SerialFault::Kind::lost>},
    {"serial", "doubled", Argument::bytes, false, read_bytes<SerialFault::Kind::doubled>},
    {"serial", "corrupted", Argument::bytes, false, read_bytes<SerialFault::Kind::corrupted>},
    {"eeprom", "flip", Argument::bit, true, read_flip},
    {"eeprom", "used", Argument::none, true, read_used},
    {"clock", "ok", Argument::none, true, read_whole<ClockDrift>},
    {"clock", "drift", Argument::ppm, false, read_drift},
};

const Kind& find_kind(const std::string& thing, const std::string& name) {
  std::vector<std::string> names;
  for (const Kind& kind : kKinds) {
    if (kind.thing != thing) continue;
    if (kind.name == name) return kind;
    names.emplace_back(kind.name);
  }
  throw InputError(fmt::format("unknown fault of {}: {}", thing, expected_one_of(name, names)));
}

}  // namespace

bool repairs(const BoardFault& fault) {
  return std::visit([](const auto& one) { return one.repairs(); }, fault);
}

BoardFaults::BoardFaults(exec::Executor& executor, robot::Robot& robot, std::uint64_t seed,
                         std::uint32_t number)
    : executor_(executor),
      robot_(robot),
      noise_(seed, number, "serial", "fault"),
      left_there_(seed, number, "eeprom", "used") {
  state_.chip_volts = executor.board().spec().supply_volts;
  executor.board().watch_eeprom(*this);
}

const std::vector<std::string>& BoardFaults::names() {
  static const std::vector<std::string> names{"power", "serial", "eeprom", "clock"};
  return names;
}

bool BoardFaults::knows(const std::string& name) {
  return std::find(names().begin(), names().end(), name) != names().end();
}

BoardFault BoardFaults::read(const std::string& name, const std::vector<std::string>& arguments,
                             bool ends) const {
  const Kind& kind = find_kind(name, arguments.front());
  constexpr std::size_t kCount[] = {0, 1, 1, 2, 1};
  constexpr const char* kWanted[] = {"nothing", "a voltage",
                                     "a share of the bytes, or one of them: 1st, 2nd, 3rd, ...",
                                     "an address and a bit", "a share: 5000ppm or 0.5%"};
  const auto argument = static_cast<std::size_t>(kind.argument);
  if (arguments.size() != kCount[argument] + 1)
    throw InputError(fmt::format("fault {} {}: expected {} after it", name, kind.name, kWanted[argument]));
  if (ends && kind.stays)
    throw InputError(fmt::format("fault {} {} happens once and cannot end after a time; remove the duration",
                                 name, kind.name));
  if (name == "eeprom") check_eeprom();
  return kind.read(arguments, executor_.probe().memory().size());
}

void BoardFaults::check_eeprom() const {
  if (!executor_.has_boards_eeprom())
    throw InputError(
        "eeprom: scripts can neither damage the EEPROM nor await its writes on this target; use the target "
        "host or avr");
}

void BoardFaults::fail(const BoardFault& fault, SimTime t) {
  std::visit([&](const auto& one) { begin(one, t); }, fault);
}

void BoardFaults::repair(const BoardFault& fault, SimTime t) {
  std::visit([&](const auto& one) { begin(std::decay_t<decltype(one)>{}, t); }, fault);
}

void BoardFaults::begin(const PowerFault& fault, SimTime t) {
  using enum PowerFault::Kind;
  const BoardSpec& spec = executor_.board().spec();
  const double low = std::min(robot_.battery(), spec.brown_out_volts + spec.regulator_drop_volts - 0.1);
  if (fault.kind == none) {
    robot_.set_battery(std::nullopt);
    supply_board(robot_.battery(), t);
  } else {
    set_battery(fault.kind == sag ? fault.volts : low, t);
  }
  if (fault.kind == brown_out) state_.chip_volts = std::min(state_.chip_volts, spec.brown_out_volts - 0.1);
  update_power(t);
}

void BoardFaults::begin(const SerialFault& fault, SimTime) {
  state_.serial = fault;
  state_.bytes_before = state_.bytes;
}

void BoardFaults::begin(const EepromFlip& fault, SimTime) {
  std::uint8_t& byte = executor_.probe().memory()[fault.address];
  byte = static_cast<std::uint8_t>(byte ^ 1 << fault.bit);
}

void BoardFaults::begin(const EepromUsed&, SimTime) {
  std::uint64_t address = 0;
  for (std::uint8_t& byte : executor_.probe().memory())
    byte = static_cast<std::uint8_t>(left_there_.bits(address++));
}

void BoardFaults::begin(const ClockDrift& fault, SimTime t) {
  executor_.set_clock_drift(fault.ppm.value_or(0), t);
}

void BoardFaults::set_battery(double volts, SimTime t) {
  robot_.set_battery(volts);
  supply_board(volts, t);
}

void BoardFaults::feed(double volts, SimTime t) {
  supply_board(volts, t);
  update_power(t);
}

void BoardFaults::supply_board(double volts, SimTime t) {
  const BoardSpec& spec = executor_.board().spec();
  const bool feeds_board =
      robot_.battery() - spec.regulator_drop_volts >= std::max(spec.brown_out_volts, kLogicKeeps);
  state_.chip_volts =
      feeds_board ? std::clamp(volts - spec.regulator_drop_volts, 0.0, spec.supply_volts) : spec.supply_volts;
  const bool keeps = state_.chip_volts >= kLogicKeeps;
  if (state_.switched_on && keeps != state_.keeps) robot_.power(keeps, t);
  state_.keeps = keeps;
}

void BoardFaults::switch_power(bool on, SimTime t) {
  if (on == state_.switched_on) return;
  state_.switched_on = on;
  if (state_.keeps) robot_.power(on, t);
  update_power(t);
}

void BoardFaults::update_power(SimTime t) {
  if (!state_.switched_on || state_.chip_volts < kPowerOnReset) state_.was_gone = true;
  const bool powered = state_.switched_on && state_.chip_volts >= executor_.board().spec().brown_out_volts;
  if (powered == state_.powered) return;
  state_.powered = powered;
  state_.changed = t;
  if (!powered) state_.browned_out = state_.switched_on;
  state_.resets += !powered && state_.switched_on;
  if (powered) {
    if (std::exchange(state_.browned_out, false)) state_.recovered = t;
    ++state_.boots;
    if (std::exchange(state_.was_gone, false))
      executor_.power_on(t);
    else
      executor_.power_recovered(t);
  } else {
    executor_.power_off(t);
  }
}

judge::SupplySummary BoardFaults::power() const {
  const BoardSpec& spec = executor_.board().spec();
  return {
      state_.powered,   state_.switched_on, state_.changed, state_.resets,
      state_.recovered, robot_.charge(),    robot_.volts(), spec.brown_out_volts + spec.regulator_drop_volts};
}

std::optional<result::PowerLost::HalfWritten> BoardFaults::leave_half_written(const HalfWritten& what,
                                                                              SimTime t) {
  if (!state_.last_write || t >= state_.last_write->began + kEepromWriteTime) return std::nullopt;
  std::uint8_t& byte = executor_.probe().memory()[state_.last_write->address];
  if (what.kind == HalfWritten::Kind::before) byte = state_.last_write->before;
  if (what.kind == HalfWritten::Kind::value) byte = what.value;
  return result::PowerLost::HalfWritten{state_.last_write->address, byte};
}

void BoardFaults::send(const std::string& bytes, SimTime t) {
  using enum SerialFault::Kind;
  RobotPort& board = executor_.board();
  for (const char c : bytes) {
    auto byte = static_cast<std::uint8_t>(c);
    const std::uint64_t n = state_.bytes++;
    const bool hit = state_.serial.kind != none &&
                     (state_.serial.nth > 0 ? n - state_.bytes_before + 1 == state_.serial.nth
                                            : noise_.uniform(2 * n) < state_.serial.share);
    if (hit && state_.serial.kind == lost) continue;
    if (hit && state_.serial.kind == corrupted)
      byte = static_cast<std::uint8_t>(byte ^ 1 << (noise_.bits(2 * n + 1) & 7));
    board.receive_byte(byte, t);
    if (hit && state_.serial.kind == doubled) board.receive_byte(byte, t);
  }
}

void BoardFaults::eeprom_written(std::uint16_t address, std::uint8_t before, std::uint8_t, SimTime t) {
  ++state_.writes;
  state_.last_write = {address, before, t};
}

}  // namespace robosim::scenario
