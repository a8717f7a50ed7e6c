// Reads the text of source lines from the sketch's files. An image contains only file names and line numbers.
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim/result/run_result.h"

namespace robosim::cli {

/// The text of a cause that contains declarations of names.
inline constexpr const char* kNamed = "named in these lines";

class SourceText {
 public:
  /// Looks for the files in `sketch`, the sketch's folder, and in `folders`: folders of single libraries, and
  /// folders that contain libraries. A sketch that is not `trusted` may not name files outside its folder.
  SourceText(std::filesystem::path sketch, std::vector<std::filesystem::path> folders, bool trusted);

  /// Returns a line without blanks at its ends; empty if the line is unknown.
  std::string line(const result::SourceLine& where);
  /// Returns the line without its comment, its `#define` and its semicolon.
  std::string declaration(const result::SourceLine& where);
  /// Removes lines without information, except the first line of a cause. Adds facts from the source that
  /// instructions do not show:
  /// - functions that write the `volatile` variables in these lines, and lines with these functions' names,
  ///   such as attachInterrupt() calls;
  /// - local variables that are declared without a value;
  /// - constants and objects that the lines or their declarations name, also in files of the same folder.
  void explain(std::vector<result::Cause>& chain);

 private:
  const std::vector<std::string>& lines_of(const std::string& file);
  std::vector<std::filesystem::path> paths_of(const std::filesystem::path& file) const;
  std::string file_that_declares(const std::string& name, const std::string& file);
  /// Returns the headers and the .ino files in the folder of a file.
  const std::vector<std::string>& beside(const std::string& file);
  /// Returns constants and objects outside functions, with their lines.
  const std::multimap<std::string, int>& declarations_in(const std::string& file);
  /// Returns whether a line has no information: it contains only a brace, or a function's head. The
  /// instructions of a head only save registers.
  bool says_nothing(const result::SourceLine& where);
  result::Cause writers_in(const std::deque<result::SourceLine>& chain);
  void add_handler(result::Cause& writers, const std::string& file, std::size_t at,
                   const std::string& function);
  result::Cause without_value_in(const std::deque<result::SourceLine>& chain);
  result::Cause named_in(std::deque<result::SourceLine> chain);
  void add(result::Cause& cause, const result::SourceLine& where, std::size_t most);

  std::vector<std::filesystem::path> folders_;  ///< begins with the sketch's folder
  const bool trusted_;
  std::map<std::string, std::vector<std::string>> files_;
  std::map<std::string, std::multimap<std::string, int>> declarations_;
  std::map<std::string, std::vector<std::string>> beside_;  ///< by folder
  std::set<std::pair<std::string, int>> had_;
  std::size_t read_bytes_ = 0;  ///< total size of the read files; limited, since a folder may be large
};

}  // namespace robosim::cli
