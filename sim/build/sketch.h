// Builds a sketch folder by Arduino's rules (docs/reference/sketches.md). The result is an image, which a
// runner loads, or the user flashes to a chip.
//
//   const Image image = build({find_sketch("PidFollower"), *find_board("uno")});
//
// Results are cached by content: a second build of the same files starts no process.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/base/error.h"
#include "sim/build/project_rules.h"

namespace robosim::build {

/// The levels of compiler warnings in Arduino's preferences. `standard` is Arduino's default, plus warnings
/// about typical mistakes of beginners: `if (x = 1)`, `if (400 < x < 600)` and `if (x);`. See
/// warning_filter.h.
enum class Warnings { none, standard, more, all };

struct Request {
  std::filesystem::path
      sketch;  ///< a sketch folder, its .ino, or a single .cpp that includes Arduino.h itself
  const BoardSpec& board;
  std::string target = "host";  ///< "host", "avr" or "stm32"
  std::vector<std::filesystem::path>
      libraries;  ///< folders of libraries, or single libraries; searched in this order
  Warnings warnings = Warnings::standard;
  bool sanitize = false;  ///< adds run-time checks to the sketch and its libraries
  bool coverage = false;  ///< counts how often the sketch's own lines run (coverage.h)
  /// Limits the build to files in the sketch's folder, its libraries and the core. Shared files (project.h)
  /// are excluded.
  bool untrusted = false;
  bool all_messages = false;  ///< CompileError contains the compiler's output in full, not folded()
  ProjectRules rules = {};
  std::function<void()> core_begins = {};  ///< called once before a core is compiled, which takes seconds
};

struct Image {
  std::string name;             ///< name of the sketch
  std::filesystem::path image;  ///< path in the cache; the content under this path never changes
  std::vector<std::filesystem::path> products;  ///< also in the cache: the .hex or .bin of a chip's .elf
  std::filesystem::path notes;  ///< gcov's notes on the sketch, in one archive; only with Request::coverage
  std::string sketch_sha256;    ///< hash of the sketch's own files, by name and content
  std::string image_sha256;
  std::string compiler;                ///< "gcc 12.2.0 x86_64-linux-gnu"
  std::vector<std::string> libraries;  ///< names of the compiled libraries
  std::string messages;                ///< lines with the compiler's warnings; empty if there were none
  /// Size of the code and constants of the sketch, its libraries and the core. For a chip, this is the flash
  /// in use, including the variables' initial values. For the host, this is the size on this machine,
  /// including hal.
  std::uint64_t text_bytes = 0;
  std::uint64_t data_bytes = 0;  ///< size of variables; for a chip, the RAM in use before any call
  bool from_cache = false;
};

/// Thrown if the sketch does not compile. what() is a message of Robosim, or the compiler's output from the
/// first error on, possibly with a hint. Places in the sketch's files have the user's names:
/// "Blink.ino:12:5".
class CompileError : public InputError {
 public:
  using InputError::InputError;
  /// Returns the first line of the message, which describes the first error.
  std::string first_line() const {
    const std::string text = what();
    return text.substr(0, text.find('\n'));
  }
};

/// Thrown if no library provides a header that the sketch includes. A library with this header may be in a
/// folder that the caller did not name.
class MissingLibrary : public CompileError {
 public:
  using CompileError::CompileError;
};

/// Shortens a compiler's output of more than 21 lines to 20 lines: the first message with its source, and the
/// first line of each other message. A further line states the number of skipped lines, and names the command
/// that prints them.
std::string folded(const std::string& output);

/// Builds a sketch. Throws InputError (such as for a missing sketch), MissingLibrary, CompileError, or
/// ToolMissing.
Image build(const Request& request);

/// Returns the targets that sketches are compiled for: "host", "avr", "stm32".
std::vector<std::string> targets();

/// Returns the boards that have a chip of this target, the usual board first; empty = any board. Throws
/// InputError for an unknown target.
std::vector<std::string> boards_of(const std::string& target);

/// Returns a sentence about the first tool or package that is missing to build for this target. Returns an
/// empty text if nothing is missing. Throws InputError for an unknown target.
std::string missing_tool(const std::string& target);

/// Throws InputError for a target whose sketches cannot be built with Request::sanitize.
void check_can_sanitize(const std::string& target);

/// A limit that the firmware declares by an absolute symbol, such as `linekit_limit_nodes_of_a_tree` = 200
/// (firmware/src/nav/Limits.h).
struct Limit {
  std::string what;  ///< "nodes of a tree"
  std::uint64_t value = 0;
  std::uint64_t bytes_each = 0;  ///< RAM per additional item, by `linekit_bytes_each_...`; 0 = not stated
  std::uint64_t most = 0;  ///< largest possible value of the limit, by `linekit_most_...`; 0 = not stated
};
/// Returns all limits of an image, sorted by name.
std::vector<Limit> stated_limits(const Image& image);

/// Returns whether `name` is a path, not the name of a sketch of Robosim. A path contains '/' or '.', or is
/// the name of a folder in `folder`.
bool is_sketch_path(const std::string& name, const std::filesystem::path& folder = ".");

/// Returns the folder or file that the user means by `name`: a path (is_sketch_path), or else a sketch of
/// Robosim. Throws InputError with the names of Robosim's sketches if neither exists.
std::filesystem::path find_sketch(const std::string& name);

/// Returns whether a sketch of this name comes with Robosim.
bool is_stock_sketch(const std::string& name);

/// Returns a remark if the main file of a folder is an .ino file that is not named like the folder.
/// Otherwise returns an empty text.
std::string remark_on_main_file(const std::filesystem::path& folder);

/// Returns the names of the sketches that come with Robosim, sorted.
std::vector<std::string> stock_sketches();

/// Returns where images and objects are stored: $XDG_CACHE_HOME/robosim, or else ~/.cache/robosim. If that
/// folder cannot be written, returns a folder of this user in the system's temporary folder.
std::filesystem::path cache_folder();

}  // namespace robosim::build
