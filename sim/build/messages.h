// Rewrites messages of compilers and linkers for users.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/error.h"
#include "sim/build/compile.h"
#include "sim/build/libraries.h"
#include "sim/build/source.h"
#include "sim/build/toolchain.h"

namespace robosim::build {

/// Throws ToolMissing if a tool's output shows that the machine lacks disk space, memory, or an assembler.
void check_machine(const std::string& tool, const std::string& output);

/// Returns the header that a failed compilation did not find; empty if it failed for another reason.
std::string missing_header(const std::string& output, Place* place);

/// Throws CompileError if the compiler may have missed `header` only because of the sandbox: `header` is a
/// link, or its name is absolute or contains "..". Does not check whether the file exists.
void check_seen(const std::filesystem::path& sketch, const Place& place, const std::string& header);

/// Throws the error for a header that no library in the finder's folders provides. The error is
/// MissingLibrary if another library may provide the header. The error is another CompileError if no library
/// can provide it, or if the header exists with other capital letters.
[[noreturn]] void fail_without_library(const Toolchain& toolchain, const GenuineCore& core,
                                       const LibraryFinder& finder, const std::filesystem::path& sketch,
                                       const Place& place, const std::string& header);

/// Removes names of this machine's folders from a text, so that users recognise their files.
std::string without_folders(const Toolchain& toolchain, const std::filesystem::path& sketch,
                            std::string text);
/// Removes the folders' names from the compiler's messages. Indents lines that do not begin like messages of
/// a compiler: such lines may be text from the sketch.
std::string readable(const Toolchain& toolchain, const std::filesystem::path& sketch,
                     const std::string& messages);

/// Returns the place of the first error. The place has no file if no message names a file.
Place first_error(const std::string& messages);

/// Returns whether the error is in one of the libraries.
bool is_about_library(const std::string& messages, const std::vector<Library>& libraries);

/// Throws CompileError for a failed compilation, or ToolMissing if the machine is to blame. If `hint` is
/// empty, uses the hint of hint_for().
[[noreturn]] void fail(const Toolchain& toolchain, const std::string& messages, std::string hint = "");

/// Throws CompileError for a failed link: an undefined or multiply defined function, or a chip that is too
/// small. `own_lines` are the sketch's preprocessed lines (prototypes.h), or empty.
[[noreturn]] void fail_link(const Toolchain& toolchain, const GenuineCore& core, const Sketch& sketch,
                            const std::vector<Object>& objects, const std::string& own_lines,
                            std::string output);

/// Throws an internal error: an assembler rejects the compiler's assembly only after Robosim's changes.
/// Writes the changed assembly to `saved`.
[[noreturn]] void fail_for_changes(const Toolchain& toolchain, const std::filesystem::path& saved,
                                   const std::string& assembly, const std::string& messages);

}  // namespace robosim::build
