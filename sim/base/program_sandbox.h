// Restricts compilers to certain files: the sketch, its libraries, the core, the compilers themselves, and a
// writable scratch folder. A source can name any file (#include, .incbin), and a sketch may come from a
// stranger.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/child.h"
#include "sim/base/descriptor.h"
#include "sim/base/namespace_sandbox.h"

namespace robosim {

constexpr int kCompileSeconds = 30;                   ///< processor time per program
constexpr int kLookupSeconds = 5;                     ///< processor time for output_within()
constexpr int kWaitSeconds = 30;                      ///< wall time after which an idle program is killed
constexpr int kStepSeconds = 300;                     ///< processor time of all programs of one build step
constexpr unsigned long kCompileBytes = 216ul << 20;  ///< variables and heap of all programs at one time
constexpr unsigned long kMadeBytes = 32ul << 20;      ///< size of each file that a program writes

/// Uses Landlock, which needs neither root nor namespaces. Without Landlock in the kernel, uses a separate
/// file system, which needs namespaces (namespace_sandbox.h). Without both, only the resource limits apply.
class ProgramSandbox {
 public:
  /// Skips missing paths. System folders (/usr and similar) may be read, too.
  ProgramSandbox(const std::vector<std::filesystem::path>& read, std::filesystem::path scratch);

  /// Enters the sandbox permanently, with all later children. Call this in a fork, before exec. Afterwards
  /// the working folder is `folder`. The limits are `bytes` of variables and heap, and `seconds` of processor
  /// time. Async-signal-safe. Returns false on failure.
  bool enter(const char* folder, unsigned long bytes = kCompileBytes, int seconds = kCompileSeconds) const;

  /// Returns an empty text if this kernel can confine compilers; otherwise a clause: "the kernel has no
  /// Landlock, and …".
  static std::string missing();

  /// Returns the writable folder, which also receives temporary files.
  const std::filesystem::path& scratch() const { return scratch_; }

 private:
  std::filesystem::path scratch_;
  Descriptor rules_;
  std::optional<NamespaceSandbox> own_files_;
};

/// Starts the program `start.words[0]`, an absolute path, within the sandbox. From the user's environment the
/// program inherits only PATH, without relative folders. `start.output` and `start.errors` must be
/// descriptors.
Child start_within(const ProgramSandbox& sandbox, const ChildStart& start,
                   unsigned long bytes = kCompileBytes, int seconds = kCompileSeconds);

/// Returns the standard output of a program in the sandbox, at most `most_bytes`, within kLookupSeconds;
/// empty if the program cannot be started.
std::string output_within(const ProgramSandbox& sandbox, ChildStart start, std::size_t most_bytes);

/// Returns the path of the program `name` on $PATH; empty if it is missing. Relative folders are skipped,
/// because the working folder may be a sketch's folder.
std::filesystem::path find_program(const std::string& name);

}  // namespace robosim
