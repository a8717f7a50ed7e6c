// Finds a record in EEPROM that a power cut can leave half old and half new.
//
//   EEPROM.put(0, laps);   // writes the two bytes of an int, in 3.4 ms each. If laps changes from 255
//                          // (FF 00) to 256 (00 01), the EEPROM contains 0 (00 00) after the first byte. If
//                          // the power is cut at this moment, setup() later reads 0
//
// A finding is a value of two to four bytes, written by one source line, with these properties:
//
//   - one write of the value changed at least two of its bytes, and the old bytes were not all erased (FF).
//     A power cut between these bytes leaves neither the old nor the new value;
//   - another write changed only one byte. This proves that no byte is a checksum, because a checksum would
//     have changed, too;
//   - nothing else was written just before or after, such as a mark that names the valid record.
//
// The finding contains the period in which a power cut would tear the record. It also contains a script line
// that cuts the power in this period (docs/reference/scripts.md). To fix a finding, store a checksum after
// the value, and check it when the value is read. Alternatively, write two records in turn, each with a
// sequence number and a checksum, so that the older record survives.
//
// Not detected: larger records; values whose bytes all change each time, such as floats. The detector does
// not know whether the sketch reads the value, or checks its range when the value is read.
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
    std::uint64_t number = 0;  ///< sequence number of the write, from 1 at the beginning of the run
    std::uint16_t address = 0;
    std::uint8_t before = 0, value = 0;
    SimTime at = 0;
  };
  /// The writes of one source line.
  struct Record {
    result::SourceLine where;
    std::uint16_t first = 0, last = 0;  ///< addresses
    bool changed_singly = false;
    bool is_other = false;    ///< not a candidate: too large, or written together with other records
    std::vector<Write> torn;  ///< the first consecutive writes that a power cut can separate
    std::int64_t times = 0;
  };
  using Line = std::pair<std::string, int>;

  struct State {
    std::map<Line, Record> records;
    std::vector<Write> burst;  ///< writes without a pause between them
    std::optional<Line> by;    ///< source line of the burst; nullopt = written by several lines
    std::uint64_t writes = 0;

    void end_of_burst();
    void take(Record& record);
  };

  exec::Executor& executor_;
  State state_;
};

}  // namespace robosim::detect
