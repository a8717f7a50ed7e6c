#include "sim/campaign/mutate/syntax.h"

#include <algorithm>
#include <functional>
#include <set>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/build/cache.h"
#include "sim/build/process.h"

namespace robosim::mutate {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

const json kNothing;

const json& member(const json& node, const char* name) {
  if (!node.is_object()) return kNothing;
  const auto found = node.find(name);
  return found == node.end() ? kNothing : *found;
}

/// Returns whether a declaration is in a known file. The class Places must have completed its source
/// locations.
bool is_own(const json& declaration) {
  const json& loc = member(declaration, "loc");
  const json& place = loc.contains("expansionLoc") ? loc["expansionLoc"] : loc;
  return place.is_object() && place.value("in", -1) >= 0;
}

/// Adds the number of its file to each source location. clang's dump names a file only if it differs from the
/// file of the previous location.
class Places {
 public:
  explicit Places(const std::function<int(const std::string&)>& number_of) : number_of_(number_of) {}

  bool operator()(int depth, json::parse_event_t event, json& parsed) {
    switch (event) {
      case json::parse_event_t::key:
        key_ = parsed.get<std::string>();
        if (key_ == "includedFrom") included_ = true;
        return true;
      case json::parse_event_t::value:
        if (key_ == "file" && !included_ && parsed.is_string()) file_ = number_of_(parsed.get<std::string>());
        return true;
      case json::parse_event_t::object_end:
        if (included_ && !parsed.contains("offset") && parsed.contains("file")) {
          included_ = false;
          return true;
        }
        if (parsed.contains("offset")) parsed["in"] = file_;
        return depth != kOfDeclarations || is_own(parsed);
      default:
        return true;
    }
  }

 private:
  static constexpr int kOfDeclarations = 2;  ///< JSON depth of the translation unit's declarations
  const std::function<int(const std::string&)>& number_of_;
  std::string key_;
  int file_ = -1;
  bool included_ = false;
};

/// Memory limit of clang. A syntax tree with all of Arduino's headers fits.
constexpr std::size_t kClang_bytes = std::size_t{1} << 30;

fs::path find_clang() {
  for (const char* name : {"clang++", "clang++-14", "clang++-19", "clang++-16"})
    if (const fs::path found = build::find_program(name); !found.empty()) return found;
  throw ToolMissing(
      "clang++ is not installed, but mutants are drawn from the syntax tree that it gives: apt-get install "
      "clang");
}

/// Returns the syntax tree of a source. `scratch` is a folder to which clang may write, and which may contain
/// `source`.
json dump(const fs::path& clang, const build::ParseContext& context, const fs::path& scratch,
          const fs::path& source, const std::function<int(const std::string&)>& number_of) {
  // Drops clang's messages, which are useless if clang understands a source only partly, and would be mixed
  // into the tree.
  std::vector<std::string> words = {"/bin/sh",
                                    "-c",
                                    "exec \"$@\" 2>/dev/null",
                                    "sh",
                                    clang.string(),
                                    "-x",
                                    "c++",
                                    "-fsyntax-only",
                                    "-ferror-limit=0",
                                    "-Xclang",
                                    "-ast-dump=json"};
  words.insert(words.end(), context.words.begin(), context.words.end());
  words.push_back(source.string());
  build::Command command{words, context.sketch.folder, {}, scratch};
  command.most_output = kMostFile_bytes;
  command.most_memory = kClang_bytes;
  std::vector<fs::path> readable = context.readable;
  readable.insert(readable.end(), {clang.parent_path(), source.parent_path()});
  const build::CommandResult result = build::run_within(readable, {command})[0];
  if (!result.output.starts_with("{"))
    throw InputError({source.string()}, "clang gives no syntax tree of this file");
  return read_tree(result.output, number_of);
}

/// Returns declarations, as text, of the functions that are defined in the joined .ino files. Arduino inserts
/// them before the first function.
std::string prototypes(const std::string& joined, const json& unit, std::size_t& first) {
  std::string text;
  first = joined.size();
  for (const json& node : member(unit, "inner")) {
    if (member(node, "kind") != "FunctionDecl") continue;
    const json& begin = member(member(node, "range"), "begin");
    const std::size_t from = begin.value("offset", joined.size());
    for (const json& part : member(node, "inner")) {
      if (member(part, "kind") != "CompoundStmt") continue;
      const std::size_t to = member(member(part, "range"), "begin").value("offset", std::size_t{0});
      if (to <= from || to > joined.size()) break;
      const std::string head = joined.substr(from, to - from);
      first = std::min(first, from);
      if (head.find('=') == std::string::npos) text += head + ";\n";
    }
  }
  return text;
}

}  // namespace

json read_tree(const std::string& dump, const std::function<int(const std::string&)>& number_of) {
  Places places(number_of);
  return json::parse(
      dump, [&](int depth, json::parse_event_t event, json& parsed) { return places(depth, event, parsed); });
}

Tree parse(const build::ParseContext& context, const std::vector<fs::path>& of_libraries) {
  const fs::path clang = find_clang();
  const build::WorkFolder work((build::Cache(build::cache_folder())));
  const fs::path scratch = fs::weakly_canonical(work.path());
  const build::Sketch& sketch = context.sketch;
  Tree tree;
  const auto add = [&](const std::string& name, const fs::path& path, std::size_t offset) {
    tree.files.push_back({name, read_file(sketch.folder / name), path, offset});
  };
  const auto add_declarations = [&](json unit) {
    for (json& node : unit["inner"]) tree.declarations.push_back(std::move(node));
  };
  for (const auto* names : {&sketch.headers, &sketch.sources})
    for (const std::string& name : *names) add(name, fs::weakly_canonical(sketch.folder / name), 0);
  for (const fs::path& file : of_libraries) add(file.string(), fs::weakly_canonical(file), 0);
  const auto number_of = [&](const std::string& path) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(path, error);
    for (std::size_t i = 0; i < tree.files.size(); ++i)
      if (tree.files[i].path == whole) return static_cast<int>(i);
    return -1;
  };
  for (const std::string& name : sketch.sources)
    add_declarations(dump(clang, context, scratch, sketch.folder / name, number_of));
  for (const fs::path& file : of_libraries)
    if (file.extension() == ".cpp") add_declarations(dump(clang, context, scratch, file, number_of));
  if (sketch.inos.empty()) return tree;

  const fs::path source = scratch / "joined.cpp";
  std::string joined = "#include <Arduino.h>\n";
  for (const std::string& name : sketch.inos) {
    add(name, source, joined.size());
    joined += tree.files.back().text + '\n';
  }
  write_file(source, joined);
  const std::string added =
      prototypes(joined, dump(clang, context, scratch, source, number_of), tree.added_at);
  tree.added = added.size();
  write_file(source, joined.insert(tree.added_at, added));
  add_declarations(dump(clang, context, scratch, source, number_of));
  return tree;
}

std::optional<Range> range_of(const Tree& tree, const json& node) {
  const json& begin = member(member(node, "range"), "begin");
  const json& end = member(member(node, "range"), "end");
  if (!begin.is_object() || !end.is_object() || begin.value("in", -1) < 0 || end.value("in", -1) < 0)
    return std::nullopt;
  const auto in = begin["in"].get<std::size_t>();
  if (end["in"] != in) return std::nullopt;
  std::size_t from = begin.value("offset", std::size_t{0});
  std::size_t to = end.value("offset", std::size_t{0}) + end.value("tokLen", std::size_t{0});
  std::size_t file = in;
  const auto is_joined = [&](std::size_t i) { return i < tree.files.size() && tree.files[i].offset > 0; };
  if (is_joined(in)) {
    if (from >= tree.added_at) {
      if (from < tree.added_at + tree.added) return std::nullopt;
      from -= tree.added, to -= tree.added;
    }
    while (is_joined(file + 1) && tree.files[file + 1].offset <= from) ++file;
    from -= tree.files[file].offset, to -= tree.files[file].offset;
  }
  if (from >= to || to > tree.files[file].text.size()) return std::nullopt;
  return Range{file, from, to};
}

std::string text_of(const Tree& tree, const Range& range) {
  return tree.files[range.file].text.substr(range.from, range.to - range.from);
}

}  // namespace robosim::mutate
