// Reads messages from JSON by their fields (fields.h), with checks. Include only in .cpp files: nlohmann's
// header is slow to compile.
//
// Input may be hostile. The reader ignores values that fields() does not describe, so deep nesting does no
// harm. The reader reports a number out of range, a missing key, or a value of the wrong type in one
// sentence.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "sim/base/error.h"
#include "sim/wire/json_writer.h"

namespace robosim::wire {

/// Reports that a value does not match its key's description.
class BadValue : public std::runtime_error {
 public:
  BadValue(std::string key, std::string problem)
      : std::runtime_error("\"" + key + "\": " + problem),
        key_(std::move(key)),
        problem_(std::move(problem)) {}
  /// Returns the error for the value inside `outer`: "calls" and "[2].line" make "calls[2].line".
  BadValue inside(const std::string& outer) const {
    return {outer + (key_.empty() || key_[0] == '[' ? "" : ".") + key_, problem_};
  }
  /// Returns "\"seed\" in the request: expected a whole number from 0".
  std::string in(const std::string& message) const {
    return "\"" + key_ + "\" in " + message + ": " + problem_;
  }

 private:
  std::string key_, problem_;
};

/// Returns the beginning of a text, for use in a message: “GET / HTTP/1.1”.
std::string excerpt(std::string_view text);

class JsonReader {
 public:
  using Json = nlohmann::json;
  static constexpr bool kReads = true;
  static constexpr bool kDescribes = false;

  /// Selects whether keys without a description are an error.
  enum class Unknown { allowed, refused };

  /// Reads a message. Throws BadValue. `besides` lists keys of the same object that other code has read.
  template <class T>
  static void read(const Json& object, T& message, Unknown unknown,
                   std::initializer_list<const char*> besides = {}) {
    if (!object.is_object()) throw BadValue("", "expected an object");
    JsonReader reader(object, unknown);
    for (const char* key : besides) reader.known_.push_back(key);
    fields(reader, message);
    reader.finish();
  }

  template <class T>
  void operator()(const char* key, T&& value, const char*, const Rules& rules = {}) {
    using Value = std::remove_cvref_t<T>;
    const Json* found = find(key);
    if constexpr (detail::IsOptional<Value>::value) {
      if (found && !found->is_null()) take(key, *found, *(value = typename Value::value_type{}), rules);
    } else if (found) {
      take(key, *found, value, rules);
    } else if (rules.presence.required) {
      throw BadValue(key, "missing key; expected " + allowed<Value>(rules));
    }
  }

  template <class Kind, class T>
  void choice(Kind& kind, Kind own, const char* key, T& value, const char*, const Rules& rules = {}) {
    choices_.push_back(key);
    const Json* found = find(key);
    if (!found) return;
    ++chosen_;
    kind = own;
    take(key, *found, value, rules);
  }

  /// Reads the kind and its keys. Leaves `what` empty for an unknown kind.
  template <class... What>
  void kinds(const char* key, std::optional<std::variant<What...>>& what, const char*) {
    const Json* kind = find(key);
    const auto try_one = [&]<class T>(const T*) {
      if (kind && *kind == T::kKind) fields(*this, std::get<T>(what.emplace(T{})));
    };
    (try_one(static_cast<const What*>(nullptr)), ...);
  }

 private:
  JsonReader(const Json& object, Unknown unknown) : object_(object), unknown_(unknown) {}

  const Json* find(const char* key) {
    if (unknown_ == Unknown::refused) known_.push_back(key);
    const auto found = object_.find(key);
    return found == object_.end() ? nullptr : &*found;
  }

  /// Throws BadValue for unknown keys. If choice() was called, requires exactly one of its keys.
  void finish() const;

  template <class T>
  void take(const std::string& key, const Json& json, T& value, const Rules& rules) const {
    try {
      set(value, json, rules);
    } catch (const BadValue& bad) {
      throw bad.inside(key);
    }
  }

  template <class T>
  void set(T& value, const Json& json, const Rules& rules) const;
  template <class T>
  void set_number(T& value, const Json& json, const Rules& rules) const;
  template <class T>
  void set_list(T& value, const Json& json, const Rules& rules) const;

  template <class T>
  static std::string allowed(const Rules& rules);
  template <class T>
  [[noreturn]] static void refuse(const Rules& rules) {
    throw BadValue("", "expected " + allowed<T>(rules));
  }

  const Json& object_;
  Unknown unknown_;
  std::vector<const char*> known_, choices_;
  int chosen_ = 0;
};

namespace detail {

/// Returns the lower limit of an integer: the stricter of T's and the rules' limits.
template <class T>
std::int64_t least(const Rules& rules) {
  return std::is_unsigned_v<T>
             ? std::max<std::int64_t>(rules.least, 0)
             : std::max(rules.least, static_cast<std::int64_t>(std::numeric_limits<T>::min()));
}
template <class T>
std::uint64_t most(const Rules& rules) {
  constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<T>::max());
  if (rules.most == std::numeric_limits<std::int64_t>::max()) return kMost;
  return std::min(kMost, static_cast<std::uint64_t>(rules.most));
}

/// Returns "a whole number from 0 to 65535".
std::string whole_number(const Rules& rules, std::int64_t least, std::uint64_t most);
std::string text(const Rules& rules);
/// Returns "\"a\", \"b\" and \"c\"".
std::string all_of(const std::vector<const char*>& names);

}  // namespace detail

template <class T>
std::string JsonReader::allowed(const Rules& rules) {
  if constexpr (std::is_same_v<T, bool>) {
    return "true or false";
  } else if constexpr (std::is_same_v<T, char>) {
    return "one character";
  } else if constexpr (std::is_integral_v<T>) {
    return detail::whole_number(rules, detail::least<T>(rules), detail::most<T>(rules));
  } else if constexpr (std::is_floating_point_v<T>) {
    return "a number";
  } else if constexpr (std::is_same_v<T, std::string>) {
    return detail::text(rules);
  } else if constexpr (detail::IsVector<T>::value || detail::IsNameList<T>::value) {
    return "an array";
  } else if constexpr (detail::Tuple<T>) {
    return "an array of " + std::to_string(std::tuple_size_v<T>);
  } else {
    return "an object";
  }
}

template <class T>
void JsonReader::set_number(T& value, const Json& json, const Rules& rules) const {
  if (!json.is_number_integer()) refuse<T>(rules);
  if (json.is_number_unsigned()) {
    const auto number = json.get<std::uint64_t>();
    const std::int64_t least = detail::least<T>(rules);
    if (number > detail::most<T>(rules) || (least > 0 && number < static_cast<std::uint64_t>(least)))
      refuse<T>(rules);
  } else if (json.get<std::int64_t>() < detail::least<T>(rules)) {
    refuse<T>(rules);
  }
  value = json.get<T>();
  if (rules.multiple_of != 1 && value % static_cast<T>(rules.multiple_of) != 0) refuse<T>(rules);
}

template <class T>
void JsonReader::set_list(T& value, const Json& json, const Rules& rules) const {
  if (!json.is_array()) refuse<T>(rules);
  std::size_t i = 0;
  const auto next = [&](auto& element) {
    std::string key(1, '[');
    key.append(std::to_string(i)).append(1, ']');
    take(key, json[i], element, rules);
    ++i;
  };
  if constexpr (detail::IsVector<T>::value) {
    value.assign(json.size(), {});
    for (auto& element : value) next(element);
  } else {
    if (json.size() != std::tuple_size_v<T>) refuse<T>(rules);
    std::apply([&](auto&... element) { (next(element), ...); }, value);
  }
}

template <class T>
void JsonReader::set(T& value, const Json& json, const Rules& rules) const {
  if constexpr (Described<JsonReader, T>) {
    read(json, value, unknown_);
  } else if constexpr (std::is_same_v<T, bool>) {
    if (!json.is_boolean()) refuse<T>(rules);
    value = json.get<bool>();
  } else if constexpr (std::is_same_v<T, char>) {
    if (!json.is_string() || json.get_ref<const std::string&>().size() != 1) refuse<T>(rules);
    value = json.get_ref<const std::string&>()[0];
  } else if constexpr (std::is_integral_v<T>) {
    set_number(value, json, rules);
  } else if constexpr (std::is_floating_point_v<T>) {
    if (!json.is_number()) refuse<T>(rules);
    value = json.get<T>();
  } else if constexpr (std::is_same_v<T, std::string>) {
    if (!json.is_string()) refuse<T>(rules);
    const auto& text = json.get_ref<const std::string&>();
    const bool known =
        rules.one_of.size() == 0 || std::any_of(rules.one_of.begin(), rules.one_of.end(),
                                                [&](const char* allowed) { return text == allowed; });
    if (!known || (rules.not_empty && text.empty())) refuse<T>(rules);
    value = text;
  } else if constexpr (detail::IsNameList<T>::value) {
    std::vector<const char*> names;
    for (const auto& name : value.names) names.push_back(name.name);
    const auto wrong = [&] { throw BadValue("", "expected an array of " + detail::all_of(names)); };
    if (!json.is_array()) wrong();
    for (const Json& name : json) {
      bool found = false;
      for (const auto& known : value.names) {
        if (name == known.name) *known.holds = found = true;
      }
      if (!found) wrong();
    }
  } else if constexpr (detail::IsPinsByUse<T>::value) {
    if (!json.is_object()) refuse<T>(rules);
    for (const auto& [use, pin] : json.items()) {
      if (pin.is_number_integer())
        value.list.emplace_back(use, pin.dump());
      else if (pin.is_string())
        value.list.emplace_back(use, pin.template get<std::string>());
      else
        throw BadValue(use, "expected a number or a string");
    }
  } else {
    set_list(value, json, rules);
  }
}

}  // namespace robosim::wire
