#include "sim/cli/check/promises.h"

#include <fmt/format.h>

#include <utility>

namespace robosim::cli {
namespace {

constexpr std::pair<const char*, Promise::When> kKeys[] = {{"never", Promise::When::never},
                                                           {"sometimes", Promise::When::sometimes},
                                                           {"always", Promise::When::always}};
constexpr const char* kSerial = "serial: ";
constexpr const char* kShows = "shows: ";

Promise promise_of(const ConfigValue& value, const char* key, Promise::When when) {
  const std::string& text = as_string(value, key);
  for (const auto& [begin, shown] : {std::pair{std::string(kSerial), false}, {std::string(kShows), true}})
    if (text.starts_with(begin) && text.size() > begin.size())
      return {when, shown, text.substr(begin.size())};
  throw InputError(value.place,
                   fmt::format("{}: expected \"serial: TEXT\" or \"shows: TEXT\", got “{}”", key, text));
}

}  // namespace

bool Promise::is_in(const wire::RunResult& result) const {
  return (shown ? result.shown : result.serial).find(words) != std::string::npos;
}

std::string Promise::text() const { return (shown ? kShows : kSerial) + words; }

std::vector<Promise> read_promises(TableReader& file) {
  std::vector<Promise> promises;
  for (const auto& [key, when] : kKeys) {
    const ConfigValue* const value = file.find(key);
    if (!value) continue;
    if (value->kind != ConfigValue::Kind::array)
      promises.push_back(promise_of(*value, key, when));
    else
      for (const ConfigValue& item : value->items) promises.push_back(promise_of(item, key, when));
  }
  return promises;
}

std::string why_broken(const Promise& promise, const wire::RunResult& result) {
  const char* const did = promise.shown ? "showed" : "sent";
  if (promise.when == Promise::When::never && promise.is_in(result))
    return fmt::format("the sketch {} “{}”, which it must never do", did, promise.words);
  if (promise.when == Promise::When::always && !promise.is_in(result))
    return fmt::format("the sketch has not {} “{}”, which it must always do",
                       promise.shown ? "shown" : "sent", promise.words);
  return "";
}

}  // namespace robosim::cli
