// Converts messages to JSON by their fields (fields.h). Include only in .cpp files: nlohmann's header is slow
// to compile.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "sim/result/fields.h"

namespace robosim::wire {
using namespace result;  // the values that messages carry

/// JSON that keeps keys in the order in which fields() describes them.
using OrderedJson = nlohmann::ordered_json;

namespace detail {

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsNameList : std::false_type {};
template <class Bool, std::size_t N>
struct IsNameList<NameList<Bool, N>> : std::true_type {};
template <class T>
struct IsPinsByUse : std::false_type {};
template <class List>
struct IsPinsByUse<PinsByUse<List>> : std::true_type {};
/// Pairs, tuples and arrays become arrays of a fixed length.
template <class T>
concept Tuple = requires {
  std::tuple_size<T>::value;
};

}  // namespace detail

/// Writes a message. `Json` determines the order of keys.
template <class Json>
class JsonWriter {
 public:
  static constexpr bool kReads = false;
  static constexpr bool kDescribes = false;

  template <class T>
  void operator()(const char* key, T&& value, const char*, const Rules& rules = {}) {
    using Value = std::remove_cvref_t<T>;
    if (!rules.presence.written) return;
    if constexpr (detail::IsOptional<Value>::value) {
      if (value) object_[key] = json(*value);
    } else {
      object_[key] = json(value);
    }
  }

  template <class Kind, class T>
  void choice(Kind kind, Kind own, const char* key, const T& value, const char* meaning,
              const Rules& rules = {}) {
    if (kind == own) (*this)(key, value, meaning, rules);
  }

  /// Writes the alternative's name under `key`, followed by its keys.
  template <class What>
  void kinds(const char* key, const std::optional<What>& what, const char*) {
    if (!what) return;
    std::visit(
        [&](const auto& one) {
          object_[key] = one.kKind;
          fields(*this, one);
        },
        *what);
  }

  /// Adds a message's keys to an object.
  template <class T>
  static void add(Json& object, const T& message) {
    JsonWriter writer(object);
    fields(writer, message);
  }

  template <class T>
  static Json json(const T& value) {
    if constexpr (Described<JsonWriter, T>) {
      Json object = Json::object();
      add(object, value);
      return object;
    } else if constexpr (std::is_same_v<T, char>) {
      return std::string(1, value);
    } else if constexpr (detail::IsVector<T>::value) {
      Json array = Json::array();
      for (const auto& element : value) array.push_back(json(element));
      return array;
    } else if constexpr (detail::IsNameList<T>::value) {
      Json array = Json::array();
      for (const auto& name : value.names)
        if (*name.holds) array.push_back(name.name);
      return array;
    } else if constexpr (detail::IsPinsByUse<T>::value) {
      Json object = Json::object();
      for (const auto& [use, pin] : value.list) {
        const bool number = !pin.empty() && pin.find_first_not_of("0123456789") == std::string::npos;
        object[use] = number && pin.size() < 10 ? Json(std::stoi(pin)) : Json(pin);
      }
      return object;
    } else if constexpr (detail::Tuple<T>) {
      Json array = Json::array();
      std::apply([&](const auto&... element) { (array.push_back(json(element)), ...); }, value);
      return array;
    } else {
      return value;
    }
  }

 private:
  explicit JsonWriter(Json& object) : object_(object) {}

  Json& object_;
};

template <class T>
OrderedJson to_json(const T& message) {
  return JsonWriter<OrderedJson>::json(message);
}

/// Returns JSON as text. File names, scripts and output of sketches may contain any bytes, unlike JSON:
/// invalid bytes become U+FFFD.
template <class Json>
std::string text_of(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace robosim::wire
