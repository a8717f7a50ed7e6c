// The text of a sketch's lines, as far as its files are found: an image knows where lines are, not what they
// say.
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim/wire/run_result.h"

namespace robosim::cli {

class SourceText {
 public:
  /// Where files may be: the sketch's folder, and folders of libraries or with libraries in them.
  explicit SourceText(std::vector<std::filesystem::path> folders) : folders_(std::move(folders)) {}

  /// Without the blanks around it; empty where it is not known.
  std::string line(const wire::SourceLine& where);
  /// Leaves out lines that say nothing, and adds what the instructions cannot tell, found in the same files:
  /// - who writes the `volatile` variables that are read, and who names those functions (attachInterrupt());
  /// - variables of functions that are declared without a value;
  /// - constants and objects that the lines name, and those that their declarations name; they may be in the
  ///   files beside.
  void explain(std::vector<wire::Cause>& chain);

 private:
  const std::vector<std::string>& lines_of(const std::string& file);
  std::vector<std::filesystem::path> paths_of(const std::filesystem::path& file) const;
  std::string file_that_declares(const std::string& name, const std::string& file);
  /// The headers, and tabs of the sketch, in the folder of a file.
  const std::vector<std::string>& beside(const std::string& file);
  /// Constants and objects outside functions, with their lines.
  const std::multimap<std::string, int>& declarations_in(const std::string& file);
  /// A brace, or a function's head, where only registers are saved.
  bool says_nothing(const wire::SourceLine& where);
  wire::Cause writers_in(const std::deque<wire::SourceLine>& chain);
  void add_handler(wire::Cause& writers, const std::string& file, std::size_t at,
                   const std::string& function);
  wire::Cause without_value_in(const std::deque<wire::SourceLine>& chain);
  wire::Cause named_in(std::deque<wire::SourceLine> chain);
  void add(wire::Cause& cause, const wire::SourceLine& where, std::size_t most);

  std::vector<std::filesystem::path> folders_;
  std::map<std::string, std::vector<std::string>> files_;
  std::map<std::string, std::multimap<std::string, int>> declarations_;
  std::map<std::string, std::vector<std::string>> beside_;  ///< by folder
  std::set<std::pair<std::string, int>> had_;
};

}  // namespace robosim::cli
