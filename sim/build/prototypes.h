// Adds prototypes for the functions of joined .ino files, like the Arduino builder. arduino-ctags finds the
// functions in the preprocessed source, and the prototypes are inserted before the first function.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robosim::build {

/// A function or variable in ctags' list.
struct Tag {
  std::string name;
  std::string file;
  int line = 0;
  std::string kind;       ///< "function", "prototype", "variable", "struct"
  std::string scope;      ///< name of the surrounding class, struct or namespace
  std::string signature;  ///< "(int a, char b)"
  std::string type;       ///< result type
  std::string code;       ///< the source line
};

/// Returns the lines of the sketch's .ino files, with #line directives. Lines from headers are removed.
std::string own_lines(const std::string& preprocessed, const std::vector<std::string>& inos);

/// Reads ctags' list (`--fields=KSTtzns`).
std::vector<Tag> parse_tags(const std::string& listing);

/// Returns `joined` with the prototypes. `own` contains the preprocessed lines of `joined`. Default arguments
/// move from a function to its prototype, because C++ allows them only once.
std::string insert_prototypes(const std::string& joined, const std::string& own,
                              const std::vector<Tag>& tags);

/// Performs the three steps above: own_lines(), parse_tags(), insert_prototypes(). `work` is a folder for
/// ctags' files.
std::string add_prototypes(const std::string& joined, const std::string& preprocessed,
                           const std::vector<std::string>& inos, const std::filesystem::path& work);

}  // namespace robosim::build
