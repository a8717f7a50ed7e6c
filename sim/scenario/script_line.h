// One line of a scenario, taken apart into words from the left.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/base/error.h"
#include "sim/base/units.h"
#include "sim/base/whole.h"
#include "sim/scenario/spread.h"

namespace robosim::scenario {

struct Word {
  std::string text;
  bool quoted = false;  ///< it stood in double quotes; escapes are undone
  int column = 1;
};

/// Everything throws InputError, with the place of the word it is about.
class ScriptLine {
 public:
  /// Cuts the line up to a comment; `place` is its beginning. `share` draws what has a spread.
  ScriptLine(std::string_view line, Place place, const Share& share);
  /// Whether something has.
  bool varies() const { return varies_; }

  bool more() const { return next_ < words_.size(); }
  /// Whether the next word is this one, without quotes.
  bool next_is(std::string_view word) const;
  /// Whether the next word stood in double quotes.
  bool next_is_quoted() const { return more() && words_[next_].quoted; }
  /// The next word, which `what` describes if it is missing.
  const Word& take(const char* what);
  /// Takes the next word if it is this one.
  bool take_if(std::string_view word);
  SimTime duration();
  /// "for TIME", or TIME alone; nothing at the line's end.
  std::optional<SimTime> optional_duration();
  double quantity(const char* what, Dimension dimension, double least, double most);
  /// A whole number, decimal or as 0x3FF.
  std::uint64_t whole(const char* what, std::uint64_t least, std::uint64_t most);
  /// Refuses the word that was taken last.
  [[noreturn]] void refuse(const std::string& message) const;
  /// Refuses whatever is left.
  void end() const;

 private:
  std::vector<Word> words_;
  std::size_t next_ = 0;
  bool varies_ = false;
  Place place_;
};

}  // namespace robosim::scenario
