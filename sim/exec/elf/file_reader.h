// Records of a binary file, such as an ELF file's.
#pragma once

#include <cstddef>
#include <cstring>
#include <string>

#include "sim/base/error.h"

namespace robosim::exec {

/// Reads records of a file without ever leaving it.
class FileReader {
 public:
  FileReader(const std::string& content, std::string file) : content_(content), file_(std::move(file)) {}

  template <typename T>
  T at(std::size_t offset) const {
    T value;
    std::memcpy(&value, bytes(offset, sizeof value), sizeof value);
    return value;
  }
  const char* bytes(std::size_t offset, std::size_t size) const {
    if (offset > content_.size() || size > content_.size() - offset) damaged();
    return content_.data() + offset;
  }
  std::string text(std::size_t offset) const {
    const std::size_t end = offset < content_.size() ? content_.find('\0', offset) : std::string::npos;
    if (end == std::string::npos) damaged();
    return content_.substr(offset, end - offset);
  }
  [[noreturn]] void damaged() const {
    throw InputError({file_}, "is damaged: it ends before what it announces");
  }

 private:
  const std::string& content_;
  std::string file_;
};

}  // namespace robosim::exec
