// Writes a file that appears only when its content is complete.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sim/base/descriptor.h"

namespace robosim {

/// Writes large content piece by piece to an unnamed file on the disk. Without finish(), the file disappears
/// with this process. Small content stays in memory. If unnamed files are impossible (a device, a pipe, some
/// file systems), all content stays in memory.
class NewFile {
 public:
  explicit NewFile(std::filesystem::path path) : path_(std::move(path)) {}

  /// Returns memory for up to `most` more bytes. The caller passes the end of the added bytes to added().
  char* room(std::size_t most) {
    if (waiting_.size() < used_ + most) waiting_.resize(used_ + most + kPiece);
    return waiting_.data() + used_;
  }
  void added(const char* end) {
    used_ = static_cast<std::size_t>(end - waiting_.data());
    if (used_ >= kPiece) write_waiting();
  }
  void add(std::string_view text);
  /// Gives the file its name, like write_file(). Throws InputError, also for earlier failures.
  void finish();

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 17;

  void write_waiting();

  std::filesystem::path path_;
  std::string waiting_;
  std::size_t used_ = 0;  ///< used bytes of `waiting_`
  Descriptor unnamed_;
  bool is_tried_ = false;
  int error_ = 0;
};

}  // namespace robosim
