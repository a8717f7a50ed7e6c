// Finds the firmware's pin accesses and output around a moment, and the responsible lines of the sketch. Uses
// a run's events for pins and serial bytes: each event contains its source line.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/wire/messages.h"

namespace robosim::analysis {

/// A value at a pin: "A0" and "2.84 V", read or driven by a line of the sketch.
struct PinUse {
  std::int64_t t_ns = 0;
  std::string pin;
  std::string value;
  result::SourceLine source;
};

class PinLog {
 public:
  /// Stores each pin's last read and write up to `moment_ns`, or else the first read and write afterwards.
  explicit PinLog(std::int64_t moment_ns) : moment_ns_(moment_ns) {}

  void add(const wire::Event& event);

  /// Return the stored reads and writes, sorted by pin name.
  std::vector<PinUse> reads() const { return list(reads_); }
  std::vector<PinUse> writes() const { return list(writes_); }
  /// Returns the last write to any pin up to the moment, or else the first write afterwards.
  std::optional<PinUse> last_write() const { return last_write_; }
  /// Returns the sketch line that printed character `at` of the last output line equal to `text`.
  result::SourceLine source_of(const std::string& text, std::size_t at) const;

 private:
  struct Printed {
    std::string text;
    std::vector<result::SourceLine> sources;
  };
  using Uses = std::map<std::string, PinUse>;

  bool take(Uses& uses, PinUse use);
  static std::vector<PinUse> list(const Uses& uses);

  std::int64_t moment_ns_;
  Uses reads_, writes_;
  std::optional<PinUse> last_write_;
  std::vector<Printed> lines_{1};
};

}  // namespace robosim::analysis
