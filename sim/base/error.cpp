#include "sim/base/error.h"

#include "sim/base/terminal_text.h"

namespace robosim {

std::string to_string(const Place& place) {
  std::string text = in_one_line(place.file);
  if (place.line <= 0) return text;
  text += text.empty() ? "line " : ":";
  text += std::to_string(place.line);
  if (place.column > 0) text += ':' + std::to_string(place.column);
  return text;
}

namespace {
std::string sentence(const Place& place, const std::string& message) {
  const std::string where = to_string(place);
  return where.empty() ? message : where + ": " + message;
}
}  // namespace

InputError::InputError(Place place, const std::string& message)
    : std::runtime_error(sentence(place, message)), place_(std::move(place)), message_(message) {}

}  // namespace robosim
