// What compilers see of this machine: the sketch, its libraries, the core, themselves, and a scratch folder
// to write. A source can name any file (#include, .incbin), and a sketch need not be yours.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/child.h"
#include "sim/base/descriptor.h"
#include "sim/base/namespace_sandbox.h"

namespace robosim {

constexpr int kCompileSeconds = 30;  ///< of processor time, each program
constexpr int kWaitSeconds = 30;     ///< of wall time in which a program hardly works
constexpr int kStepSeconds = 300;    ///< of processor time, all programs of one step of a build
constexpr unsigned long kCompileBytes = 224ul << 20;  ///< of variables and heap, all programs at one time
constexpr unsigned long kMadeBytes = 32ul << 20;      ///< of each file that a program writes

/// By Landlock, which asks neither for root nor for namespaces; where the kernel has none, by a file system
/// of its own, which takes namespaces (namespace_sandbox.h); where neither can be had, only the limits hold.
class ProgramSandbox {
 public:
  /// Those that are not there are left out. What belongs to the system (/usr and the like) may be read, too.
  ProgramSandbox(const std::vector<std::filesystem::path>& read, std::filesystem::path scratch);

  /// In a fork, before it becomes a program, for ever, and for whatever that starts; then it is in `folder`.
  /// It may have `bytes` of variables and heap. Async-signal-safe. False if it cannot be.
  bool enter(const char* folder, unsigned long bytes = kCompileBytes) const;

  /// Empty where this kernel confines compilers; else a clause: "the kernel has no Landlock, and …".
  static std::string missing();

  /// Where it may write, and where its temporary files go.
  const std::filesystem::path& scratch() const { return scratch_; }

 private:
  std::filesystem::path scratch_;
  Descriptor rules_;
  std::optional<NamespaceSandbox> own_files_;
};

/// Starts the program `start.words[0]`, an absolute path, within the sandbox. Of the user's environment it
/// gets PATH alone, without relative folders. `start.output` and `start.errors` must be descriptors.
Child start_within(const ProgramSandbox& sandbox, const ChildStart& start,
                   unsigned long bytes = kCompileBytes);

/// Its standard output, of which there may be `most_bytes`; empty if it cannot be started.
std::string output_within(const ProgramSandbox& sandbox, ChildStart start, std::size_t most_bytes);

/// The program of that name on $PATH; empty if there is none. Relative folders are skipped: a sketch's folder
/// may be the working folder.
std::filesystem::path find_program(const std::string& name);

}  // namespace robosim
