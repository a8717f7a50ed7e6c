// Formats a JSON object in a readable layout: one member or list element per line, with a space after each
// comma and colon.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace robosim::cli {

class JsonLines {
 public:
  using Json = nlohmann::ordered_json;

  /// Adds a member in one line.
  void add(const char* key, const Json& value);
  void add_list(const char* key, const Json& array);
  /// Begins a member that is an object, with the members of `head` in one line. Until close(), new members
  /// are added to this object.
  void open(const char* key, const Json& head);
  void close();
  /// Returns the whole object, with a line feed at its end.
  std::string text() const;

 private:
  void begin(const char* key);
  std::string members_;
};

/// Returns a number that is printed without a needless fraction: 2.0 becomes "2".
nlohmann::ordered_json number(double value);

}  // namespace robosim::cli
