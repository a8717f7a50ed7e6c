// A run's samples and what happens at its pins, gathered as columns (columns.h).
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

/// What a logic analyser would show of a pin.
enum class PinLevel { low = 0, high = 1, floating = 2, pulsing = 3 };

/// Pulsing: driven by PWM or tone(), faster than each edge is told. A pull-up without more is high.
constexpr PinLevel pin_level(bool output, bool pullup, bool pwm, double duty, std::uint32_t tone_hz) {
  if (!output) return pullup ? PinLevel::high : PinLevel::floating;
  if (tone_hz > 0 || (pwm && duty > 0.0 && duty < 1.0)) return PinLevel::pulsing;
  return duty >= 0.5 ? PinLevel::high : PinLevel::low;
}

PinLevel pin_level(const PinChange& pin);

std::vector<ColumnSpec> sample_columns(const std::vector<std::string>& readings);
/// `sources`: with the lines that drive the pin.
std::vector<ColumnSpec> pin_columns(bool sources = false);
const std::vector<ColumnSpec>& volts_columns();

/// Numbers of the lines that drive pins, from 1 in the order in which they come.
class SourceNumbers {
 public:
  /// 0 = it is none.
  int of(const SourceLine& line);
  /// Those since the last call.
  std::vector<SourceLine> take_new();

 private:
  std::map<std::tuple<std::string, int, std::string>, int> numbers_;
  std::vector<SourceLine> new_;
};

/// How often columns are told, simulated time.
constexpr std::int64_t kColumnsEvery_ns = 2'000'000'000;

class RunColumns {
 public:
  /// The board's pins, by number. `sources`: with the lines that drive them.
  explicit RunColumns(const std::vector<std::string>& pins, bool sources = false);
  /// One more, and its number.
  std::size_t add_board_pin(const std::string& name);
  /// Pins that are added from now on have sources.
  void with_sources() { has_sources_ = true; }

  void begin(const std::vector<std::string>& readings);
  void add(const Sample& sample);
  void add_pin(std::size_t pin, std::int64_t t_ns, PinLevel level, double duty, std::uint32_t tone_hz,
               const SourceLine* source = nullptr);
  void add_volts(std::size_t pin, std::int64_t t_ns, double volts);

  /// All since the last call; without streams if there is nothing.
  Columns take();

 private:
  /// What happens at one pin. A row that says nothing new is left out.
  struct Changes {
    Stream stream;
    std::array<double, 4> last{-1.0};  ///< of fewer columns the rest is unused; the time is never negative
  };
  void change(Changes& changes, const std::array<double, 4>& row, const SourceLine* source);

  std::vector<Stream> samples_;  ///< one, once it has begun
  std::vector<Changes> pins_, volts_;
  bool has_sources_;
  SourceNumbers sources_;
};

}  // namespace robosim::wire
