#include "sim/base/system_error.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <new>
#include <string_view>
#include <system_error>

namespace robosim {
namespace {

std::string too_many_files() {
  rlimit limit{};
  ::getrlimit(RLIMIT_NOFILE, &limit);
  return "too many files are open: at most " + std::to_string(limit.rlim_cur) +
         " are allowed here; raise the limit with ulimit -n 256";
}

std::string too_large_files() {
  rlimit limit{};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  return "the file is too large: at most " + std::to_string(limit.rlim_cur) +
         " bytes are allowed here; raise the limit with ulimit -f unlimited";
}

/// Returns an error text if /dev/null is missing or unusable; otherwise an empty text.
std::string no_dev_null() {
  return ::access("/dev/null", R_OK | W_OK) == 0 ? "" : "/dev/null is missing or cannot be opened";
}

std::string no_temporary_files() {
  const char* folder = std::getenv("TMPDIR");
  return std::string("cannot create a temporary file in ") + (folder ? folder : "/tmp") +
         (folder ? "; set TMPDIR to an existing folder, or unset it" : "");
}

constexpr const char* kNoMemory = "there is not enough memory";
constexpr const char* kNoRoom = "there is no room left on the disk";
constexpr const char* kNoProcesses = "cannot start more processes; raise the limit with ulimit -u";

/// Returns whether the line starts with a word and a colon, like a program's own messages.
bool names_a_program(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(' ');
  return begin != line.npos && line.find_first_of(" \"'(", begin) == line.find(": ", begin) + 1;
}

/// Returns whether the line names a place in a source, or quotes a source. Compilers before gcc 9 mark quoted
/// lines only by an indent of one blank.
bool is_of_sketch(std::string_view line) {
  static constexpr std::string_view kSigns[] = {
      ": error: ", ": warning: ", ": note: ", ": Error: ", ": Warning: "};
  for (const std::string_view sign : kSigns)
    if (const std::size_t at = line.find(sign);
        at != line.npos && at > 0 && line[at - 1] >= '0' && line[at - 1] <= '9')
      return true;
  // Includes messages about a missing header, whose name comes from the sketch.
  if (const std::size_t at = line.find(": fatal error: "); at != line.npos && at > 0 && line[at - 1] >= '0' &&
                                                           line[at - 1] <= '9' &&
                                                           line.ends_with(": No such file or directory"))
    return true;
  return (line.starts_with(' ') && !names_a_program(line)) || line.find(" | ") != line.npos;
}

bool has(std::string_view line, std::string_view text) { return line.find(text) != std::string_view::npos; }

std::string fault_in(std::string_view line) {
  if (has(line, "No space left on device") || has(line, "Disk quota exceeded")) {
    // ld prints this message, too, if it can write only a part of a file because of ulimit -f.
    rlimit limit{};
    const bool limited = ::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    return limited ? std::string(kNoRoom) + ", or " + too_large_files() : kNoRoom;
  }
  if (has(line, "Too many open files") || has(line, "out of file descriptors")) return too_many_files();
  if (has(line, "File too large") || has(line, "File size limit exceeded")) return too_large_files();
  if (has(line, "Cannot create temporary file") || has(line, "cannot open temporary file"))
    return no_temporary_files();
  if (has(line, "virtual memory exhausted") || has(line, "memory exhausted") ||
      has(line, "Cannot allocate memory") || has(line, "out of memory allocating") ||
      has(line, "fatal error: Killed signal terminated program"))
    return kNoMemory;
  if (has(line, "Resource temporarily unavailable")) return kNoProcesses;
  for (const char* program : {"as", "ld"})
    for (const char* what : {"cannot execute '", "cannot find '"})
      if (has(line, what + std::string(program) + "'"))
        return std::string(program) + " is missing: sudo apt install binutils";
  return "";
}

}  // namespace

std::string system_error_of(const std::exception& thrown) {
  if (dynamic_cast<const std::bad_alloc*>(&thrown)) return kNoMemory;
  const auto* error = dynamic_cast<const std::system_error*>(&thrown);
  if (!error) return "";
  switch (error->code().value()) {
    case EMFILE:
      return too_many_files();
    case ENFILE:
      return "the machine has too many files open";
    case ENOENT:
    case EACCES:
    case ENXIO:
      return no_dev_null();
    case EFBIG:
      return too_large_files();
    case ENOSPC:
    case EDQUOT:
      return kNoRoom;
    case ENOMEM:
      return kNoMemory;
    case EAGAIN:
      return kNoProcesses;
    default:
      return "";
  }
}

std::string system_error_of(const std::string& tool, const std::string& output) {
  if (const std::string fault = no_dev_null(); !fault.empty()) return tool + " failed: " + fault;
  std::string_view rest = output;
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (is_of_sketch(line)) continue;
    if (const std::string fault = fault_in(line); !fault.empty()) return tool + " failed: " + fault;
  }
  return "";
}

}  // namespace robosim
