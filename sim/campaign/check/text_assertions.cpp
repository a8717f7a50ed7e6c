#include "sim/campaign/check/text_assertions.h"

#include <fmt/format.h>

#include <utility>

namespace robosim::campaign {
namespace {

constexpr std::pair<const char*, TextAssertion::When> kKeys[] = {
    {"never", TextAssertion::When::never},
    {"sometimes", TextAssertion::When::sometimes},
    {"always", TextAssertion::When::always}};
constexpr const char* kSerial = "serial: ";
constexpr const char* kShows = "shows: ";

TextAssertion promise_of(const ConfigValue& value, const char* key, TextAssertion::When when) {
  const std::string& text = as_string(value, key);
  for (const auto& [begin, shown] : {std::pair{std::string(kSerial), false}, {std::string(kShows), true}})
    if (text.starts_with(begin) && text.size() > begin.size())
      return {when, shown, text.substr(begin.size())};
  throw InputError(value.place,
                   fmt::format("{}: expected \"serial: TEXT\" or \"shows: TEXT\", got “{}”", key, text));
}

}  // namespace

bool TextAssertion::is_in(const result::RunResult& result) const {
  return (shown ? result.shown : result.serial).find(words) != std::string::npos;
}

std::string TextAssertion::text() const { return (shown ? kShows : kSerial) + words; }

std::vector<TextAssertion> read_text_assertions(TableReader& file) {
  std::vector<TextAssertion> assertions;
  for (const auto& [key, when] : kKeys) {
    const ConfigValue* const value = file.find(key);
    if (!value) continue;
    if (value->kind != ConfigValue::Kind::array)
      assertions.push_back(promise_of(*value, key, when));
    else
      for (const ConfigValue& item : value->items) assertions.push_back(promise_of(item, key, when));
  }
  return assertions;
}

std::string why_broken(const TextAssertion& assertion, const result::RunResult& result) {
  const char* const did = assertion.shown ? "showed" : "sent";
  if (assertion.when == TextAssertion::When::never && assertion.is_in(result))
    return fmt::format("the sketch {} “{}”, which it must never do", did, assertion.words);
  if (assertion.when == TextAssertion::When::always && !assertion.is_in(result))
    return fmt::format("the sketch has not {} “{}”, which it must always do",
                       assertion.shown ? "shown" : "sent", assertion.words);
  return "";
}

}  // namespace robosim::campaign
