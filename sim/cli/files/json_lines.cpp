#include "sim/cli/files/json_lines.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace robosim::cli {
namespace {

using Json = JsonLines::Json;

/// Formats JSON in one line. Invalid UTF-8 becomes U+FFFD.
std::string one_line(const Json& json) {
  if (!json.is_structured()) return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string text;
  for (const auto& [key, value] : json.items()) {
    if (!text.empty()) text += ", ";
    if (json.is_object()) text += one_line(key) + ": ";
    text += one_line(value);
  }
  return json.is_object() ? "{" + text + "}" : "[" + text + "]";
}

}  // namespace

void JsonLines::begin(const char* key) {
  if (!members_.empty()) members_ += ',';
  members_ += "\n  " + one_line(key) + ": ";
}

void JsonLines::add(const char* key, const Json& value) {
  begin(key);
  members_ += one_line(value);
}

void JsonLines::add_list(const char* key, const Json& array) {
  begin(key);
  members_ += '[';
  for (const char* separator = "\n    "; const Json& element : array) {
    members_ += separator + one_line(element);
    separator = ",\n    ";
  }
  members_ += array.empty() ? "]" : "\n  ]";
}

void JsonLines::open(const char* key, const Json& head) {
  begin(key);
  const std::string object = one_line(head);
  members_ += "{\n  " + object.substr(1, object.size() - 2);
}

void JsonLines::close() { members_ += "\n  }"; }

std::string JsonLines::text() const { return "{" + members_ + "\n}\n"; }

Json number(double value) {
  constexpr double kExact = 9007199254740992.0;  // 2^53: up to here, a double represents every integer
  if (value == std::floor(value) && std::abs(value) < kExact) return static_cast<std::int64_t>(value);
  return value;
}

}  // namespace robosim::cli
