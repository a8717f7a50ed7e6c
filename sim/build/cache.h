// Caches build results by content. An entry records the content of every file that was read for the result.
// The entry also records the list of names in every folder that was searched. The entry is valid while these
// files and lists are unchanged. The files' times do not matter.
//
// SHA-256 is used for keys, for the hash in a result's name, and for files that other users can write. XXH3
// is ten times faster. It is used for files of Robosim and of the system, and to detect incomplete results.
//
// Concurrent processes are safe: files appear by rename, and a result's name contains its content's hash.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/descriptor.h"

namespace robosim::build {

struct Inputs {
  std::vector<std::filesystem::path> files;
  std::vector<std::filesystem::path> folders;  ///< a folder may be missing; the entry then records this
};

struct Entry {
  std::filesystem::path result;
  std::map<std::string, std::string> facts;  ///< the caller's data about the result
};

/// Prefix of the folders in the cache that hold links to installed files.
constexpr const char* kStage = "stage-";

/// Returns the text of a key. Different lists of words have different texts.
std::string key_of(const std::vector<std::string>& words);

class Cache {
 public:
  explicit Cache(std::filesystem::path folder);

  /// Returns the entry for `key` if all its inputs and its result are unchanged.
  std::optional<Entry> find(const std::string& key) const;

  /// Writes a result to the cache, under a name made of `name` ("PidFollower.so") and the hash of `content`.
  /// Writes no entry if an input changed after `since`: the input may be newer than the compiled version.
  Entry store(const std::string& key, const Inputs& inputs, std::string_view content, const std::string& name,
              std::map<std::string, std::string> facts, std::filesystem::file_time_type since) const;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// A lock that at most one process holds at a time, so that slow work is done only once. The lock is released
/// at the end of its scope, or when its process dies.
class CacheLock {
 public:
  explicit CacheLock(const Cache& cache);

 private:
  Descriptor lock_;
};

/// A new, empty work folder on the cache's file system. The destructor removes the folder with all its
/// content. If the process is killed, the next WorkFolder removes the folder.
class WorkFolder {
 public:
  explicit WorkFolder(const Cache& cache);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

  /// Returns the folder for the input files of compilers. Compilers can read this folder, but not write to
  /// it.
  std::filesystem::path given() const;
  /// Copies or links a result of the cache into the folder given(). Returns the path of the copy or link.
  std::filesystem::path give(const std::filesystem::path& result) const;
  /// Returns a new folder for one compiler, which can write to no other folder.
  std::filesystem::path scratch();

 private:
  std::filesystem::path path_;
  Descriptor held_;
  int scratch_folders_ = 0;
};

/// Returns the content of a file that a compiler wrote, even if the file is incomplete. Throws InputError for
/// anything except a regular file: a link could lead to any file.
std::string read_made(const std::filesystem::path& file);

}  // namespace robosim::build
