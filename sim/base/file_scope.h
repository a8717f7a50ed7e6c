// Restricts the files that a process opens by name to a few folders. `robosim serve` restricts its clients'
// runs, because a robot, map or script from the network may contain any file name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/descriptor.h"
#include "sim/base/error.h"

namespace robosim {

/// An open folder. If its path later names another folder, that folder is neither read nor written.
class HeldFolder {
 public:
  /// Opens a folder. Throws InputError if opening fails.
  explicit HeldFolder(const std::filesystem::path& path);

  /// Opens a file below this folder, like openat() with `flags`. Resolves the path step by step: no `..` or
  /// link ever leads out, even if the folder changes meanwhile. On failure, returns a closed descriptor and
  /// sets errno; EXDEV = the path leads out. With Links::refused, any link on the path fails with ELOOP.
  enum class Links { followed, refused };
  Descriptor open(const std::filesystem::path& below, int flags, Links links = Links::followed) const;

  /// Returns the content of a file below this folder. Throws InputError like read_file().
  std::string read(const std::filesystem::path& below, std::size_t most_bytes) const;

  const std::filesystem::path& path() const { return path_; }
  int handle() const { return handle_.get(); }

 private:
  std::filesystem::path path_;
  Descriptor handle_;
};

/// Environment variable with the allowed folders of a process and its children, one per line. The first
/// folder is the served folder. File names inside users' files must lead into this folder, or to Robosim's
/// own data. If the variable is unset, there is no restriction.
inline constexpr const char* kFileScope = "ROBOSIM_FILE_SCOPE";

/// Returns the variable with its value, "NAME=…", for the environment of a new process.
std::string file_scope_variable(const std::vector<std::filesystem::path>& folders);

/// Opens a file like ::open(). With a scope, the file must be in a folder of the scope, of Robosim, or of the
/// system (/usr); otherwise errno is EXDEV. Follows links to other folders, except from the served folder.
Descriptor open_in_scope(const std::filesystem::path& path, int flags);

/// Opens a path (O_PATH) to which a sandbox gives compilers access. Opens a path below the served folder like
/// HeldFolder::open(), and any other path like ::open().
Descriptor open_to_show(const std::filesystem::path& path);

/// Adds a folder whose name does not come from an input file, such as the folder of the user's libraries. Has
/// no effect without a scope.
void extend_file_scope(const std::filesystem::path& folder);

/// Returns the error for a path that leads out of the scope.
InputError out_of_scope(const std::filesystem::path& path, const Place& place = {});

/// Throws InputError if a scope is set, and `path` is outside both the served folder and Robosim's own data.
/// `place` is the place of the path in a file. The path need not exist.
void check_in_scope(const std::filesystem::path& path, const Place& place = {});

/// Returns whether no scope is set, or `folder` is the served folder or below it.
bool is_in_scope(const std::filesystem::path& folder);

}  // namespace robosim
