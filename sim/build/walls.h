// What compilers see of this machine: the sketch, its libraries, the core, themselves, and a scratch folder
// to write. A source can name any file (#include, .incbin), and a sketch need not be yours.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/descriptor.h"
#include "sim/build/namespace_walls.h"

namespace robosim::build {

constexpr int kCompileSeconds = 30;                 ///< of processor time, each program
constexpr unsigned long kCompileBytes = 1ul << 30;  ///< of variables and heap, each program

/// By Landlock, which asks neither for root nor for namespaces; where the kernel has none, by a file system
/// of its own, which takes namespaces (namespace_walls.h); where neither can be had, only the limits hold.
class Walls {
 public:
  /// Those that are not there are left out. What belongs to the system (/usr and the like) may be read, too.
  Walls(const std::vector<std::filesystem::path>& read, std::filesystem::path scratch);

  /// In a fork, before it becomes a program, for ever, and for whatever that starts; then it is in `folder`.
  /// Async-signal-safe. False if it cannot be.
  bool enter(const char* folder) const;

  /// Empty where this kernel confines compilers; else a clause: "the kernel has no Landlock, and …".
  static std::string missing();

  /// Where it may write, and where its temporary files go.
  const std::filesystem::path& scratch() const { return scratch_; }

 private:
  std::filesystem::path scratch_;
  Descriptor rules_;
  std::optional<NamespaceWalls> own_files_;
};

}  // namespace robosim::build
