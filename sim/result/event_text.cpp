// Converts the events of a run to sentences (events.h).
#include <fmt/format.h>

#include <cmath>

#include "sim/base/escaped.h"
#include "sim/result/events.h"

namespace robosim::result {
namespace {

std::string fault_text(const std::string& part, const std::vector<std::string>& arguments) {
  std::string text = part;
  for (const std::string& argument : arguments) text += " " + argument;
  return text;
}

/// Converts two cells, "2,3 9,3", to "2,3 to 9,3". A single cell stays unchanged.
std::string stretch(std::string cells) {
  const std::size_t space = cells.find(' ');
  return space == cells.npos ? cells : cells.replace(space, 1, " to ");
}

std::string light(const ScriptActed& e) {
  return (e.text == "all" ? "all lights " : "light " + e.text + " ") + e.part;
}

struct Text {
  std::string operator()(const StationVisited& e) const {
    return fmt::format("station {} visited", e.station);
  }
  std::string operator()(const LapDone& e) const { return fmt::format("lap {} in {:.2f} s", e.lap, e.lap_s); }
  std::string operator()(const CollisionBegan& e) const {
    return e.with_robot ? "collision with another robot"
                        : "collision with a wall, an obstacle or the map's edge";
  }
  std::string operator()(const ScriptActed& e) const {
    if (e.verb == "press") return e.part + " pressed";
    if (e.verb == "release") return e.part + " released";
    if (e.verb == "send")
      return e.part.empty() ? fmt::format("\"{}\" sent to the sketch", escaped(e.text))
                            : fmt::format("{} sent to {}", escaped(e.text), e.part);
    if (e.verb == "place") return "robot placed at " + e.text;
    if (e.verb == "lift") return "robot lifted";
    if (e.verb == "tilt") return "robot held up and tilted";
    if (e.verb == "sweep") return "robot moved back and forth manually";
    if (e.verb == "lower") return "robot put down";
    if (e.verb == "cover") return e.part + " covered";
    if (e.verb == "uncover") return e.part + " uncovered";
    if (e.verb == "paint") return "line painted, " + stretch(e.text);
    if (e.verb == "erase") return "line erased, " + stretch(e.text);
    if (e.verb == "door") return "door " + e.part + ", " + stretch(e.text);
    if (e.verb == "light") return light(e);
    if (e.verb == "restore" && e.part.empty()) return "floor restored, " + stretch(e.text);
    if (e.verb == "restore")
      return e.text.find(' ') == e.text.npos ? light(e) : "door " + e.part + ", " + stretch(e.text);
    if (e.verb == "obstacle") return "obstacle put on " + e.text;
    return "obstacle on " + e.text + " taken away";
  }
  std::string operator()(const FaultBegan& e) const {
    return "fault: " + fault_text(e.part, e.arguments) + (e.resets_chip ? ", which resets the chip" : "");
  }
  std::string operator()(const FaultEnded& e) const {
    return (e.repaired ? "fault: " : "fault over: ") + fault_text(e.part, e.arguments);
  }
  std::string operator()(const PowerLost& e) const {
    if (!e.byte) return "power off";
    return fmt::format("power cut while byte {} of the EEPROM was being written; it now contains 0x{:02X}",
                       e.byte->address, e.byte->value);
  }
  std::string operator()(const PowerBack&) const { return "power on"; }
  std::string operator()(const Scored& e) const {
    return fmt::format("{}: {:.10g} {}", e.what, std::round(e.value * 100.0) / 100.0, e.unit);
  }
  std::string operator()(const PartTold& e) const { return fmt::format("{}: \"{}\"", e.part, e.text); }
};

}  // namespace

const std::vector<std::string>& event_kinds() {
  static const std::vector<std::string> kinds = [] {
    const auto names = []<class... What>(const std::variant<What...>*) {
      return std::vector<std::string>{What::kKind...};
    };
    return names(static_cast<const RunEvent::What*>(nullptr));
  }();
  return kinds;
}

const char* kind_of(const RunEvent& event) {
  return std::visit([](const auto& what) { return what.kKind; }, event.what);
}

std::string text_of(const RunEvent& event) { return std::visit(Text{}, event.what); }

}  // namespace robosim::result
