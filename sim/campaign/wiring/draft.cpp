#include "sim/campaign/wiring/draft.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/terminal_text.h"

namespace robosim::wiring {
namespace {

constexpr std::size_t kColumn = 36;  // where comments after values begin

std::string line(const std::string& text, const std::string& comment) {
  return comment.empty() ? text + '\n' : fmt::format("{:<{}}# {}\n", text, kColumn, in_one_line(comment));
}

std::string text_of(const PartDraft& part) {
  std::string text = "\n[[part]]\n" + line(fmt::format("name = \"{}\"", part.name), part.why);
  text += fmt::format("type = \"{}\"\n", part.type);
  for (const auto& [key, value] : part.keys) text += fmt::format("{} = {}\n", key, value);
  for (const std::string& note : part.notes) text += "# " + in_one_line(note) + '\n';
  for (const std::string& doubt : part.doubts) text += "# ? " + in_one_line(doubt) + '\n';
  return text;
}

std::ptrdiff_t lines_of(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

bool has_motors(const RobotDraft& draft) {
  for (const PartDraft& part : draft.parts)
    if (part.type == "motor" || part.type == "wheel-servo") return true;
  return false;
}

}  // namespace

/// Returns the motor drivers that the same pins could belong to: "l293d, tb6612, …".
std::string other_drivers(const std::string& chosen) {
  std::string text;
  for (const char* driver : {"l298n", "l293d", "tb6612", "drv8833", "drv8835", "transistor"})
    if (driver != chosen) text += (text.empty() ? "" : ", ") + std::string(driver);
  return text;
}

std::string text_of(const RobotDraft& draft, const std::vector<std::string>& remarks) {
  std::string text;
  for (const std::string& remark : remarks) text += "# " + in_one_line(remark) + '\n';
  for (const std::string& note : draft.notes) text += "# " + in_one_line(note) + '\n';
  const char* const kit =
      draft.base == "uno5" ? "micro metal gear motors, wheels of 32 mm" : "yellow TT motors, wheels of 65 mm";
  text += line(fmt::format("base = \"{}\"", draft.base),
               fmt::format("? the chassis, motors and battery of the base: {}", kit));
  text += line("remove = \"all\"", "parts of the base; this robot's parts follow");
  text += line(fmt::format("board = \"{}\"", draft.board),
               draft.board_doubt.empty() ? "" : "? " + draft.board_doubt);
  text +=
      "\n# ? These determine how the robot drives: measure them, and remove the #.\n"
      "# [chassis]\n# track = \"… mm\"   # between the wheels\n# wheel = \"… mm\"   # diameter\n";
  if (has_motors(draft)) {
    text += "\n[driver]\n";
    text += line(fmt::format("chip = \"{}\"", draft.driver),
                 draft.driver == "servo" ? "" : "? or " + other_drivers(draft.driver));
    if (!draft.standby.empty()) text += fmt::format("standby = {}\n", draft.standby);
    if (!draft.supply.empty())
      text += "\n[motors]\n" + line("supply = " + draft.supply, "? voltage of the motors");
  }
  for (const PartDraft& part : draft.parts) text += text_of(part);
  if (!draft.questions.empty()) text += "\n# No part was found for:\n";
  for (const std::string& question : draft.questions) text += "# ? " + in_one_line(question) + '\n';
  return text;
}

std::string text_of(const Ways& ways) {
  std::string text;
  for (const Way& way : kWays)
    if (ways.*way.is) text += fmt::format("{}{}", text.empty() ? "" : ", ", way.words);
  return text.empty() ? "as guessed first" : text;
}

bool remove_refused(RobotDraft& draft, int line, const std::string& message) {
  RobotDraft without_questions = draft;
  without_questions.questions.clear();
  auto lines_before = lines_of(text_of(without_questions));
  for (std::size_t i = draft.parts.size(); i-- > 0;) {
    const PartDraft part = draft.parts[i];
    lines_before -= lines_of(text_of(part));
    if (line <= lines_before) continue;
    draft.parts.erase(draft.parts.begin() + static_cast<std::ptrdiff_t>(i));
    draft.questions.push_back(fmt::format("how is {} wired ({}{}{})? As drafted, it is refused: {}",
                                          part.name, part.type, part.why.empty() ? "" : ": ", part.why,
                                          message));
    return true;
  }
  if (draft.parts.empty() && draft.standby.empty()) return false;
  draft.questions.push_back("the draft was refused: " + message);
  if (draft.standby.empty())
    draft.parts.clear();
  else
    draft.standby.clear();
  return true;
}

std::string presses(const RobotDraft& draft) {
  std::string text;
  for (const PartDraft& part : draft.parts) {
    if (part.type != "button") continue;
    text += fmt::format("at 300ms press \"{0}\" 200ms\nat 2500ms press \"{0}\" 200ms\n", part.name);
  }
  return text;
}

}  // namespace robosim::wiring
