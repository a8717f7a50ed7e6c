// Formats the values of an event, for tests that do not depend on the wording of a message.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/result/events.h"

namespace robosim::test {

/// Writes fields as " KEY=VALUE", and skips empty fields, false and 0.
class ValueWriter {
 public:
  static constexpr bool kReads = false;
  static constexpr bool kDescribes = false;

  template <class T>
  void operator()(const char* key, const T& value, const char*, const result::Rules& = {}) {
    const std::string shown = shown_as(value);
    if (!shown.empty() && shown != "0") text += std::string(" ") + key + "=" + shown;
  }
  std::string text;

 private:
  static std::string shown_as(const std::string& value) { return value; }
  static std::string shown_as(const std::vector<std::string>& values) {
    std::string all;
    for (const std::string& value : values) all += (all.empty() ? "" : ",") + value;
    return all;
  }
  /// Returns the values rounded to integers, or "" if all are 0.
  template <std::size_t N>
  static std::string shown_as(const std::array<double, N>& values) {
    std::string all;
    for (const double value : values) all += (all.empty() ? "" : ",") + std::to_string(std::lround(value));
    return all.find_first_not_of("0,") == all.npos ? "" : all;
  }
  template <class T>
  static std::string shown_as(const std::optional<T>& value) {
    return value ? shown_as(*value) : "";
  }
  template <class T>
  static std::string shown_as(const T& value) {
    if constexpr (std::is_arithmetic_v<T>) {
      return std::to_string(value);
    } else {
      ValueWriter inner;
      fields(inner, value);
      return "(" + inner.text + ")";
    }
  }
};

/// Returns "101 fault_began part=S1 arguments=stuck,1023": the millisecond, the kind and the values.
inline std::string values_of(const result::RunEvent& event) {
  ValueWriter values;
  std::visit([&](const auto& what) { fields(values, what); }, event.what);
  return std::to_string(event.t_ns / kMillisecond) + ' ' + result::kind_of(event) + values.text;
}

}  // namespace robosim::test
