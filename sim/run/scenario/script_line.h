// Parses one line of a scenario, word by word from the left.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/board/sim_time.h"
#include "sim/base/error.h"
#include "sim/base/parse_unsigned.h"
#include "sim/base/units.h"
#include "sim/run/scenario/spread.h"

namespace robosim::scenario {

struct Word {
  std::string text;
  bool quoted = false;  ///< the word was in double quotes; escapes are decoded
  int column = 1;
};

/// Reads the words of a line. Reports invalid words by InputError, with the place of the word.
class ScriptLine {
 public:
  /// Splits the line, without its comment, into words. `place` is the beginning of the line. For each number
  /// with a spread ("12+-2"), `share` gives its position in the spread, -1 to 1.
  ScriptLine(std::string_view line, Place place, const Share& share);
  /// Returns whether the line has values with a spread.
  bool varies() const { return varies_; }

  bool more() const { return next_ < words_.size(); }
  /// Returns whether the next word is `word`, without quotes.
  bool next_is(std::string_view word) const;
  /// Returns whether the next word was in double quotes.
  bool next_is_quoted() const { return more() && words_[next_].quoted; }
  /// Consumes and returns the next word. `what` describes it in the error message if it is missing.
  const Word& take(const char* what);
  /// Consumes the next word if it is `word`.
  bool take_if(std::string_view word);
  SimTime duration();
  /// Consumes "for TIME", or TIME alone; returns nullopt at the line's end.
  std::optional<SimTime> optional_duration();
  double quantity(const char* what, Dimension dimension, double least, double most);
  /// Consumes an integer, decimal or hexadecimal (0x3FF).
  std::uint64_t whole(const char* what, std::uint64_t least, std::uint64_t most);
  /// Rejects the last consumed word.
  [[noreturn]] void refuse(const std::string& message) const;
  /// Rejects any remaining words.
  void end() const;

 private:
  std::vector<Word> words_;
  std::size_t next_ = 0;
  bool varies_ = false;
  Place place_;
};

}  // namespace robosim::scenario
