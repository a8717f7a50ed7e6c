// The syntax tree of a sketch, as clang writes it down (-ast-dump=json): of the sketch's own files only.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/build/reading.h"

namespace robosim::mutate {

/// A stretch of a file.
struct Range {
  std::size_t file = 0;  ///< of Tree::files
  std::size_t from = 0, to = 0;
};

struct File {
  std::string name;  ///< relative to the sketch's folder; one of a library by its whole path
  std::string text;
  std::filesystem::path path;  ///< as it was parsed: .ino files are joined
  std::size_t offset = 0;      ///< where its text begins there
};

struct Tree {
  std::vector<File> files;  ///< joined ones in their order
  /// The declarations in these files. Each place in it has a member "in": the number of its file, of joined
  /// ones that of the first, or -1.
  std::vector<nlohmann::json> declarations;
  std::size_t added_at = 0, added = 0;  ///< prototypes, in what the .ino files were joined to
};

/// Parses all sources of the sketch, and those files of its libraries that are named, too: each by its whole
/// path. Of a header that no source includes nothing is found. Throws ToolMissing if there is no clang.
Tree parse(const build::Reading& reading, const std::vector<std::filesystem::path>& of_libraries = {});

/// What a node covers: nothing if it is not in one of the files, or begins or ends in a macro.
std::optional<Range> range_of(const Tree& tree, const nlohmann::json& node);
std::string text_of(const Tree& tree, const Range& range);

/// The tree that clang has written. `number_of`: of the file at that path, or -1. Declarations elsewhere are
/// left out.
nlohmann::json read_tree(const std::string& dump, const std::function<int(const std::string&)>& number_of);

}  // namespace robosim::mutate
