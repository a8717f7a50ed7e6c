// Starts the built robosim command as a user does.
#pragma once

#include <fcntl.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "sim/base/child.h"
#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"

namespace robosim::test {

/// A temporary folder with functions for its files.
class Folder : public TemporaryFolder {
 public:
  /// Writes a file, and creates its parent folders.
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    const auto file = path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }
};

inline Descriptor open_file(const std::string& path, int flags) {
  Descriptor file(::open(path.c_str(), flags | O_CLOEXEC, 0600));
  if (file.get() < 0) throw std::system_error(errno, std::generic_category(), path);
  return file;
}

struct Ended {
  int status = -1;  ///< exit status, or 128 + the signal that ended the command
  std::string out;
  std::string err;
};

/// Runs `robosim WORDS` in `folder` to its end, without a terminal. `standard_output` and `standard_input`
/// name files. Without `standard_output`, the result contains the output. `program` replaces the built
/// command.
inline Ended robosim_command(std::vector<std::string> words, const std::filesystem::path& folder = ".",
                             const char* standard_output = nullptr, const char* standard_input = "/dev/null",
                             const std::string& program = ROBOSIM_COMMAND) {
  const Folder files;
  const std::string out = standard_output ? standard_output : (files / "out").string();
  const std::string err = (files / "err").string();
  const Descriptor input = open_file(standard_input, O_RDONLY);
  const Descriptor output = open_file(out, O_WRONLY | O_CREAT);
  const Descriptor errors = open_file(err, O_WRONLY | O_CREAT);
  words.insert(words.begin(), program);
  ChildStart start;
  start.words = std::move(words);
  start.folder = folder;
  start.input = input.get();
  start.output = output.get();
  start.errors = errors.get();
  const Ending ending = Child(start).wait();
  return {ending.signal > 0 ? 128 + ending.signal : ending.status, standard_output ? "" : read_file(out),
          read_file(err)};
}

}  // namespace robosim::test
