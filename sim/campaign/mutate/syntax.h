// Reads the syntax tree of a sketch and of chosen library files from clang's dump (-ast-dump=json).
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
  std::size_t file = 0;  ///< index in Tree::files
  std::size_t from = 0, to = 0;
};

struct File {
  std::string name;  ///< relative to the sketch's folder; for a library, the whole path
  std::string text;
  std::filesystem::path path;  ///< the file that clang parses; for .ino files, the joined file
  std::size_t offset = 0;      ///< where the text begins in the joined file, before prototypes are inserted
};

struct Tree {
  std::vector<File> files;  ///< all files; .ino files are in the order in which they are joined
  /// The declarations in `files`. Each source location of a declaration has a member "in": an index in
  /// `files`, or -1 for another file. For all joined .ino files, "in" is the index of the first.
  std::vector<nlohmann::json> declarations;
  std::size_t added_at = 0, added = 0;  ///< offset and size of the inserted prototypes
};

/// Parses all sources of the sketch, and files of its libraries (`of_libraries`, whole paths). A header that
/// no source includes contributes no declarations. Throws ToolMissing if clang is not installed.
Tree parse(const build::ParseContext& context, const std::vector<std::filesystem::path>& of_libraries = {});

/// Returns the range of a node. Returns nothing if the node is not in one of the files, or begins or ends in
/// a macro.
std::optional<Range> range_of(const Tree& tree, const nlohmann::json& node);
std::string text_of(const Tree& tree, const Range& range);

/// Reads clang's tree. `number_of` returns the number of the file at a path, or -1. Declarations in other
/// files are skipped.
nlohmann::json read_tree(const std::string& dump, const std::function<int(const std::string&)>& number_of);

}  // namespace robosim::mutate
