#include "sim/judge/overwritten_record.h"

#include <fmt/format.h>

#include "hal/board/board.h"

namespace robosim::judge {
namespace {

constexpr std::int64_t kManyWrites = 8;
constexpr SimTime kRightAfter = kEepromWriteTime + kMillisecond, kLongest = 5 * kSecond;

}  // namespace

void OverwrittenRecord::written(std::uint16_t address, std::uint8_t before, std::uint8_t value, SimTime t,
                                exec::Executor& executor) {
  const bool goes_on =
      row_.writes > 0 && row_.address == address && before != value && t - row_.last <= kRightAfter;
  if (!goes_on) row_ = {address, t};
  row_.last = t;
  ++row_.writes;
  if (row_.writes == kManyWrites && !found_) {
    row_.where = executor.sketch_source();
    row_.found = t;
    found_ = row_;
  } else if (found_ && goes_on && found_->began == row_.began) {
    found_->writes = row_.writes;
    found_->last = t;
  }
}

std::vector<exec::Detected> OverwrittenRecord::found() const {
  if (!found_ || found_->last - found_->began > kLongest) return {};
  return {{kName,
           fmt::format("byte {} of the EEPROM was written {} times in immediate succession, each time with "
                       "another value: all but the last are lost",
                       found_->address, found_->writes),
           "Increment the address with each byte.", found_->where, 1e-9 * static_cast<double>(found_->found),
           found_->writes}};
}

}  // namespace robosim::judge
