#include "sim/exec/host/image_file.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/program_sandbox.h"
#include "sim/exec/host/confinement.h"

namespace robosim::exec {
namespace {

/// Converts "f(int) const" to "f". Names without parameters stay unchanged.
std::string without_parameters(const std::string& name) {
  const std::size_t close = name.rfind(')');
  if (close == std::string::npos) return name;
  int depth = 0;
  for (std::size_t i = close + 1; i-- > 0;) {
    if (name[i] == ')') ++depth;
    if (name[i] == '(' && --depth == 0) return i == 0 ? name : name.substr(0, i);
  }
  return name;
}

struct Segments {
  std::uintptr_t base;
  std::uintptr_t begin = UINTPTR_MAX;  ///< bounds of the code
  std::uintptr_t end = 0;
  std::vector<MemoryRange> variables = {};
  std::pair<std::uintptr_t, std::uintptr_t> constants = {};  ///< range that the loader makes read-only
};

int find_segments(dl_phdr_info* info, std::size_t, void* argument) {
  auto& found = *static_cast<Segments*>(argument);
  if (info->dlpi_addr != found.base) return 0;
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const auto& segment = info->dlpi_phdr[i];
    const std::uintptr_t begin = found.base + segment.p_vaddr, end = begin + segment.p_memsz;
    if (segment.p_type == PT_GNU_RELRO) found.constants = {begin, end};
    if (segment.p_type != PT_LOAD) continue;
    if (segment.p_flags & PF_W)
      found.variables.push_back(
          {reinterpret_cast<const std::byte*>(begin), reinterpret_cast<const std::byte*>(end)});
    if (!(segment.p_flags & PF_X)) continue;
    found.begin = std::min(found.begin, begin);
    found.end = std::max(found.end, end);
  }
  return 1;
}

/// Clears the lowest bit of a code address on 32-bit ARM, where it selects the instruction set.
std::uintptr_t without_mode(const void* pc) {
  const auto address = reinterpret_cast<std::uintptr_t>(pc);
#if defined(__arm__)
  return address & ~std::uintptr_t{1};
#else
  return address;
#endif
}

// Returns the handles of all loaded images.
std::vector<void*>& handles() {
  static std::vector<void*> all;
  return all;
}

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

/// A buffer for a part of an image. The destructor erases the buffer, so that firmware cannot read the part.
struct Part {
  static constexpr std::size_t kBytes = 16 * 1024;
  char bytes[kBytes];
  ~Part() { explicit_bzero(bytes, kBytes); }

  /// Reads from the offset `at` of a file. Returns the number of bytes read; 0 at the file's end.
  std::size_t read(const Descriptor& file, std::size_t at) {
    for (;;) {
      const ssize_t n = pread(file.get(), bytes, kBytes, static_cast<off_t>(at));
      if (n >= 0) return static_cast<std::size_t>(n);
      if (errno != EINTR) fail("cannot read an image");
    }
  }
};

/// Returns a memory file with the content of `file`, and its size in bytes.
std::pair<Descriptor, std::size_t> copy_in_memory(const Descriptor& file) {
  Descriptor copy(memfd_create("robosim-firmware", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (!copy.is_open()) fail("memfd_create");
  Part part;
  std::size_t bytes = 0;
  while (const std::size_t n = part.read(file, bytes)) {
    if (const int error = write_all(copy.get(), {part.bytes, n}); error != 0)
      throw std::system_error(error, std::generic_category(), "cannot copy an image");
    bytes += n;
  }
  return {std::move(copy), bytes};
}

/// Returns the number of bytes that the segments of the image at kImageFd need in memory. Returns 0 if the
/// file is shorter than its headers.
std::uint64_t loaded_bytes() {
  ElfW(Ehdr) header{};
  std::uint64_t bytes = 0;
  if (pread(kImageFd, &header, sizeof header, 0) != sizeof header) return 0;
  for (std::uint64_t i = 0; i < header.e_phnum; ++i) {
    ElfW(Phdr) segment{};
    const auto at = static_cast<off_t>(header.e_phoff + i * sizeof segment);
    if (pread(kImageFd, &segment, sizeof segment, at) != sizeof segment) return 0;
    if (segment.p_type == PT_LOAD) bytes += segment.p_memsz;
  }
  return bytes;
}

// Loads an image in a confined process. The loader cannot open a file. Instead, serve_call() gives kImageFd
// to the loader, which later closes kImageFd. serve_call() also reports another inode number for each image,
// so that the loader sees different files. A process can therefore load one file several times, and share the
// memory of its code.
void* load_confined(const ImageFile& file) {
  static int loaded = 0;
  if (!keyed_dup(file.content->sealed().get(), kImageFd)) throw std::logic_error("an image is not sealed");
  if (const std::uint64_t bytes = loaded_bytes(); bytes > kConfinedMemory)
    throw InputError(
        {file.name.string()},
        fmt::format("the sketch's variables take {} MB: expected at most {} MB, the limit of a run",
                    (bytes + (1u << 20) - 1) >> 20, kConfinedMemory >> 20));
  lseek(kImageFd, 0, SEEK_SET);
  return dlopen(fmt::format("{}-{}", kImageName, ++loaded).c_str(), RTLD_NOW | RTLD_LOCAL);
}

}  // namespace

bool is_own_file(const std::string& file) {
  return file.empty() || file[0] == '?' || file[0] == '<' || file.starts_with("robosim/") ||
         file.find("/robosim/") != std::string::npos || file.starts_with("/usr/");
}

/// Limit of addr2line's output in bytes, since a sketch may contain very long names of functions and files.
constexpr std::size_t kMostLines_bytes = std::size_t{1} << 20;

std::string ask_addr2line(const std::filesystem::path& image, const std::vector<std::uintptr_t>& offsets) {
  const std::filesystem::path program = find_program("addr2line");
  if (program.empty()) return "";
  ChildStart start;
  start.words = {program.string(), "-f", "-C", "-i", "-e", image.string()};
  for (const std::uintptr_t offset : offsets) start.words.push_back(fmt::format("{:#x}", offset));
  start.folder = "/";
  return output_within(ProgramSandbox({image, program.parent_path()}, {}), start, kMostLines_bytes);
}

ImageContent::ImageContent(const std::filesystem::path& file) {
  auto [copy, bytes] = copy_in_memory(open_to_read(file));
  if (fcntl(copy.get(), F_ADD_SEALS, F_SEAL_WRITE | F_SEAL_GROW | F_SEAL_SHRINK | F_SEAL_SEAL) != 0)
    fail("F_ADD_SEALS");
  sealed_ = at_least(kFirstSealed, std::move(copy));
  bytes_ = bytes;
}

bool ImageContent::is_like(const std::filesystem::path& file) const {
  const Descriptor other(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!other.is_open()) return false;
  Part theirs, ours;
  for (std::size_t at = 0;;) {
    const std::size_t n = theirs.read(other, at);
    if (n == 0) return at == bytes_;
    if (ours.read(sealed_, at) < n || std::memcmp(theirs.bytes, ours.bytes, n) != 0) return false;
    at += n;
  }
}

LoadedImage::LoadedImage(const ImageFile& file) : file_(file) {
  if (is_confined()) {
    handle_ = load_confined(file);
  } else {
    // Loads a copy in a memory file, because the loader does not load the same file twice. The loader
    // identifies files by inode and by the path below. The descriptor stays open while the image is loaded,
    // so that no other image gets the same path.
    copy_ = (file.content ? copy_in_memory(file.content->sealed()) : copy_in_memory(open_to_read(file.name)))
                .first;
    handle_ = dlopen(fmt::format("/proc/self/fd/{}", copy_.get()).c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  const std::string error = handle_ ? "" : dlerror();
  if (handle_) entry_ = static_cast<const host::Image*>(dlsym(handle_, "robosim_image"));
  if (!entry_ || entry_->version != host::kImageVersion) {
    const bool other_version = entry_ != nullptr;
    if (handle_) dlclose(handle_);
    if (other_version)
      throw InputError({file.name.string()},
                       "the image was built for another version of Robosim; build the sketch again");
    throw InputError({file.name.string()},
                     "not a firmware image for this machine" + (error.empty() ? "" : ": " + error));
  }
  if (std::count(handles().begin(), handles().end(), handle_) > 0)
    throw std::logic_error("the loader treats two copies of an image as one");
  handles().push_back(handle_);
  link_map* map = nullptr;
  dlinfo(handle_, RTLD_DI_LINKMAP, &map);
  base_ = map->l_addr;
  Segments found{base_};
  dl_iterate_phdr(find_segments, &found);
  code_begin_ = found.begin;
  code_end_ = found.end;
  variables_ = std::move(found.variables);
  const auto* const end_of_constants = reinterpret_cast<const std::byte*>(found.constants.second);
  for (MemoryRange& variables : variables_)
    if (reinterpret_cast<std::uintptr_t>(variables.begin) == found.constants.first)
      variables.begin = std::min(end_of_constants, variables.end);
}

LoadedImage::~LoadedImage() {
  std::erase(handles(), handle_);
  dlclose(handle_);
}

bool LoadedImage::has_code(const void* address) const {
  const auto value = reinterpret_cast<std::uintptr_t>(address);
  return value >= code_begin_ && value < code_end_;
}

std::vector<SourceLine> LoadedImage::frames_of(const std::vector<std::uintptr_t>& offsets) const {
  std::istringstream lines(file_.lines(file_.name, offsets));
  std::vector<SourceLine> frames;
  std::string function, place;
  while (std::getline(lines, function) && std::getline(lines, place)) {
    SourceLine frame;
    frame.function = without_parameters(function);
    const std::size_t note = place.find(" (discriminator");
    if (note != std::string::npos) place.resize(note);
    const std::size_t colon = place.rfind(':');
    if (colon != std::string::npos) {
      std::from_chars(place.data() + colon + 1, place.data() + place.size(), frame.line);
      frame.file = place.substr(0, colon);
      if (frame.file.starts_with("./")) frame.file.erase(0, 2);
    }
    frames.push_back(frame);
  }
  return frames;
}

SourceLine LoadedImage::locate(const std::vector<CodeAddress>& addresses) const {
  std::vector<std::uintptr_t> offsets;
  for (const CodeAddress& address : addresses) {
    // Looks up the call instead of its return address. If a call is the last instruction of a function, the
    // return address belongs to other code.
    const std::uintptr_t pc = without_mode(address.pc) - (address.is_return ? 1 : 0);
    if (has_code(reinterpret_cast<const void*>(pc))) offsets.push_back(pc - base_);
  }
  if (offsets.empty()) return {};
  // Skips instructions without a source line. Their file is also unknown, so they may belong to the Arduino
  // core.
  for (const SourceLine& frame : frames_of(offsets))
    if (frame.line > 0 && !is_own_file(frame.file)) return frame;
  return {};
}

}  // namespace robosim::exec
