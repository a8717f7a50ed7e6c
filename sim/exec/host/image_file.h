// Loads a firmware image into memory. Each instance loads it again, and so has its own variables. In a
// confined process (confinement.h) all instances of one image share the memory of its code, which keeps that
// in caches.
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
  bool is_return = false;  ///< a return address: its instruction ends just before it
};

/// Returns the output of `addr2line -f -C -i` for these offsets in the image.
using AddressLines = std::function<std::string(const std::filesystem::path& image,
                                               const std::vector<std::uintptr_t>& offsets)>;
/// Runs that program, of binutils; returns an empty text without it.
std::string ask_addr2line(const std::filesystem::path& image, const std::vector<std::uintptr_t>& offsets);

/// The content of an image's file, in a memory file that cannot be changed. None of it is in the memory of
/// the process itself, where the firmware of a later run would find it.
class ImageContent {
 public:
  /// Reads the file. Throws InputError if that fails, and std::system_error.
  explicit ImageContent(const std::filesystem::path& file);

  /// Returns whether that file still has the same content.
  bool is_like(const std::filesystem::path& file) const;
  /// Returns the descriptor, at least kFirstSealed, by which confined processes load it.
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
  /// Loads an image. Throws InputError if `file` is not an image, or is one for another version of Robosim.
  /// In a confined process no file is opened.
  explicit LoadedImage(const ImageFile& file);
  ~LoadedImage();
  LoadedImage(const LoadedImage&) = delete;
  LoadedImage& operator=(const LoadedImage&) = delete;

  const host::Image& entry() const { return *entry_; }
  /// Returns the ranges of its variables.
  const std::vector<MemoryRange>& variables() const { return variables_; }
  /// Returns whether `address` lies in the image's code.
  bool has_code(const void* address) const;
  /// Returns the place of the first of `addresses` in the user's code. That is the sketch or one of its
  /// libraries, not the core or hal. Empty without addr2line, or if there is no such address.
  SourceLine locate(const std::vector<CodeAddress>& addresses) const;

 private:
  std::vector<SourceLine> frames_of(const std::vector<std::uintptr_t>& offsets) const;

  const ImageFile& file_;
  Descriptor copy_;  ///< in memory, without a name; a confined process has no copy
  void* handle_ = nullptr;
  const host::Image* entry_ = nullptr;
  std::uintptr_t base_ = 0;
  std::uintptr_t code_begin_ = 0, code_end_ = 0;
  std::vector<MemoryRange> variables_;
};

/// Returns whether this file, named by debug information, is not the user's.
bool is_own_file(const std::string& file);

}  // namespace robosim::exec
