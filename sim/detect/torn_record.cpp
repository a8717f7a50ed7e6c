#include "sim/detect/torn_record.h"

#include <fmt/format.h>

#include <algorithm>

namespace robosim::detect {
namespace {

constexpr std::uint16_t kMostBytes = 4;
constexpr std::uint8_t kErased = 0xFF;
constexpr SimTime kPause = 20 * kMillisecond;  // a time without writes that ends a burst

}  // namespace

TornRecord::TornRecord(exec::Executor& executor, SnapshotRegistry& snapshots) : executor_(executor) {
  executor.board().watch_eeprom(*this);
  snapshots.add(state_);
}

void TornRecord::eeprom_written(std::uint16_t address, std::uint8_t before, std::uint8_t value, SimTime t) {
  auto& [records, burst, by, writes] = state_;
  ++writes;
  if (!burst.empty() && t - burst.back().at > kEepromWriteTime + kPause) state_.end_of_burst();
  const result::SourceLine where = executor_.sketch_source();
  const Line line{where.file, where.line};
  Record& record =
      records.try_emplace(line, Record{where, address, address, false, where.file.empty(), {}, 0})
          .first->second;
  record.first = std::min(record.first, address);
  record.last = std::max(record.last, address);
  if (burst.empty()) by = line;
  if (by != line) {
    record.is_other = true;
    if (by) records[*by].is_other = true;
    by.reset();
  }
  burst.push_back({writes, address, before, value, t});
}

void TornRecord::State::end_of_burst() {
  if (!burst.empty() && by) take(records[*by]);
  burst.clear();
}

void TornRecord::State::take(Record& record) {
  if (record.last - record.first >= kMostBytes) record.is_other = true;
  std::vector<Write> changes;
  bool was_erased = true;
  for (const Write& write : burst) {
    was_erased = was_erased && write.before == kErased;
    if (write.before != write.value) changes.push_back(write);
  }
  if (changes.size() == 1 && !was_erased) record.changed_singly = true;
  if (changes.size() < 2 || was_erased || burst.size() > kMostBytes) return;
  ++record.times;
  if (record.torn.empty()) record.torn = std::move(changes);
}

std::vector<exec::Detected> TornRecord::found(SimTime) const {
  State whole = state_;
  whole.end_of_burst();
  std::vector<exec::Detected> all;
  for (const auto& [line, record] : whole.records) {
    if (record.is_other || !record.changed_singly || record.torn.empty()) continue;
    std::string old_bytes, new_bytes, half;
    for (const Write& write : record.torn) {
      old_bytes += fmt::format(" {:02X}", write.before);
      new_bytes += fmt::format(" {:02X}", write.value);
      half += fmt::format(" {:02X}", &write == &record.torn.front() ? write.value : write.before);
    }
    const Write &first = record.torn.front(), &last = record.torn.back();
    const auto seconds = [](SimTime t) { return 1e-9 * static_cast<double>(t); };
    all.push_back(
        {result::detector("torn_record"),
         fmt::format("a power cut from {:.4f} to {:.4f} s (in a script: “after eeprom {} power off for "
                     "20ms”) leaves{} in bytes {} to {} of the EEPROM, neither the old{} nor the new{}, and "
                     "nothing reveals it: the bytes are written one by one",
                     seconds(first.at), seconds(last.at + kEepromWriteTime), first.number, half,
                     first.address, last.address, old_bytes, new_bytes),
         "Write a checksum after the record, and check it when the record is read.", record.where,
         seconds(first.at), record.times});
  }
  return all;
}

}  // namespace robosim::detect
