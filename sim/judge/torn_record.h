// A record in EEPROM that a power cut can leave half old and half new.
//
//   EEPROM.put(0, laps);        an int: two bytes, 3.4 ms each. From 255 (FF 00) to 256 (00 01) it is 0
//   between
//                               them, and that is what setup() reads after the switch was turned just then
//
// What is found is a number of two to four bytes, written by one line, of which
//
//   at least two bytes changed at once, where an older record was (not all of it erased); a cut between them
//   leaves what is neither the old number nor the new one;
//   at other times a single byte changed: so none of the others is a checksum, which would have had to
//   change; and nothing else was written just before or after, such as a mark that says which record holds.
//
// The finding has the time during which a cut would tear it, and the line of a script (docs/scripts.md) that
// cuts there. Mended by a checksum behind the number, which is looked at when it is read; or by two records
// in turn, each with a number and a checksum, so that the older one is still there.
//
// What it cannot see: larger records; numbers of which all bytes change each time, as a float's do; whether
// the sketch refuses what it reads by itself (by its range), or reads it at all.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/exec/core/executor.h"

namespace robosim::judge {

class TornRecord {
 public:
  static constexpr const char* kName = "torn_record";

  /// The firmware has started.
  void powered_on() { end_of_burst(); }
  /// Each byte whose writing begins at `t`, since the run began.
  void written(std::uint16_t address, std::uint8_t before, std::uint8_t value, SimTime t,
               exec::Executor& executor);
  /// At the end of the run.
  std::vector<exec::Detected> found() const;

 private:
  struct Write {
    std::uint64_t number = 0;  ///< counted from 1 since the run began
    std::uint16_t address = 0;
    std::uint8_t before = 0, value = 0;
    SimTime at = 0;
  };
  /// What one line writes.
  struct Record {
    wire::SourceLine where;
    std::uint16_t first = 0, last = 0;  ///< addresses
    bool changed_singly = false;
    bool is_other = false;    ///< something that is looked at in vain: large, or written along with others
    std::vector<Write> torn;  ///< the first writes, one after the other, that a cut can separate
    std::int64_t times = 0;
  };
  using Line = std::pair<std::string, int>;

  void end_of_burst();
  void take(Record& record);

  std::map<Line, Record> records_;
  std::vector<Write> burst_;  ///< writes that came one right after the other
  std::optional<Line> by_;    ///< whose they are; nothing: of several
  std::uint64_t writes_ = 0;
};

}  // namespace robosim::judge
