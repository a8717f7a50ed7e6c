// Messages of compilers and linkers, rewritten for users.
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

/// Throws ToolMissing if what a tool has written says that the machine lacks something: room on the disk,
/// memory, an assembler.
void check_machine(const std::string& tool, const std::string& output);

/// The header that a failed compilation did not find; empty if it failed otherwise.
std::string missing_header(const std::string& output, Place* place);

/// Throws for a header that is there, and that compilers do not see: outside of what a sketch may read.
void check_seen(const std::filesystem::path& sketch, const Place& place, const std::string& header);

/// Throws for a header that no library below the finder's folders has: MissingLibrary, or InputError where
/// none could have it.
[[noreturn]] void fail_without_library(const Toolchain& toolchain, const GenuineCore& core,
                                       const LibraryFinder& finder, const Place& place,
                                       const std::string& header);

/// Takes names of this machine's folders out of a text: places are then as the user knows them.
std::string without_folders(const Toolchain& toolchain, const std::filesystem::path& sketch,
                            std::string text);
/// Does so with the compiler's messages, and indents lines that the compiler did not begin.
std::string readable(const Toolchain& toolchain, const std::filesystem::path& sketch,
                     const std::string& messages);

/// Where the first error is; without a file if no message names one.
Place first_error(const std::string& messages);

/// Whether that is in one of the libraries.
bool is_about_library(const std::string& messages, const std::vector<Library>& libraries);

/// Throws CompileError for a failed compilation, or ToolMissing where the machine is to blame.
[[noreturn]] void fail(const Target& target, const std::string& messages);

/// Throws CompileError for a failed link: an undefined or multiply defined function, a chip that is too
/// small.
[[noreturn]] void fail_link(const Toolchain& toolchain, const Sketch& sketch,
                            const std::vector<Object>& objects, std::string output);

/// Throws, as an internal error, for an assembler that refuses only our changes to the compiler's assembly,
/// and writes the changed one to `saved`.
[[noreturn]] void fail_for_changes(const Toolchain& toolchain, const std::filesystem::path& saved,
                                   const std::string& assembly, const std::string& messages);

}  // namespace robosim::build
