// Finds a record in EEPROM that a power cut can leave half old and half new.
//
//   EEPROM.put(0, laps);   // an int: two bytes, 3.4 ms each. From 255 (FF 00) to 256 (00 01), it is 0 in
//                          // between. setup() reads 0 if the power was cut just then
//
// A finding is a number of two to four bytes, written by one source line, with these properties:
//
//   - at least two of its bytes changed at once, over an older record that was not completely erased. A cut
//     between them leaves neither the old nor the new number;
//   - at other times, only one byte changed. This rules out a checksum among the bytes, which would have
//     changed, too;
//   - nothing else was written just before or after, such as a mark that names the valid record.
//
// The finding contains the period in which a cut would tear the record. It also contains a script line that
// cuts the power in this period (docs/reference/scripts.md). To fix a finding, store a checksum after the
// number and check it when reading. Or write two records alternately, each with a number and a checksum, so
// that the older one survives.
//
// Not detected: larger records; numbers whose bytes all change each time, such as floats; sketches that check
// the number by its range, or never read it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/detect/firmware_detector.h"

namespace robosim::detect {

class TornRecord final : public FirmwareDetector, public EepromWatcher {
 public:
  TornRecord(exec::Executor& executor, SnapshotRegistry& snapshots);

  /// Ends the current burst.
  void powered_on() override { state_.end_of_burst(); }
  void eeprom_written(std::uint16_t address, std::uint8_t before, std::uint8_t value, SimTime t) override;
  std::vector<exec::Detected> found(SimTime) const override;

 private:
  struct Write {
    std::uint64_t number = 0;  ///< counted from 1 since the run began
    std::uint16_t address = 0;
    std::uint8_t before = 0, value = 0;
    SimTime at = 0;
  };
  /// The writes of one source line.
  struct Record {
    result::SourceLine where;
    std::uint16_t first = 0, last = 0;  ///< addresses
    bool changed_singly = false;
    bool is_other = false;    ///< not a candidate: too large, or written along with other records
    std::vector<Write> torn;  ///< the first consecutive writes that a cut can separate
    std::int64_t times = 0;
  };
  using Line = std::pair<std::string, int>;

  struct State {
    std::map<Line, Record> records;
    std::vector<Write> burst;  ///< consecutive writes
    std::optional<Line> by;    ///< source line of the burst; nullopt = several lines
    std::uint64_t writes = 0;

    void end_of_burst();
    void take(Record& record);
  };

  exec::Executor& executor_;
  State state_;
};

}  // namespace robosim::detect
