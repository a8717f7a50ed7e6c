#include "tests/unit/structure/include_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

#include "sim/base/error.h"
#include "sim/base/file.h"

namespace robosim::structure {
namespace fs = std::filesystem;

namespace {

bool is_below(std::string_view path, std::string_view folder) {
  return folder == "*" ||
         (path.starts_with(folder) && (path.size() == folder.size() || path[folder.size()] == '/'));
}

bool is_below_any(std::string_view path, const std::vector<std::string>& folders) {
  return std::any_of(folders.begin(), folders.end(),
                     [&](const auto& folder) { return is_below(path, folder); });
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::optional<std::string> resolve(const std::string& header, const std::string& file,
                                   const IncludeTable& table, const Files& files) {
  std::vector<fs::path> folders{fs::path(file).parent_path()};
  folders.insert(folders.end(), table.search.begin(), table.search.end());
  for (const fs::path& folder : folders) {
    const std::string path = (folder / header).lexically_normal().string();
    if (files.count(path)) return path;
  }
  return std::nullopt;
}

const std::pair<const std::string, std::vector<std::string>>* row_of(const std::string& file,
                                                                     const IncludeTable& table) {
  const std::pair<const std::string, std::vector<std::string>>* longest = nullptr;
  for (const auto& row : table.rows) {
    if (is_below(file, row.first) && (!longest || row.first.size() > longest->first.size())) longest = &row;
  }
  return longest;
}

}  // namespace

IncludeTable read_include_table(const std::string& file, std::string_view text) {
  IncludeTable table;
  std::istringstream stream{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    line.erase(std::min(line.find('#'), line.size()));
    if (words_of(line).empty()) continue;
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) throw InputError({file, number}, "expected 'FOLDER: FOLDERS'");
    const std::string key = line.substr(0, colon);
    const std::vector<std::string> folders = words_of(line.substr(colon + 1));
    if (key == "search") {
      table.search = folders;
    } else if (key.starts_with('<')) {
      table.alone[key.substr(1)] = folders;
    } else {
      table.rows[key] = folders;
    }
  }
  return table;
}

std::vector<std::string> broken_rules(const IncludeTable& table, const Files& files) {
  static const std::regex include(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
  std::vector<std::string> broken;
  for (const auto& [file, content] : files) {
    const auto* row = row_of(file, table);
    if (!row) {
      broken.push_back(fmt::format("{}: its folder has no row in the table", file));
      continue;
    }
    std::istringstream stream(content);
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
      std::smatch match;
      if (!std::regex_search(line, match, include)) continue;
      const std::string header = match[2];
      for (const auto& [start, folders] : table.alone) {
        if (header.starts_with(start) && !is_below_any(file, folders)) {
          broken.push_back(fmt::format("{}:{}: includes {}; only these may: {}", file, number, header,
                                       fmt::join(folders, ", ")));
        }
      }
      if (const auto target = resolve(header, file, table, files)) {
        if (is_below(*target, row->first) || is_below_any(*target, row->second)) continue;
        broken.push_back(fmt::format(
            "{}:{}: includes {}; {} may include, besides its own files: {}", file, number, *target,
            row->first, row->second.empty() ? "nothing" : fmt::format("{}", fmt::join(row->second, ", "))));
        continue;
      }
      if (match[1] == "\"" && is_below_any(header, {"sim", "hal", "firmware", "tests"})) {
        broken.push_back(fmt::format("{}:{}: includes {}, which does not exist", file, number, header));
      }
    }
  }
  return broken;
}

std::vector<std::string> foreign_namespaces(const IncludeTable& table, const Files& files) {
  static const std::regex opening(R"(^namespace robosim::([a-z_]+)\b)");
  std::map<std::string, std::map<std::string, int>> openings;  // number of files, by namespace and folder
  std::map<std::string, std::set<std::string>> opened;         // namespaces, by file
  for (const auto& [file, content] : files) {
    const auto* row = row_of(file, table);
    if (!row || !file.starts_with("sim/")) continue;
    std::istringstream stream(content);
    std::string line;
    while (std::getline(stream, line)) {
      std::smatch match;
      if (!std::regex_search(line, match, opening) || !opened[file].insert(match[1]).second) continue;
      ++openings[match[1]][row->first];
    }
  }
  std::vector<std::string> foreign;
  for (const auto& [file, names] : opened) {
    const auto* row = row_of(file, table);
    for (const std::string& name : names) {
      const auto& folders = openings[name];
      const auto home = std::max_element(folders.begin(), folders.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
      if (is_below(home->first, row->first) || is_below_any(home->first, row->second)) continue;
      foreign.push_back(fmt::format("{}: opens the namespace {} of {}, which {} may not include", file, name,
                                    home->first, row->first));
    }
  }
  return foreign;
}

std::vector<std::string> include_cycles(const IncludeTable& table, const Files& files) {
  static const std::regex include(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
  std::map<std::string, std::vector<std::string>> included;
  for (const auto& [file, content] : files) {
    std::istringstream stream(content);
    std::string line;
    while (std::getline(stream, line)) {
      std::smatch match;
      if (!std::regex_search(line, match, include)) continue;
      if (const auto target = resolve(match[1], file, table, files)) included[file].push_back(*target);
    }
  }
  std::vector<std::string> cycles, path;
  std::set<std::string> done;
  const std::function<void(const std::string&)> visit = [&](const std::string& file) {
    if (const auto begin = std::find(path.begin(), path.end(), file); begin != path.end()) {
      cycles.push_back(fmt::format("{} > {}", fmt::join(begin, path.end(), " > "), file));
      return;
    }
    if (done.count(file)) return;
    path.push_back(file);
    for (const std::string& next : included[file]) visit(next);
    path.pop_back();
    done.insert(file);
  };
  for (const auto& [file, content] : files) visit(file);
  return cycles;
}

Files read_sources(const std::string& root) {
  Files files;
  for (const char* folder : {"hal", "firmware", "sim", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(root) / folder)) {
      const std::string extension = entry.path().extension().string();
      if (!entry.is_regular_file()) continue;
      if (extension != ".h" && extension != ".c" && extension != ".cpp" && extension != ".ino") continue;
      files[entry.path().lexically_relative(root).string()] = read_file(entry.path());
    }
  }
  return files;
}

}  // namespace robosim::structure
