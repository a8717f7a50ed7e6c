#include "sim/detect/eeprom_wear.h"

#include <fmt/format.h>

#include <utility>

namespace robosim::detect {
namespace {

constexpr double kEndurance = 100'000;
constexpr std::int64_t kManyNeedless = 10, kMany = 20;
constexpr SimTime kWhile = kSecond, kLongWhile = 5 * kSecond;
constexpr double kMinute_s = 60.0, kHour_s = 3600.0, kDay_s = 24.0 * kHour_s, kYear_s = 365.0 * kDay_s;

std::string time_text(double seconds) {
  if (seconds < kHour_s) return fmt::format("{:.0f} minutes", seconds / kMinute_s);
  if (seconds < 2 * kDay_s) return fmt::format("{:.1f} hours", seconds / kHour_s);
  if (seconds < kYear_s) return fmt::format("{:.0f} days", seconds / kDay_s);
  return fmt::format("{:.1f} years", seconds / kYear_s);
}

}  // namespace

double EepromWear::Cell::lasts_s() const {
  return 1e-9 * static_cast<double>(last - began) * kEndurance / static_cast<double>(writes - 1);
}

EepromWear::EepromWear(exec::Executor& executor, SnapshotRegistry& snapshots) : executor_(executor) {
  executor.board().watch_eeprom(*this);
  snapshots.add(state_);
}

void EepromWear::eeprom_written(std::uint16_t address, std::uint8_t before, std::uint8_t value, SimTime t) {
  Cell& cell = state_.cells.try_emplace(address, Cell{t}).first->second;
  cell.last = t;
  ++cell.writes;
  if (before == value) ++cell.needless;
  if (state_.found) {
    if (state_.found->address == address) state_.found->cell = cell;
    return;
  }
  const SimTime span = cell.last - cell.began;
  const bool is_needless = cell.needless >= kManyNeedless && span >= kWhile;
  const bool is_worn = cell.writes >= kMany && span >= kLongWhile && cell.lasts_s() < kDay_s;
  if (is_needless || is_worn) state_.found = Found{address, executor_.sketch_source(), t, cell};
}

std::vector<exec::Detected> EepromWear::found(SimTime) const {
  if (!state_.found) return {};
  const Cell& cell = state_.found->cell;
  const double span_s = 1e-9 * static_cast<double>(cell.last - cell.began);
  std::string what = fmt::format(
      "byte {} of the EEPROM withstands 100,000 writes, or {} of driving at this rate: it was written {} "
      "times in {:.1f} s{}",
      state_.found->address, time_text(cell.lasts_s()), cell.writes, span_s,
      cell.needless > 0 ? fmt::format(", {} of them with the value that it held,", cell.needless) : "");
  const bool by_update = 2 * cell.needless >= cell.writes;
  const char* mend = by_update ? "Write with EEPROM.update(), which writes only changed bytes."
                               : "Save only when needed, not in each pass of loop().";
  return {{result::detector("eeprom_wear"), std::move(what), mend, state_.found->where,
           1e-9 * static_cast<double>(state_.found->first), cell.writes}};
}

}  // namespace robosim::detect
