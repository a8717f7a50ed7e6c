#include "tests/unit/structure/hidden_functions.h"

#include <fmt/format.h>

#include <regex>
#include <set>
#include <sstream>

namespace robosim::structure {
namespace {

using Names = std::set<std::string>;

/// Returns the free function whose declaration or definition begins on this line, or "". Skips indented
/// lines, because they contain members.
std::string function_of(const std::string& line) {
  static const std::regex begin(R"([\w\[][^=(]*[\s*&](\w+)\()");
  std::smatch match;
  const bool found = std::regex_search(line, match, begin, std::regex_constants::match_continuous);
  return found ? match[1].str() : "";
}

/// Returns all free functions of a header, or the functions in a source's anonymous namespaces.
Names functions_of(const std::string& content, bool header) {
  Names names;
  std::istringstream lines(content);
  bool anonymous = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == "namespace {" || line == "}  // namespace") anonymous = line.starts_with('n');
    if (header || anonymous) names.insert(function_of(line));
  }
  names.erase("");
  return names;
}

/// Returns whether a source calls a free function without qualifying its name. A name after a type is a
/// declaration, not a call.
bool calls(const std::string& content, const std::string& function) {
  const std::regex call(R"((^|[^\w.:>&*\s]|\s[>*&]+\s|[\s(!,][*&]|\b(return|else|throw|case)\s)\s*)" +
                        function + R"(\()");
  std::istringstream lines(content);
  for (std::string line; std::getline(lines, line);) {
    const std::string code = line.substr(0, line.find("//"));
    if (code.find(function) != code.npos && std::regex_search(code, call)) return true;
  }
  return false;
}

/// Adds the headers that a file includes, directly or indirectly, to `reached`.
void follow(const std::string& file, const Files& files, Names& reached) {
  static const std::regex include(R"re(^#include "([^"]+)")re");
  std::istringstream lines(files.at(file));
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("#include") || !std::regex_search(line, match, include)) continue;
    for (const char* folder : {"", "sim/testing/"}) {
      const std::string header = folder + match[1].str();
      if (files.count(header) && reached.insert(header).second) follow(header, files, reached);
    }
  }
}

/// Returns the innermost of the libraries' folders that contains the file, or "".
std::string library_of(const std::string& file, const std::set<std::string>& libraries) {
  std::string folder = file;
  while (!folder.empty() && !libraries.count(folder)) {
    const std::size_t slash = folder.rfind('/');
    folder.resize(slash == folder.npos ? 0 : slash);
  }
  return folder;
}

}  // namespace

std::vector<std::string> hidden_functions(const Files& files, const std::set<std::string>& libraries) {
  std::map<std::string, Names> headers_with, own;
  std::map<std::string, std::vector<std::string>> sources;
  for (const auto& [file, content] : files) {
    if (file.ends_with(".h")) {
      for (const std::string& function : functions_of(content, true)) headers_with[function].insert(file);
    } else if (file.ends_with(".cpp")) {
      own[file] = functions_of(content, false);
      sources[library_of(file, libraries)].push_back(file);
    }
  }
  std::vector<std::string> hidden;
  for (const auto& [file, functions] : own) {
    for (const std::string& function : functions) {
      if (!headers_with.count(function)) continue;
      for (const std::string& mate : sources[library_of(file, libraries)]) {
        if (mate == file || own[mate].count(function) || !calls(files.at(mate), function)) continue;
        Names included;
        follow(mate, files, included);
        for (const std::string& header : headers_with[function]) {
          if (!included.count(header)) continue;
          hidden.push_back(
              fmt::format("{}: its own {}() may be called by {}, which means that of {}, where both are "
                          "compiled as one file",
                          file, function, mate, header));
        }
      }
    }
  }
  return hidden;
}

}  // namespace robosim::structure
