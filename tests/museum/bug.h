// A bug of the museum: a patch for Robosim's firmware, and its description.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robosim::museum {

/// A file of bugs/. Above the unified diff stand one or two sentences, an empty line, and these:
///
///   Kind: units                     what sort of mistake it is
///   Tests: PidFollower              suites whose names have one of these words in them are run first
///   Survives: it changes no run     only if no test finds it: why
struct Bug {
  std::string name;  ///< name of the file, without ".patch"
  std::filesystem::path patch;
  std::string story;  ///< the sentences, on one line
  std::string kind;
  std::vector<std::string> tests;
  std::string survives;
  std::vector<std::string> files;  ///< the files that the patch changes, relative to the source tree

  /// Only one sketch has the bug, so that no other suites need to be run.
  bool in_one_sketch() const;
};

/// Returns all bugs of a folder, by kind and name. Throws InputError for a file that lacks a required line.
std::vector<Bug> read_bugs(const std::filesystem::path& folder);

}  // namespace robosim::museum
