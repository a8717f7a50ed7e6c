#include "sim/base/new_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "sim/base/file.h"

namespace robosim {
namespace fs = std::filesystem;

namespace {

bool is_to_be_a_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status there = fs::status(path, error);
  return !fs::exists(there) || fs::is_regular_file(there);
}

}  // namespace

void NewFile::add(std::string_view text) {
  for (; !text.empty(); text.remove_prefix(std::min(kPiece, text.size()))) {
    const std::string_view piece = text.substr(0, kPiece);
    added(std::copy(piece.begin(), piece.end(), room(piece.size())));
  }
}

void NewFile::write_waiting() {
  if (!is_tried_ && is_to_be_a_file(path_)) {
    const fs::path folder = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
    unnamed_ = Descriptor(::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666));
  }
  is_tried_ = true;
  if (!unnamed_.is_open()) return;
  if (error_ == 0) error_ = write_all(unnamed_.get(), {waiting_.data(), used_});
  used_ = 0;
}

void NewFile::finish() {
  if (!unnamed_.is_open()) return write_file(path_, {waiting_.data(), used_});
  if (used_ > 0) write_waiting();
  place_file(unnamed_, path_, error_);
}

}  // namespace robosim
