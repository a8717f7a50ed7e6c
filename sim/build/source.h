// Finds the files of a sketch, and joins its .ino files to one C++ source.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/build/project_rules.h"

namespace robosim::build {

struct Sketch {
  std::string name;               ///< "PidFollower"
  std::filesystem::path folder;   ///< absolute; all names below are relative to it
  std::vector<std::string> inos;  ///< in the order in which Arduino joins them; empty for a plain .cpp sketch
  std::vector<std::string> sources;             ///< further .cpp and .c files to compile, sorted
  std::vector<std::string> assembler;           ///< .S files, for a chip only, sorted
  std::vector<std::string> headers;             ///< other files of the sketch, sorted
  std::vector<std::filesystem::path> includes;  ///< folders for -I
};

/// Returns whether the file is a C or C++ source, which is compiled by itself.
bool is_source(const std::filesystem::path& path);
bool is_header(const std::filesystem::path& path);
bool is_ino(const std::filesystem::path& path);
/// Returns the sorted paths of all headers in a folder, at any depth. Skips hidden and unreadable folders,
/// and stops after 20,000 files. The list is part of the cache's keys: a new header may change what a source
/// includes, or the result of __has_include().
std::vector<std::string> headers_in(const std::filesystem::path& folder);

/// Reads the folder by the rules of Arduino and of the project. Throws InputError for an invalid sketch, and
/// for more than 2 MB of sources and headers.
Sketch read_sketch(const std::filesystem::path& path, const ProjectRules& rules = {});

/// Returns the SHA-256 of names and contents of all files of the sketch.
std::string content_sha256(const Sketch& sketch);

/// Joins the .ino files, with `#include <Arduino.h>` on top and #line directives. Line ends are LF.
std::string join_inos(const Sketch& sketch);

/// Returns `name` as a C string literal.
std::string c_literal(const std::string& name);

}  // namespace robosim::build
