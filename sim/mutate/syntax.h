// The syntax tree of a sketch, from clang's dump (-ast-dump=json): only of the sketch's own files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/build/parse_context.h"

namespace robosim::mutate {

/// A range of a file.
struct Range {
  std::size_t file = 0;  ///< of Tree::files
  std::size_t from = 0, to = 0;
};

struct File {
  std::string name;  ///< relative to the sketch's folder; for a library the whole path
  std::string text;
  std::filesystem::path path;  ///< as parsed: .ino files are joined
  std::size_t offset = 0;      ///< where its text begins in that
};

struct Tree {
  std::vector<File> files;  ///< joined ones in their order
  /// The declarations in these files. Each place in it has a member "in": the number of its file, for joined
  /// ones that of the first, or -1.
  std::vector<nlohmann::json> declarations;
  std::size_t added_at = 0, added = 0;  ///< prototypes in the joined .ino files
};

/// Parses all sources of the sketch, and also the named files of its libraries, by their whole paths. A
/// header that no source includes yields nothing. Throws ToolMissing if clang is not installed.
Tree parse(const build::ParseContext& context, const std::vector<std::filesystem::path>& of_libraries = {});

/// Returns the range of a node: nothing if it is not in one of the files, or begins or ends in a macro.
std::optional<Range> range_of(const Tree& tree, const nlohmann::json& node);
std::string text_of(const Tree& tree, const Range& range);

/// Reads clang's tree. `number_of` returns the file's number by path, or -1. Declarations elsewhere are
/// skipped.
nlohmann::json read_tree(const std::string& dump, const std::function<int(const std::string&)>& number_of);

}  // namespace robosim::mutate
