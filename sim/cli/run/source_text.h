// The text of a sketch's lines, as far as its files are found: an image knows where lines are, not what they
// say.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/wire/run_result.h"

namespace robosim::cli {

class SourceText {
 public:
  /// Where files may be: the sketch's folder, and folders of libraries or with libraries in them.
  explicit SourceText(std::vector<std::filesystem::path> folders) : folders_(std::move(folders)) {}

  /// Without the blanks around it; empty where it is not known.
  std::string line(const wire::SourceLine& where);
  /// The constants whose names stand in these lines, and that the compiler has put into them: those that the
  /// same files declare. Without lines if there are none.
  wire::Cause constants_in(const std::vector<wire::Cause>& chain);

 private:
  const std::vector<std::string>& lines_of(const std::string& file);
  std::vector<std::filesystem::path> paths_of(const std::filesystem::path& file) const;

  std::vector<std::filesystem::path> folders_;
  std::map<std::string, std::vector<std::string>> files_;
};

}  // namespace robosim::cli
