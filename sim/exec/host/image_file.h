// Loads a firmware image into memory. Each LoadedImage loads the image again, so that it has separate
// variables. In a confined process (confinement.h), all copies of an image share the memory of the code. The
// code therefore stays in the processor's caches.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hal/host/image.h"
#include "sim/base/descriptor.h"
#include "sim/exec/core/executor.h"
#include "sim/exec/host/asan_shadow.h"

namespace robosim::exec {

struct CodeAddress {
  const void* pc = nullptr;
  bool is_return = false;  ///< a return address, just after a call instruction
};

/// A function that returns the output of `addr2line -f -C -i` for these offsets in the image.
using AddressLines = std::function<std::string(const std::filesystem::path& image,
                                               const std::vector<std::uintptr_t>& offsets)>;
/// Runs addr2line (binutils). Returns an empty text if addr2line is not installed.
std::string ask_addr2line(const std::filesystem::path& image, const std::vector<std::uintptr_t>& offsets);

/// The content of an image's file, in a sealed memory file (memfd). The content is not in the memory of the
/// process itself, where the firmware of a later run could read it.
class ImageContent {
 public:
  /// Reads the file. Throws InputError or std::system_error if that fails.
  explicit ImageContent(const std::filesystem::path& file);

  /// Returns whether `file` still has this content.
  bool is_like(const std::filesystem::path& file) const;
  /// Returns the descriptor by which confined processes load the image. Its number is at least kFirstSealed.
  const Descriptor& sealed() const { return sealed_; }

 private:
  Descriptor sealed_;
  std::size_t bytes_ = 0;
};

struct ImageFile {
  std::filesystem::path name;
  std::shared_ptr<const ImageContent> content;
  AddressLines lines = ask_addr2line;
};

class LoadedImage {
 public:
  /// Loads an image. Throws InputError if `file` is not an image, or was built for another version of
  /// Robosim. In a confined process, uses only the sealed content and opens no file.
  explicit LoadedImage(const ImageFile& file);
  ~LoadedImage();
  LoadedImage(const LoadedImage&) = delete;
  LoadedImage& operator=(const LoadedImage&) = delete;

  const host::Image& entry() const { return *entry_; }
  /// Returns the ranges of the image's variables.
  const std::vector<MemoryRange>& variables() const { return variables_; }
  /// Returns whether `address` lies in the image's code.
  bool has_code(const void* address) const;
  /// Returns the source line of the first of `addresses` that is in the user's code. The user's code is the
  /// sketch and its libraries, not the Arduino core or hal. Returns an empty line if there is no such
  /// address, or if addr2line is not installed.
  SourceLine locate(const std::vector<CodeAddress>& addresses) const;

 private:
  std::vector<SourceLine> frames_of(const std::vector<std::uintptr_t>& offsets) const;

  const ImageFile& file_;
  Descriptor copy_;  ///< memory file with a copy of the image; not open in a confined process
  void* handle_ = nullptr;
  const host::Image* entry_ = nullptr;
  std::uintptr_t base_ = 0;
  std::uintptr_t code_begin_ = 0, code_end_ = 0;
  std::vector<MemoryRange> variables_;
};

/// Returns whether a file named by debug information does not belong to the user.
bool is_own_file(const std::string& file);

}  // namespace robosim::exec
