// Prototypes for the functions of joined .ino files, as the Arduino builder makes them: found by
// arduino-ctags in the preprocessed source, and inserted before the first function.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robosim::build {

/// A function or variable as ctags lists it.
struct Tag {
  std::string name;
  std::string file;
  int line = 0;
  std::string kind;       ///< "function", "prototype", "variable", "struct"
  std::string scope;      ///< class, struct or namespace it belongs to
  std::string signature;  ///< "(int a, char b)"
  std::string type;       ///< of the result
  std::string code;       ///< the source line
};

/// The lines that come from the sketch's .ino files, with #line directives; all that headers bring is left
/// out.
std::string own_lines(const std::string& preprocessed, const std::vector<std::string>& inos);

/// Reads ctags' listing (`--fields=KSTtzns`).
std::vector<Tag> parse_tags(const std::string& listing);

/// `joined` with the prototypes in it; `own` are its preprocessed lines. Where a function has default
/// arguments, they move to its prototype: C++ allows them once.
std::string insert_prototypes(const std::string& joined, const std::string& own,
                              const std::vector<Tag>& tags);

/// All three steps; `work` is a folder for ctags' files.
std::string add_prototypes(const std::string& joined, const std::string& preprocessed,
                           const std::vector<std::string>& inos, const std::filesystem::path& work);

}  // namespace robosim::build
