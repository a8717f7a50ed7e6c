// From a sketch folder to an image that a runner loads or a chip is flashed with, by Arduino's rules
// (docs/sketches.md).
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
#include "sim/build/rules.h"

namespace robosim::build {

/// Which of the compiler's warnings are shown: the choices of Arduino's preferences; `standard` has more,
/// which find what beginners write: if (x = 1), if (400 < x < 600), and if (x); (slips.h)
enum class Warnings { none, standard, more, all };

struct Request {
  std::filesystem::path
      sketch;  ///< a sketch folder, its .ino, or a single .cpp that includes Arduino.h itself
  const BoardSpec& board;
  std::string target = "host";  ///< or "avr", "stm32"
  std::vector<std::filesystem::path>
      libraries;  ///< folders of libraries, or single libraries; searched in this order
  Warnings warnings = Warnings::standard;
  bool sanitize = false;  ///< sketch and libraries check themselves while they run
  bool coverage = false;  ///< the sketch's own lines are counted (coverage.h)
  /// Of what lies outside of the sketch's folder it sees its libraries alone: not what it shares (project.h).
  bool untrusted = false;
  ProjectRules rules = {};
  std::function<void()> core_begins =
      {};  ///< called before a core is compiled, which takes seconds, and once
};

struct Image {
  std::string name;             ///< of the sketch
  std::filesystem::path image;  ///< in the cache; its content never changes under this name
  std::vector<std::filesystem::path>
      products;                 ///< what was made of it, likewise: the .hex or .bin of a chip's .elf
  std::filesystem::path notes;  ///< of gcov on the sketch, bundled; with Request::coverage
  std::string sketch_sha256;    ///< of the sketch's own files, by name and content
  std::string image_sha256;
  std::string compiler;                ///< "gcc 12.2.0 x86_64-linux-gnu"
  std::vector<std::string> libraries;  ///< names of those that were compiled in
  std::string messages;                ///< the compiler's warnings, lines; empty where there were none
  /// Code and constants of sketch, libraries and core. On a chip the flash in use, with the variables'
  /// initial values; on the host for this machine, hal included.
  std::uint64_t text_bytes = 0;
  std::uint64_t data_bytes = 0;  ///< variables: on a chip the RAM in use before anything is called
  bool from_cache = false;
};

/// The sketch does not compile. what() is the compiler's own message from the first error on, with places in
/// the sketch's files as the user knows them ("Blink.ino:12:5").
class CompileError : public InputError {
 public:
  using InputError::InputError;
};

/// There is no library for a header that the sketch includes; one may be in a folder that was not named.
class MissingLibrary : public InputError {
 public:
  using InputError::InputError;
};

/// Throws InputError (no such sketch …), MissingLibrary, CompileError, or ToolMissing.
Image build(const Request& request);

/// The targets that sketches are compiled for: "host", "avr", "stm32".
std::vector<std::string> targets();

/// The boards that have a chip of this target, the usual one first; empty = any board will do. Throws
/// InputError for an unknown target.
std::vector<std::string> boards_of(const std::string& target);

/// The sentence that names the first tool or package that building for this target lacks; empty if all are
/// there. Throws InputError for an unknown target.
std::string missing_tool(const std::string& target);

/// Throws InputError for a target whose sketches cannot be built with Request::sanitize.
void check_can_sanitize(const std::string& target);

/// A limit that the firmware states by an absolute symbol, `linekit_limit_nodes_of_a_tree` = 200
/// (firmware/src/nav/Limits.h).
struct Limit {
  std::string what;  ///< "nodes of a tree"
  std::uint64_t value = 0;
  std::uint64_t bytes_each = 0;  ///< RAM that one more takes, by `linekit_bytes_each_...`; 0 = not stated
  std::uint64_t most = 0;        ///< how far it may be raised, by `linekit_most_...`; 0 = not stated
};
/// All of an image, sorted by their names.
std::vector<Limit> stated_limits(const Image& image);

/// Returns whether `name` is a path, and not the name of a sketch of Robosim: it holds '/' or '.', or `folder`
/// has a folder of that name.
bool is_sketch_path(const std::string& name, const std::filesystem::path& folder = ".");

/// Returns the folder or file that the user calls `name`: a path (is_sketch_path), else a sketch of Robosim.
/// Throws InputError, with the names of Robosim's sketches, if there is neither.
std::filesystem::path find_sketch(const std::string& name);

/// Returns whether a sketch of this name comes with Robosim.
bool is_stock_sketch(const std::string& name);

/// Returns the names of the sketches that come with Robosim, sorted.
std::vector<std::string> stock_sketches();

/// Where images and objects are kept: $XDG_CACHE_HOME/robosim, else ~/.cache/robosim, else (where that cannot
/// be written) a folder of this user's below the system's temporary one.
std::filesystem::path cache_folder();

}  // namespace robosim::build
