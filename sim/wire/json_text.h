// Writes the JSON text of messages directly from their fields (fields.h). The result equals
// text_of(to_json(message)) (json_writer.h) to the last character, with a sixth of the instructions. Include
// only in .cpp files.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "sim/wire/json_writer.h"

namespace robosim::wire {

class JsonText {
 public:
  static constexpr bool kReads = false;
  static constexpr bool kDescribes = false;

  /// Appends a value to `out`.
  template <class T>
  static void append(std::string& out, const T& value) {
    if constexpr (Described<JsonText, T>) {
      JsonText object(out);
      fields(object, value);
      object.end();
    } else if constexpr (std::is_same_v<T, char>) {
      append(out, std::string_view(&value, 1));
    } else if constexpr (detail::IsVector<T>::value) {
      list(out, [&](auto&& add) {
        for (const auto& element : value) add(element);
      });
    } else if constexpr (detail::IsNameList<T>::value) {
      list(out, [&](auto&& add) {
        for (const auto& name : value.names)
          if (*name.holds) add(std::string_view(name.name));
      });
    } else if constexpr (detail::IsPinsByUse<T>::value) {
      out += text_of(JsonWriter<OrderedJson>::json(value));
    } else if constexpr (detail::Tuple<T>) {
      list(out, [&](auto&& add) { std::apply([&](const auto&... element) { (add(element), ...); }, value); });
    } else if constexpr (std::is_same_v<T, bool>) {
      out += value ? "true" : "false";
    } else if constexpr (std::is_integral_v<T>) {
      std::array<char, 24> digits;
      out.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
    } else if constexpr (std::is_floating_point_v<T>) {
      append_number(out, value);
    } else {
      append_string(out, value);
    }
  }

  /// Begins an object in `out`; end() completes it.
  explicit JsonText(std::string& out) : out_(out) { out_ += '{'; }
  void end() { out_ += '}'; }

  template <class T>
  void operator()(const char* key, T&& value, const char*, const Rules& rules = {}) {
    using Value = std::remove_cvref_t<T>;
    if (!rules.presence.written) return;
    if constexpr (detail::IsOptional<Value>::value) {
      if (value) add(key, *value);
    } else {
      add(key, value);
    }
  }

  template <class Kind, class T>
  void choice(Kind kind, Kind own, const char* key, const T& value, const char* meaning,
              const Rules& rules = {}) {
    if (kind == own) (*this)(key, value, meaning, rules);
  }

  template <class What>
  void kinds(const char* key, const std::optional<What>& what, const char*) {
    if (!what) return;
    std::visit(
        [&](const auto& one) {
          add(key, std::string_view(one.kKind));
          fields(*this, one);
        },
        *what);
  }

  template <class T>
  void add(std::string_view key, const T& value) {
    add_key(key);
    append(out_, value);
  }
  /// Adds a key whose value `text` is JSON.
  void add_text(std::string_view key, std::string_view text) {
    add_key(key);
    out_ += text;
  }

 private:
  template <class Fill>
  static void list(std::string& out, Fill fill) {
    out += '[';
    bool first = true;
    fill([&](const auto& element) {
      if (!first) out += ',';
      first = false;
      append(out, element);
    });
    out += ']';
  }

  static void append_number(std::string& out, double value) {
    if (!std::isfinite(value)) {
      out += "null";
      return;
    }
    std::array<char, 64> digits;
    out.append(digits.data(),
               nlohmann::detail::to_chars(digits.data(), digits.data() + digits.size(), value));
  }

  static bool is_plain(char c) { return c >= ' ' && c < '\x7F' && c != '"' && c != '\\'; }

  static void append_string(std::string& out, std::string_view text) {
    if (!std::all_of(text.begin(), text.end(), is_plain)) {
      out += text_of(OrderedJson(text));
      return;
    }
    out += '"';
    out += text;
    out += '"';
  }

  void add_key(std::string_view key) {
    if (out_.back() != '{') out_ += ',';
    append_string(out_, key);
    out_ += ':';
  }

  std::string& out_;
};

}  // namespace robosim::wire
