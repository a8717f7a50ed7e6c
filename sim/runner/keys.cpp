#include "sim/runner/keys.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/error.h"

namespace robosim::runner {

using nlohmann::json;

std::string Keys::text(const char* key, const std::string& fallback) {
  const json* value = find(key);
  if (!value) return fallback;
  if (!value->is_string()) wrong(key, "a string");
  return value->get<std::string>();
}

std::string Keys::required_text(const char* key) {
  std::string value = text(key);
  if (value.empty()) throw InputError(fmt::format("the request lacks the key \"{}\"", key));
  return value;
}

std::int64_t Keys::whole(const char* key, std::int64_t fallback) {
  const json* value = find(key);
  if (!value) return fallback;
  if (!value->is_number_integer() || value->get<std::int64_t>() < 0) wrong(key, "a whole number from 0");
  return value->get<std::int64_t>();
}

std::uint64_t Keys::unsigned_whole(const char* key, std::uint64_t fallback) {
  const json* value = find(key);
  if (!value) return fallback;
  if (!value->is_number_unsigned()) wrong(key, "a whole number from 0");
  return value->get<std::uint64_t>();
}

bool Keys::truth(const char* key, bool fallback) {
  const json* value = find(key);
  if (!value) return fallback;
  if (!value->is_boolean()) wrong(key, "true or false");
  return value->get<bool>();
}

const json* Keys::find(const char* key) {
  known_.emplace_back(key);
  const auto it = object_.find(key);
  return it == object_.end() ? nullptr : &*it;
}

void Keys::finish() const {
  for (const auto& [key, value] : object_.items())
    if (std::find(known_.begin(), known_.end(), key) == known_.end())
      throw InputError(fmt::format("unknown key \"{}\" in the request; known are {}", key, one_of(known_)));
}

void Keys::wrong(const char* key, const char* wanted) {
  throw InputError(fmt::format("\"{}\" in the request must be {}", key, wanted));
}

}  // namespace robosim::runner
