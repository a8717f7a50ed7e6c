// Limits what compilers see of this machine: the sketch, its libraries, the core, themselves, and a writable
// scratch folder. A source can name any file (#include, .incbin), and a sketch may be a stranger's.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/child.h"
#include "sim/base/descriptor.h"
#include "sim/base/namespace_sandbox.h"

namespace robosim {

constexpr int kCompileSeconds = 30;                   ///< of processor time, per program
constexpr int kLookupSeconds = 5;                     ///< of processor time, for output_within()
constexpr int kWaitSeconds = 30;                      ///< of wall time almost without work
constexpr int kStepSeconds = 300;                     ///< of processor time, all programs of one build step
constexpr unsigned long kCompileBytes = 224ul << 20;  ///< of variables and heap, all programs at one time
constexpr unsigned long kMadeBytes = 32ul << 20;      ///< of each file that a program writes

/// Uses Landlock, which needs neither root nor namespaces. If the kernel lacks it, uses a separate file
/// system, which needs namespaces (namespace_sandbox.h). Without both, only the limits apply.
class ProgramSandbox {
 public:
  /// Skips missing paths. System folders (/usr and similar) may be read, too.
  ProgramSandbox(const std::vector<std::filesystem::path>& read, std::filesystem::path scratch);

  /// Enters it for ever, in a fork before it becomes a program, including all its children; then it is in
  /// `folder`. It may have `bytes` of variables and heap, and `seconds` of processor time. Async-signal-safe.
  /// Returns false on failure.
  bool enter(const char* folder, unsigned long bytes = kCompileBytes, int seconds = kCompileSeconds) const;

  /// Returns an empty text if this kernel confines compilers; else a clause: "the kernel has no Landlock, and
  /// …".
  static std::string missing();

  /// Returns the writable folder, which also gets its temporary files.
  const std::filesystem::path& scratch() const { return scratch_; }

 private:
  std::filesystem::path scratch_;
  Descriptor rules_;
  std::optional<NamespaceSandbox> own_files_;
};

/// Starts the program `start.words[0]`, an absolute path, within the sandbox. Of the user's environment it
/// gets only PATH, without relative folders. `start.output` and `start.errors` must be descriptors.
Child start_within(const ProgramSandbox& sandbox, const ChildStart& start,
                   unsigned long bytes = kCompileBytes, int seconds = kCompileSeconds);

/// Returns its standard output, at most `most_bytes`, within kLookupSeconds; empty if it cannot be started.
std::string output_within(const ProgramSandbox& sandbox, ChildStart start, std::size_t most_bytes);

/// Returns the program of that name on $PATH; empty if there is none. Relative folders are skipped: a
/// sketch's folder may be the working folder.
std::filesystem::path find_program(const std::string& name);

}  // namespace robosim
