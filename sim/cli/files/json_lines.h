// An object of JSON laid out for people, too: a member to a line, and of a list an element to a line, with a
// space behind each comma and colon.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace robosim::cli {

class JsonLines {
 public:
  using Json = nlohmann::ordered_json;

  /// In one line, whatever it is.
  void add(const char* key, const Json& value);
  void add_list(const char* key, const Json& array);
  /// Begins a member that is an object, with the members of `head` in one line; further ones go into it until
  /// close().
  void open(const char* key, const Json& head);
  void close();
  /// The whole object, with a line feed at its end.
  std::string text() const;

 private:
  void begin(const char* key);
  std::string members_;
};

/// As fmt writes it: 2.0 is "2".
nlohmann::ordered_json number(double value);

}  // namespace robosim::cli
