// A cache of build results, by content. An entry remembers every file that was read for it, by content, and
// every folder whose list of names mattered; it is valid as long as they are the same. File times do not
// matter.
//
// Safe for concurrent processes: files appear by rename, and a result's name contains its content's hash.
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
  std::vector<std::filesystem::path> folders;  ///< may be absent: their absence is remembered
};

struct Entry {
  std::filesystem::path result;
  std::map<std::string, std::string> facts;  ///< whatever the caller wants to keep with the result
};

class Cache {
 public:
  explicit Cache(std::filesystem::path folder);

  /// The entry for `key`, if all its inputs and its result are as they were.
  std::optional<Entry> find(const std::string& key) const;

  /// Moves `result` into the cache. The entry itself is left out if an input changed after `since`: it may be
  /// newer than what was compiled. `name` is the result's readable name, "PidFollower.so".
  Entry store(const std::string& key, const Inputs& inputs, const std::filesystem::path& result,
              const std::string& name, std::map<std::string, std::string> facts,
              std::filesystem::file_time_type since) const;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// Held by one process at a time, so that what takes seconds is done once. Released at the end of its scope,
/// and by a process that dies.
class CacheLock {
 public:
  explicit CacheLock(const Cache& cache);

 private:
  Descriptor lock_;
};

/// A new, empty folder for work, on the cache's file system. It is removed with all that is in it, by the
/// next one if its process is killed.
class WorkFolder {
 public:
  explicit WorkFolder(const Cache& cache);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  Descriptor held_;
};

}  // namespace robosim::build
