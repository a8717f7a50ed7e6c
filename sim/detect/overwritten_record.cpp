#include "sim/detect/overwritten_record.h"

#include <fmt/format.h>

#include "hal/board/board.h"

namespace robosim::detect {
namespace {

constexpr std::int64_t kManyWrites = 8;
constexpr SimTime kRightAfter = kEepromWriteTime + kMillisecond, kLongest = 5 * kSecond;

}  // namespace

OverwrittenRecord::OverwrittenRecord(exec::Executor& executor, SnapshotRegistry& snapshots)
    : executor_(executor) {
  executor.board().watch_eeprom(*this);
  snapshots.add(state_);
}

void OverwrittenRecord::eeprom_written(std::uint16_t address, std::uint8_t before, std::uint8_t value,
                                       SimTime t) {
  auto& [row, found] = state_;
  const bool goes_on =
      row.writes > 0 && row.address == address && before != value && t - row.last <= kRightAfter;
  if (!goes_on) row = {address, t};
  row.last = t;
  ++row.writes;
  if (row.writes == kManyWrites && !found) {
    row.where = executor_.sketch_source();
    row.found = t;
    found = row;
  } else if (found && goes_on && found->began == row.began) {
    found->writes = row.writes;
    found->last = t;
  }
}

std::vector<exec::Detected> OverwrittenRecord::found(SimTime) const {
  if (!state_.found || state_.found->last - state_.found->began > kLongest) return {};
  return {{result::detector("overwritten_record"),
           fmt::format("byte {} of the EEPROM was written {} times in immediate succession, each time with "
                       "another value: all but the last are lost",
                       state_.found->address, state_.found->writes),
           "Increment the address with each byte.", state_.found->where,
           1e-9 * static_cast<double>(state_.found->found), state_.found->writes}};
}

}  // namespace robosim::detect
