// A file with a line for each finished run of a campaign. However the campaign ends, the file's complete
// lines remain, and the campaign can be resumed.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "sim/base/file_lock.h"

namespace robosim::campaign {

class RunFile {
 public:
  /// Locks the file. Throws InputError if another process is writing it, or if it cannot be written.
  explicit RunFile(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  /// Replaces the content by `text`: a header, and the lines that a resumed campaign keeps. Throws
  /// InputError.
  void begin(const std::string& text);
  /// Appends a line, which includes its line feed. Throws InputError.
  void append(const std::string& line);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::filesystem::path path_;
  FileLock lock_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace robosim::campaign
