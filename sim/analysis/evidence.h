// What firmware did around a moment, and which lines of the sketch did it: from a run's events of pins and
// bytes that say their source.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/wire/messages.h"

namespace robosim::analysis {

/// Something that crossed a pin: "A0" and "2.84 V", read by or driven from a line of the sketch.
struct PinUse {
  std::int64_t t_ns = 0;
  std::string pin;
  std::string value;
  wire::Source source;
};

class Evidence {
 public:
  /// Keeps of each pin the last use before `moment_ns`, or the first behind it.
  explicit Evidence(std::int64_t moment_ns) : moment_ns_(moment_ns) {}

  void add(const wire::Event& event);

  /// By the names of the pins.
  std::vector<PinUse> reads() const { return list(reads_); }
  std::vector<PinUse> writes() const { return list(writes_); }
  /// The last of those that the firmware drove before the moment.
  std::optional<PinUse> last_write() const { return last_write_; }
  /// Which line has printed the character number `at` of the last line `text`.
  wire::Source source_of(const std::string& text, std::size_t at) const;

 private:
  struct Printed {
    std::string text;
    std::vector<wire::Source> sources;
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
