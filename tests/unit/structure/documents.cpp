#include "tests/unit/structure/documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "sim/base/file.h"

namespace robosim::structure {
namespace fs = std::filesystem;

namespace {

std::set<std::string> anchors_of(const std::string& markdown) {
  static const std::regex heading(R"(^#+ (.*)$)");
  static const std::regex named(R"re(<a id="([^"]*)"></a>)re");
  std::set<std::string> anchors;
  std::istringstream stream(markdown);
  std::string line;
  bool in_code = false;
  while (std::getline(stream, line)) {
    if (line.starts_with("```")) in_code = !in_code;
    std::smatch match;
    if (!in_code && std::regex_match(line, match, heading)) anchors.insert(anchor_of(match[1]));
    for (std::sregex_iterator it(line.begin(), line.end(), named), end; it != end; ++it)
      anchors.insert((*it)[1]);
  }
  return anchors;
}

class Checker {
 public:
  Checker(const Files& documents, std::string root) : documents_(documents), root_(std::move(root)) {}

  void line(const std::string& place, const fs::path& folder, const std::string& text, bool in_code) {
    static const std::regex link(R"(\]\(([^)\s]+)\))");
    static const std::regex code(R"(`([^`]+)`)");
    if (in_code) return;
    for (const std::string& target : found(text, link)) follow(place, folder, target);
    for (const std::string& words : found(text, code)) paths(place, words);
  }

  std::vector<std::string> dead;

 private:
  static std::vector<std::string> found(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> all;
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
      all.push_back((*it)[1]);
    return all;
  }

  void follow(const std::string& place, const fs::path& folder, const std::string& target) {
    if (target.find("://") != std::string::npos) return;
    const std::size_t hash = std::min(target.find('#'), target.size());
    const std::string file = hash == 0 ? place.substr(0, place.find(':'))
                                       : (folder / target.substr(0, hash)).lexically_normal().string();
    if (!documents_.count(file) && !fs::exists(fs::path(root_) / file)) {
      dead.push_back(fmt::format("{}: links to {}, which does not exist", place, file));
    } else if (hash < target.size() && documents_.count(file) &&
               !anchors_of(documents_.at(file)).count(target.substr(hash + 1))) {
      dead.push_back(
          fmt::format("{}: links to {}, which has no heading '{}'", place, file, target.substr(hash + 1)));
    }
  }

  void paths(const std::string& place, const std::string& words) {
    static const std::regex path(
        R"((^|\s)((sim|hal|firmware|tests|toolchain|docs|\.ci|\.github)/[A-Za-z0-9_./-]*[A-Za-z0-9_/])(?=$|[\s,:;)]))");
    for (std::sregex_iterator it(words.begin(), words.end(), path), end; it != end; ++it) {
      const std::string name = (*it)[2];
      if (name.find("NAME") == name.npos && !fs::exists(fs::path(root_) / name))
        dead.push_back(fmt::format("{}: names {}, which does not exist", place, name));
    }
  }

  const Files& documents_;
  std::string root_;
};

}  // namespace

std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const unsigned char c : heading) {
    if (c == ' ') {
      anchor += '-';
    } else if (std::isalnum(c) || c == '-' || c == '_') {
      anchor += static_cast<char>(std::tolower(c));
    }
  }
  return anchor;
}

std::vector<std::string> dead_references(const Files& documents, const std::string& root) {
  Checker checker(documents, root);
  for (const auto& [file, content] : documents) {
    std::istringstream stream(content);
    std::string line;
    bool in_code = false;
    for (int number = 1; std::getline(stream, line); ++number) {
      if (line.starts_with("```")) in_code = !in_code;
      checker.line(fmt::format("{}:{}", file, number), fs::path(file).parent_path(), line, in_code);
    }
  }
  return checker.dead;
}

std::vector<std::string> dead_functions(const Files& documents, const Files& sources) {
  static const std::regex function(R"(`(?:\w+::)*(\w+)\(\)`)");
  std::set<std::string> dead;
  for (const auto& [file, content] : documents) {
    for (std::sregex_iterator it(content.begin(), content.end(), function), end; it != end; ++it) {
      const std::string call = std::string((*it)[1]) + "(";
      const bool found = call.find("NAME") != call.npos ||
                         std::any_of(sources.begin(), sources.end(), [&](const auto& source) {
                           return source.second.find(call) != source.second.npos;
                         });
      if (!found) dead.insert(fmt::format("{}: names {}, which no source contains", file, it->str()));
    }
  }
  return {dead.begin(), dead.end()};
}

std::vector<std::string> dead_tests(const Files& documents, const Files& sources) {
  static const std::regex test(R"(`([A-Z]\w+)\.([A-Z]\w+)`)");
  static const std::regex definition(R"(TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\))");
  std::set<std::string> tests, dead;
  for (const auto& [file, content] : sources)
    for (std::sregex_iterator it(content.begin(), content.end(), definition), end; it != end; ++it)
      tests.insert((*it)[1].str() + "." + (*it)[2].str());
  for (const auto& [file, content] : documents)
    for (std::sregex_iterator it(content.begin(), content.end(), test), end; it != end; ++it)
      if (!tests.contains((*it)[1].str() + "." + (*it)[2].str()))
        dead.insert(fmt::format("{}: names the test {}, and no source has it", file, it->str()));
  return {dead.begin(), dead.end()};
}

std::vector<std::string> dead_mentions(const Files& sources, const std::string& root) {
  constexpr std::string_view kFolder = "docs/";
  std::vector<std::string> dead;
  for (const auto& [file, content] : sources) {
    for (auto at = content.find(kFolder); at != content.npos; at = content.find(kFolder, at + 1)) {
      const auto end = content.find_first_not_of("abcdefghijklmnopqrstuvwxyz-/", at + kFolder.size());
      if (end == content.npos || content.compare(end, 3, ".md") != 0) continue;
      const std::string name = content.substr(at, end + 3 - at);
      if (!fs::exists(fs::path(root) / name))
        dead.push_back(fmt::format("{}: names {}, which does not exist", file, name));
    }
  }
  return dead;
}

Files read_documents(const std::string& root) {
  Files files;
  const auto add = [&](const fs::path& file) {
    if (file.extension() == ".md") files[file.lexically_relative(root).string()] = read_file(file);
  };
  for (const auto& entry : fs::directory_iterator(root)) add(entry.path());
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(root) / "docs")) add(entry.path());
  return files;
}

}  // namespace robosim::structure
