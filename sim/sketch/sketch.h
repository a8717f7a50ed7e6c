// From a sketch folder to an image that a runner loads, by Arduino's rules (docs/formats.md, "Sketches and
// libraries").
//
//   const Image image = build({find_sketch("PidFollower"), *find_board("uno")});
//
// Results are cached by content: a second build of the same files starts no process.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/base/error.h"

namespace robosim::sketch {

/// Which of the compiler's warnings are shown: the choices of Arduino's preferences.
enum class Warnings { none, standard, more, all };

struct Request {
  std::filesystem::path
      sketch;  ///< a sketch folder, its .ino, or a single .cpp that includes Arduino.h itself
  const BoardSpec& board;
  std::string target = "host";
  std::vector<std::filesystem::path>
      libraries;  ///< folders of libraries, or single libraries; searched in this order
  Warnings warnings = Warnings::standard;
};

struct Image {
  std::filesystem::path image;  ///< in the cache; its content never changes under this name
  std::string sketch_sha256;    ///< of the sketch's own files, by name and content
  std::string image_sha256;
  std::string compiler;                ///< "gcc 12.2.0 x86_64-linux-gnu"
  std::vector<std::string> libraries;  ///< names of those that were compiled in
  std::string messages;                ///< the compiler's warnings, lines; empty where there were none
  std::uint64_t text_bytes = 0;  ///< code and constants of sketch, libraries, core and hal, for this machine
  std::uint64_t data_bytes = 0;  ///< variables
  bool from_cache = false;
};

/// The sketch does not compile. what() is the compiler's own message from the first error on, with places in
/// the sketch's files as the user knows them ("Blink.ino:12:5").
class CompileError : public InputError {
 public:
  using InputError::InputError;
};

/// Throws InputError (no such sketch, a header that no library has), CompileError, or ToolMissing.
Image build(const Request& request);

/// What the user calls a sketch: a path if it holds '/' or '.', else one of ours by name. Gives the folder or
/// file; throws InputError, listing ours, if there is none.
std::filesystem::path find_sketch(const std::string& name);

/// The names of the sketches that come with Robosim, sorted.
std::vector<std::string> stock_sketches();

/// Where images and objects are kept: $XDG_CACHE_HOME/robosim, else ~/.cache/robosim, else (where that cannot
/// be written) a folder of this user's below the system's temporary one.
std::filesystem::path cache_folder();

}  // namespace robosim::sketch
