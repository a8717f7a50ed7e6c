// Collects a run's samples and pin events as columns (columns.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "sim/wire/columns.h"

namespace robosim::wire {

struct PinChange;
struct Sample;

/// The states of a pin as a logic analyser shows them.
enum class PinLevel { low = 0, high = 1, floating = 2, pulsing = 3 };

/// Returns the pin's state. Pulsing is PWM or tone(), whose edges are not reported one by one. A pull-up
/// alone counts as high.
constexpr PinLevel pin_level(bool output, bool pullup, bool pwm, double duty, std::uint32_t tone_hz) {
  if (!output) return pullup ? PinLevel::high : PinLevel::floating;
  if (tone_hz > 0 || (pwm && duty > 0.0 && duty < 1.0)) return PinLevel::pulsing;
  return duty >= 0.5 ? PinLevel::high : PinLevel::low;
}

PinLevel pin_level(const PinChange& pin);

std::vector<ColumnSpec> sample_columns(const std::vector<std::string>& readings);
/// Returns the columns of a pin. `sources` adds a column for the sketch's lines that drive the pin.
std::vector<ColumnSpec> pin_columns(bool sources = false);
const std::vector<ColumnSpec>& volts_columns();

/// Numbers the sketch's lines that drive pins, from 1 in the order of their appearance.
class SourceNumbers {
 public:
  /// Returns the line's number; 0 = unknown line.
  int of(const SourceLine& line);
  /// Returns the lines that are new since the last call.
  std::vector<SourceLine> take_new();

 private:
  std::map<std::tuple<std::string, int, std::string>, int> numbers_;
  std::vector<SourceLine> new_;
};

/// The simulated time between two reports of columns.
constexpr std::int64_t kColumnsEvery_ns = 2'000'000'000;

class RunColumns {
 public:
  /// Makes columns for the board's pins, in the order of their numbers. `sources` adds the sketch's lines
  /// that drive the pins.
  explicit RunColumns(const std::vector<std::string>& pins, bool sources = false);
  /// Adds a pin, and returns its number.
  std::size_t add_board_pin(const std::string& name);
  /// Adds sources to pins that are added from now on.
  void with_sources() { has_sources_ = true; }

  void begin(const std::vector<std::string>& readings);
  void add(const Sample& sample);
  void add_pin(std::size_t pin, std::int64_t t_ns, PinLevel level, double duty, std::uint32_t tone_hz,
               const SourceLine* source = nullptr);
  void add_volts(std::size_t pin, std::int64_t t_ns, double volts);

  /// Returns all rows since the last call. Omits streams without such rows.
  Columns take();

 private:
  /// The events at one pin. Rows without a change are skipped.
  struct Changes {
    Stream stream;
    std::array<double, 4> last{-1.0};  ///< the last row, which begins with its time; -1 = no row yet
  };
  void change(Changes& changes, const std::array<double, 4>& row, const SourceLine* source);

  std::vector<Stream> samples_;  ///< one stream, after begin()
  std::vector<Changes> pins_, volts_;
  bool has_sources_;
  SourceNumbers sources_;
};

}  // namespace robosim::wire
