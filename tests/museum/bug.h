// A bug of the museum: a patch for Robosim's firmware, and its description.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robosim::museum {

/// A file of bugs/. Before the unified diff, the file has one or two sentences, an empty line, and these
/// lines:
///
///   Kind: units                     the kind of mistake
///   Tests: PidFollower              words; suites whose names contain one of them run first
///   Survives: it changes no run     the reason why no test finds the bug; else absent
struct Bug {
  std::string name;  ///< name of the file, without ".patch"
  std::filesystem::path patch;
  std::string story;  ///< the sentences, joined to one line
  std::string kind;
  std::vector<std::string> tests;
  std::string survives;
  std::vector<std::string> files;  ///< the files that the patch changes, relative to the source tree

  /// Returns whether only one sketch has the bug. Then no other suites need to run.
  bool in_one_sketch() const;
};

/// Returns all bugs of a folder, by kind and name. Throws InputError if a file lacks a required line.
std::vector<Bug> read_bugs(const std::filesystem::path& folder);

}  // namespace robosim::museum
