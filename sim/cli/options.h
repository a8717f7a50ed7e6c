// The options of one command, and the values that several commands read.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace robosim::cli {

/// All options are read as text. The functions below check the allowed values afterwards, for uniform
/// messages.
class Options {
 public:
  Options(const std::string& command, const std::string& what);
  ~Options();

  void positional(const char* name, std::string& value, const char* what);
  void positionals(const char* name, std::vector<std::string>& values, const char* what);
  void text(const char* name, std::string& value, const char* meta, const char* what);
  /// Adds an option that may be repeated.
  void texts(const char* name, std::vector<std::string>& values, const char* meta, const char* what);
  /// Adds an option that may be repeated, each time with several words.
  void lists(const char* name, std::vector<std::string>& values, const char* meta, const char* what);
  void flag(const char* name, bool& value, const char* what);

  /// Returns the help text if it was requested. Throws InputError.
  std::optional<std::string> parse(std::vector<std::string> words);

 private:
  [[noreturn]] void refuse(const std::string& word) const;

  struct App;
  std::string command_;
  std::unique_ptr<App> app_;
};

/// For --profile.
constexpr const char* kProfiles =
    "ideal (no noise) or typical (default); typical@1 is typical as it was before version 2";
/// For --env.
constexpr const char* kEnvironment = "of platformio.ini, or a profile of sketch.yaml";

/// For --untrusted.
constexpr const char* kUntrusted = "somebody else's sketch: go on only where this machine can confine it";

constexpr std::uint64_t kMostSeed = std::numeric_limits<std::uint64_t>::max();

/// Throws "--seed: “x” is not possible; it must be `allowed`".
[[noreturn]] void refuse_value(const char* option, const std::string& value, const std::string& allowed);

/// These throw InputError.
std::int64_t simulated_time(const char* option, const std::string& text);
std::uint64_t whole_number(const char* option, const std::string& text, std::uint64_t least,
                           std::uint64_t most);
std::uint64_t seed_number(const std::string& text);
void check_choice(const char* option, const std::string& value, const std::vector<std::string>& allowed);
/// Checks --profile likewise.
void check_profile(const std::string& value);

}  // namespace robosim::cli
