#include "robosim/testing/events.h"

#include <fmt/format.h>

#include "sim/result/events.h"
#include "sim/testing/run_log.h"

namespace robosim::testing {

using Kind = Event::Kind;

std::string Event::clause() const {
  std::string text;
  for (const One& one : any_) text += (text.empty() ? "" : ", or ") + one.clause;
  return text;
}

Event serial_says(const std::string& text) {
  return Event({Kind::serial, text, true, {}, "the sketch says " + in_quotes(text)});
}
Event serial_matches(const std::string& regex) {
  return Event({Kind::line, regex, true, {}, "the sketch says a line that matches /" + regex + "/"});
}
Event tells(const std::string& part, const std::string& text) {
  return Event({Kind::note, part + ": \"" + text, true, {}, part + " tells " + in_quotes(text)});
}
Event visits(const std::string& station) {
  return Event({Kind::visited, station, true, {}, "the robot has visited station " + station});
}
Event visits(int station) { return visits(std::to_string(station)); }
Event is_at(const std::string& station) {
  return Event({Kind::at, station, true, {}, "the robot is at station " + station});
}
Event is_at(int station) { return is_at(std::to_string(station)); }
Event turns_on(const std::string& part) { return Event({Kind::reading, part, true, {}, part + " is on"}); }
Event turns_off(const std::string& part) { return Event({Kind::reading, part, false, {}, part + " is off"}); }
Event pin_goes_high(const std::string& pin) {
  return Event({Kind::pin, pin, true, {}, "pin " + pin + " is driven high"});
}
Event pin_goes_low(const std::string& pin) {
  return Event({Kind::pin, pin, false, {}, "pin " + pin + " is driven low"});
}
Event motors_start() { return Event({Kind::motors, "", true, {}, "a motor is driven"}); }
Event motors_stop() { return Event({Kind::motors, "", false, {}, "no motor is driven"}); }
Event stands_still(Duration time) {
  return Event({Kind::rest, "", true, time, "no wheel turns for " + seconds(time)});
}
Event collides() {
  return Event({Kind::event, result::CollisionBegan::kKind, true, {}, "the robot collides"});
}
Event ends(const std::string& verdict) {
  return Event({Kind::end, verdict, true, {}, "the run ends as " + in_quotes(verdict)});
}

}  // namespace robosim::testing
