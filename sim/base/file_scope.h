// Restricts the files that a process opens by name to a few folders. `robosim serve` does so for its clients'
// runs: robots, maps and scripts from the network name files, and none of them may lie elsewhere.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/descriptor.h"
#include "sim/base/error.h"

namespace robosim {

/// An open folder. A replacement under the same path is neither read nor written.
class HeldFolder {
 public:
  /// Opens a folder. Throws InputError if that fails.
  explicit HeldFolder(const std::filesystem::path& path);

  /// Opens a file below this folder, as openat() does with `flags`. Resolves the path step by step: no `..`
  /// or link leads out at any moment, whatever else changes the folder meanwhile. Returns a closed descriptor
  /// on failure, with errno; EXDEV = the path leads out. With Links::refused any link on the way is ELOOP.
  enum class Links { followed, refused };
  Descriptor open(const std::filesystem::path& below, int flags, Links links = Links::followed) const;

  /// Returns the content of a file below. Throws InputError as read_file() does.
  std::string read(const std::filesystem::path& below, std::size_t most_bytes) const;

  const std::filesystem::path& path() const { return path_; }
  int handle() const { return handle_.get(); }

 private:
  std::filesystem::path path_;
  Descriptor handle_;
};

/// Names the folders for a process and its children, one per line. The first is the served one; names in
/// files may lead only there. Unset: no restriction.
inline constexpr const char* kFileScope = "ROBOSIM_FILE_SCOPE";

/// Returns the variable's value, "NAME=…", for the environment of a new process.
std::string file_scope_variable(const std::vector<std::filesystem::path>& folders);

/// Opens a file as ::open() does. With a scope, only below its folders, Robosim's own and those of the
/// system's programs; else errno is EXDEV. Follows links that lead out, except from the served folder.
Descriptor open_in_scope(const std::filesystem::path& path, int flags);

/// Opens a path that a compiler may see (O_PATH): below the served folder as HeldFolder does, else as
/// ::open().
Descriptor open_to_show(const std::filesystem::path& path);

/// Adds a folder that no file has named, such as that of the user's libraries. Has no effect without a scope.
void extend_file_scope(const std::filesystem::path& folder);

/// Returns the error for a path that leads out.
InputError out_of_scope(const std::filesystem::path& path, const Place& place = {});

/// Throws InputError if there is a scope and `path`, named at `place`, leads out of it: out of the served
/// folder and of Robosim's own. The path need not exist.
void check_in_scope(const std::filesystem::path& path, const Place& place = {});

/// Returns whether there is no scope, or `folder` is the served one or below it.
bool is_in_scope(const std::filesystem::path& folder);

}  // namespace robosim
