// Records the observable behaviour of a run for comparison: the robot's places, output, motors and end.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/wire/messages.h"

namespace robosim::analysis {

/// A time, and its text: a place's name or a line of output.
struct TimedText {
  std::int64_t t_ns = 0;
  std::string text;
};

/// The combined state of the two motors. In `ahead` and `back`, the mean of the two commands is at least a
/// quarter of their difference. Otherwise the robot turns on the spot.
enum class Manoeuvre : std::uint8_t { stands, ahead, back, turns_left, turns_right };

/// A period of one manoeuvre.
struct Stretch {
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;
  Manoeuvre manoeuvre = Manoeuvre::stands;
  double left = 0.0;  ///< mean command, -1..1
  double right = 0.0;

  std::int64_t duration_ns() const { return to_ns - from_ns; }
};

struct History {
  std::string target;
  std::vector<TimedText> places;  ///< in order of time; no place twice in a row
  std::vector<TimedText>
      lines;  ///< from the serial port, without line ends, and without a last line that was cut off
  std::vector<Stretch> stretches;  ///< consecutive
  std::string verdict;
  std::string why;
  std::int64_t end_ns = 0;
  /// Time at which the robot lost the line. Later behaviour depends on chance, and is not stored.
  std::optional<std::int64_t> lost_ns;
};

/// Name of the place while the robot is off the line.
inline constexpr const char* kOffTheLine = "off the line";

/// Returns the robot's place: "" between two places, kOffTheLine off the line.
using PlaceFinder = std::function<std::string(const wire::Sample&)>;

/// Records a run from its samples (every 10 ms), serial text and notes.
class HistoryRecorder {
 public:
  HistoryRecorder(std::string target, PlaceFinder place);

  void add(const wire::Event& event);
  History finish(const result::RunResult& result);

  static constexpr std::int64_t kSampleEvery_ns = 10'000'000;

 private:
  void add(const wire::Sample& sample);
  void add(const wire::SerialText& serial);
  void visit(std::int64_t t_ns, std::string place);

  History history_;
  PlaceFinder place_;
  bool line_open_ = false;
  std::int64_t last_ns_ = 0;
};

/// Returns "stands", "drives ahead", "turns left on the spot" …
const char* name_of(Manoeuvre manoeuvre);
Manoeuvre manoeuvre_of(double left, double right);

}  // namespace robosim::analysis
