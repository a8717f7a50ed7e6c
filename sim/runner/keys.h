// A JSON object's keys, read and checked.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace robosim::runner {

/// Each reader throws InputError for a value of the wrong kind.
class Keys {
 public:
  explicit Keys(const nlohmann::json& object) : object_(object) {}

  std::string text(const char* key, const std::string& fallback = "");
  std::string required_text(const char* key);
  std::int64_t whole(const char* key, std::int64_t fallback);
  std::uint64_t unsigned_whole(const char* key, std::uint64_t fallback);
  bool truth(const char* key, bool fallback);
  /// The value, or null; the key counts as known.
  const nlohmann::json* find(const char* key);
  /// Throws InputError if the object holds keys that nobody asked for.
  void finish() const;
  [[noreturn]] static void wrong(const char* key, const char* wanted);

 private:
  const nlohmann::json& object_;
  std::vector<std::string> known_;
};

}  // namespace robosim::runner
