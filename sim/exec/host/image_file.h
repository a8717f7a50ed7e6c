// A firmware image in memory: loaded anew for each instance, so that every one has its own variables.
// Confined (confinement.h), those of one image have their code in the same memory, which keeps it in caches.
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
#include "sim/exec/host/shadow.h"

namespace robosim::exec {

struct CodeAddress {
  const void* pc = nullptr;
  bool is_return = false;  ///< a return address: its instruction ends just before it
};

/// The output of `addr2line -f -C -i` for these offsets in the image.
using AddressLines = std::function<std::string(const std::filesystem::path& image,
                                               const std::vector<std::uintptr_t>& offsets)>;
/// By that program, of binutils; empty without it.
std::string ask_addr2line(const std::filesystem::path& image, const std::vector<std::uintptr_t>& offsets);

/// What the file of an image held: in a file in memory that cannot be changed. None of it is in the memory of
/// the process itself, where the firmware of a later run would find it.
class ImageContent {
 public:
  /// Throws InputError if the file cannot be read, and std::system_error.
  explicit ImageContent(const std::filesystem::path& file);

  /// Whether that file holds the same now.
  bool is_like(const std::filesystem::path& file) const;
  /// The descriptor, at least kFirstSealed, which confined processes load it by.
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
  /// Throws InputError if `file` is no image, or one for another version of Robosim. In a confined process no
  /// file is opened.
  explicit LoadedImage(const ImageFile& file);
  ~LoadedImage();
  LoadedImage(const LoadedImage&) = delete;
  LoadedImage& operator=(const LoadedImage&) = delete;

  const host::Image& entry() const { return *entry_; }
  /// Where its variables are.
  const std::vector<MemoryRange>& variables() const { return variables_; }
  /// Whether `address` lies in the image's code.
  bool has_code(const void* address) const;
  /// The place of the first of `addresses` that lies in the user's code: the sketch or one of its libraries,
  /// not the core or hal. Empty without addr2line, or if there is no such address.
  SourceLine locate(const std::vector<CodeAddress>& addresses) const;

 private:
  std::vector<SourceLine> frames_of(const std::vector<std::uintptr_t>& offsets) const;

  const ImageFile& file_;
  Descriptor copy_;  ///< in memory, without a name; in a confined process none of its own
  void* handle_ = nullptr;
  const host::Image* entry_ = nullptr;
  std::uintptr_t base_ = 0;
  std::uintptr_t code_begin_ = 0, code_end_ = 0;
  std::vector<MemoryRange> variables_;
};

/// Whether debug information names this file for code that is not the user's.
bool is_own_file(const std::string& file);

}  // namespace robosim::exec
