// Hostile inputs as data: the names of a mechanism and a variant, and the files to write or the requests to
// send. No two inputs share both names.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace robosim::hostile {

/// Placeholders in texts. kSecretHere is the absolute path of a file that no input may read. kPortHere is a
/// port that no input may reach.
constexpr const char* kSecretHere = "@SECRET@";
constexpr const char* kPortHere = "@PORT@";
/// Content of the secret file and environment variable. Its appearance in any output is a finding.
constexpr const char* kSecret = "hunter2hunter2";
/// Prefix of a line that an input has forged.
constexpr const char* kForged = "FORGED";

enum class Kind { file, folder, link, hard_link, pipe, socket, device, sparse };

struct Entry {
  std::string path;     ///< below the sketch's folder, which is called S
  std::string content;  ///< text of a file ("\2TIMES\3TEXT\4" stands for a repeated text), target of a link,
                        ///< or number of zero bytes of a sparse file
  Kind kind = Kind::file;
};

enum class Target { both, host, avr };

struct Input {
  std::string mechanism, variant;
  std::vector<Entry> entries;
  Target target = Target::both;
  bool compiles = false;     ///< whether the input tests something only if the sketch compiles
  bool on_terminal = false;  ///< whether output goes to a terminal, including the serial text
};

inline std::ostream& operator<<(std::ostream& out, const Input& input) {
  return out << input.mechanism << "/" << input.variant;
}

/// Returns sketches that compile, and attack while they are loaded or run.
std::vector<Input> sketches();
/// Returns folders that attack every program that reads or compiles them.
std::vector<Input> folders();

struct HostileRequest {
  std::string mechanism, variant;
  std::vector<std::string> parts;  ///< sent one after the other, as fast as the server reads them
  bool stays_open = false;         ///< whether the client stays connected after its last byte
};

inline std::ostream& operator<<(std::ostream& out, const HostileRequest& request) {
  return out << request.mechanism << "/" << request.variant;
}

/// Returns hostile requests. `host` is the name and port that the server expects in the Host header.
std::vector<HostileRequest> requests(const std::string& host);

}  // namespace robosim::hostile
