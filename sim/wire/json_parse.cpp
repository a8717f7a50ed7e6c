#include "sim/wire/json_parse.h"

#include <charconv>
#include <cstdint>
#include <string>
#include <utility>

#include "sim/base/json_limits.h"
#include "sim/base/leading_number.h"

namespace robosim::wire {
namespace {

using Json = nlohmann::json;

// Parses only the subset that the protocol's programs write: strings of printable ASCII without escapes; no
// spaces; no deep nesting. Gives up on everything else, valid or not.
class PlainJson {
 public:
  explicit PlainJson(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

  bool read_all(Json& value) {
    while (end_ > at_ && end_[-1] == '\n') --end_;
    return read(value, 0) && at_ == end_;
  }

 private:
  static constexpr int kDeepest = 16;

  bool take(char c) {
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }
  bool take(std::string_view word) {
    if (static_cast<std::size_t>(end_ - at_) < word.size() || std::string_view(at_, word.size()) != word)
      return false;
    at_ += word.size();
    return true;
  }

  bool read(Json& value, int depth) {
    if (at_ == end_ || depth > kDeepest) return false;
    switch (*at_) {
      case '{':
        return read_object(value, depth);
      case '[':
        return read_array(value, depth);
      case '"':
        value = std::string();
        return read_string(value.get_ref<std::string&>());
      case 't':
        value = true;
        return take("true");
      case 'f':
        value = false;
        return take("false");
      case 'n':
        value = nullptr;
        return take("null");
      default:
        return read_number(value);
    }
  }

  bool read_object(Json& value, int depth) {
    value = Json::object();
    auto& members = value.get_ref<Json::object_t&>();
    take('{');
    if (take('}')) return true;
    std::string key;
    do {
      if (!take('"')) return false;
      --at_;
      if (!read_string(key) || !take(':') || !read(members[std::move(key)], depth + 1)) return false;
    } while (take(','));
    return take('}');
  }

  bool read_array(Json& value, int depth) {
    value = Json::array();
    auto& elements = value.get_ref<Json::array_t&>();
    take('[');
    if (take(']')) return true;
    do {
      if (!read(elements.emplace_back(), depth + 1)) return false;
    } while (take(','));
    return take(']');
  }

  bool read_string(std::string& text) {
    const char* const begin = ++at_;
    while (at_ != end_ && *at_ != '"') {
      if (*at_ < ' ' || *at_ > '~' || *at_ == '\\') return false;
      ++at_;
    }
    text.assign(begin, at_);
    return take('"');
  }

  static bool is_digit(char c) { return c >= '0' && c <= '9'; }

  /// Skips digits; at least one is required.
  bool pass_digits(const char*& p) const {
    const char* const first = p;
    while (p != end_ && is_digit(*p)) ++p;
    return p != first;
  }

  // Leaves -0 and 007 to nlohmann's parser.
  bool read_number(Json& value) {
    const char* last = at_;
    const bool negative = *last == '-';
    if (negative) ++last;
    const char* const first = last;
    if (!pass_digits(last) || (*first == '0' && last - first > 1)) return false;
    if (last == end_ || (*last != '.' && *last != 'e' && *last != 'E')) {
      if (!negative) return read_as<std::uint64_t>(value, last);
      return *first != '0' && read_as<std::int64_t>(value, last);
    }
    if (*last == '.' && !pass_digits(++last)) return false;
    if (last != end_ && (*last == 'e' || *last == 'E')) {
      ++last;
      if (last != end_ && (*last == '+' || *last == '-')) ++last;
      if (!pass_digits(last)) return false;
    }
    const auto number = leading_number({at_, static_cast<std::size_t>(last - at_)});
    if (!number || number->length != static_cast<std::size_t>(last - at_)) return false;
    at_ = last;
    value = number->value;
    return true;
  }

  template <class Whole>
  bool read_as(Json& value, const char* last) {
    Whole number{};
    const auto [end, error] = std::from_chars(at_, last, number);
    if (error != std::errc() || end != last) return false;
    at_ = end;
    value = number;
    return true;
  }

  const char* at_;
  const char* end_;
};

}  // namespace

Json parsed_json(std::string_view text) {
  Json value;
  // A text of up to kMostJsonValues bytes cannot have too many values. It may be nested too deeply, but
  // PlainJson rejects deep nesting.
  const bool may_be_too_much = text.size() > kMostJsonValues;
  if (may_be_too_much && !is_within_json_limits(text)) return Json(Json::value_t::discarded);
  if (PlainJson(text).read_all(value)) return value;
  if (!may_be_too_much && !is_within_json_limits(text)) return Json(Json::value_t::discarded);
  return Json::parse(text, nullptr, false);
}

}  // namespace robosim::wire
