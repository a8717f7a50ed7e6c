// Collects the facts about each pin that a sketch uses: its name, and its use.
#pragma once

#include <initializer_list>
#include <set>
#include <string>
#include <vector>

#include "sim/campaign/wiring/name_words.h"
#include "sim/campaign/wiring/pin_facts.h"
#include "sim/campaign/wiring/sketch_names.h"

namespace robosim::wiring {

struct PinEvidence {
  Pin pin = kNoPin;
  std::string name;                       ///< empty = none
  std::vector<std::string> words;         ///< words of the name, and the side that the source names elsewhere
  bool is_direction_from_source = false;  ///< a comment names the direction, not the pin's name
  bool is_side_from_source = false;       ///< comments or functions name the side, not the pin's name
  bool in_array = false;
  int argument = -1;              ///< position among the object's arguments; -1 = none
  const Given* object = nullptr;  ///< the object or function that receives the pin
  Spot spot;
  const PinFacts* facts = nullptr;
  bool is_assumed = false;  ///< not used in the runs: the facts come from calls in the source

  bool is_read() const { return facts->looked || facts->measured; }
  bool is_used() const { return facts->driven || is_read() || facts->pulled_up; }
};

/// All pins that a sketch uses or names, sorted by where their names are in the source, then by number. A
/// guess that identifies a pin's part marks the pin as taken.
class Evidence {
 public:
  Evidence(const BoardSpec& board, const SketchNames& names, const PinHistory& history);

  const BoardSpec& board() const { return board_; }
  const SketchNames& names() const { return names_; }
  const PinHistory& history() const { return history_; }

  const PinEvidence& of(Pin pin) const { return by_pin_[pin]; }
  /// Returns the used pins that have not been taken.
  std::vector<const PinEvidence*> left() const;
  /// Returns the pins that were not used in the runs: pins that the source uses, and pins with a name that
  /// have not been taken.
  std::vector<const PinEvidence*> never_used() const;
  /// Returns whether one of these functions receives the pin, or an array that contains it, as the first
  /// argument.
  bool is_given_to(std::initializer_list<const char*> functions, Pin pin) const;
  bool is_free(Pin pin) const { return pin != kNoPin && taken_.count(pin) == 0; }
  void take(Pin pin) { taken_.insert(pin); }

  /// Returns "5" or "\"A0\"", as in a robot file.
  std::string toml(Pin pin) const;
  /// Returns "ENA, follower.ino:3"; empty for a pin without a name.
  std::string where(Pin pin) const;

 private:
  const BoardSpec& board_;
  const SketchNames& names_;
  const PinHistory& history_;
  std::vector<PinEvidence> by_pin_;
  std::vector<PinFacts> facts_;  ///< per pin
  std::vector<Pin> order_;
  std::set<Pin> taken_;

  void add_names(const PinHistory& history);
  void add_source_words();
};

/// Returns whether the pin belongs to the serial line to the computer.
inline bool is_of_serial(const BoardSpec& board, Pin pin) { return pin < 2 && board.analog_pin_0 > 2; }

}  // namespace robosim::wiring
