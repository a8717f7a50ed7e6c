// Reads PlatformIO's platformio.ini: board, sources, headers, libraries and compiler flags of a project.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <optional>
#include <set>
#include <system_error>

#include "sim/build/project/board_names.h"
#include "sim/build/project/files.h"
#include "sim/build/project/ini.h"

namespace robosim::project {
namespace fs = std::filesystem;

namespace {

constexpr int kMostReferences = 10'000;
constexpr int kDeepest = 16;  ///< nesting of references and extended sections
constexpr const char* kEnvironment = "env:";

/// Returns the items of a list, one per line or separated by commas.
std::vector<std::string> list_of(const std::string& text) {
  std::vector<std::string> items;
  std::string item;
  const auto finish = [&] {
    const std::size_t first = item.find_first_not_of(' ');
    if (first != std::string::npos)
      items.push_back(item.substr(first, item.find_last_not_of(' ') - first + 1));
    item.clear();
  };
  for (const char c : text + "\n")
    if (c == '\n' || c == ',')
      finish();
    else
      item += c;
  return items;
}

/// Splits words like a shell.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  bool open = false;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote && c == quote) {
      quote = 0;
    } else if (c == '\\' && quote != '\'' && i + 1 < text.size()) {
      word += text[++i];
      open = true;
    } else if (!quote && (c == '"' || c == '\'')) {
      quote = c;
      open = true;
    } else if (!quote && (c == ' ' || c == '\t' || c == '\n')) {
      if (open) words.push_back(word);
      word.clear();
      open = false;
    } else {
      word += c;
      open = true;
    }
  }
  if (open) words.push_back(word);
  return words;
}

/// The settings of platformio.ini, with references resolved.
class Settings {
 public:
  explicit Settings(const fs::path& file) : path_(file), ini_(file) {
    for (const std::string& section : ini_.sections())
      if (section.rfind(kEnvironment, 0) == 0) environments_.push_back(section.substr(4));
  }

  const std::vector<std::string>& environments() const { return environments_; }

  /// Returns a value of the section [platformio].
  std::string common(const std::string& key, const std::string& otherwise) const {
    const IniValue* value = ini_.find("platformio", key);
    return value ? filled(*value, "platformio", 0) : otherwise;
  }

  /// Returns a value of an environment, of the environments that it extends, or of [env].
  const IniValue* find(const std::string& environment, const std::string& key) const {
    const IniValue* value = find_in(kEnvironment + environment, key);
    return value ? value : ini_.find("env", key);
  }

  std::string text(const std::string& environment, const std::string& key) const {
    const IniValue* value = find(environment, key);
    return value ? filled(*value, kEnvironment + environment, 0) : "";
  }

 private:
  const IniValue* find_in(const std::string& section, const std::string& key) const {
    std::set<std::string> without;
    return find_in(section, key, 0, without);
  }

  /// `without` contains the sections that are known to lack the key, so that each section is searched only
  /// once.
  const IniValue* find_in(const std::string& section, const std::string& key, int depth,
                          std::set<std::string>& without) const {
    if (without.count(section)) return nullptr;
    if (const IniValue* value = ini_.find(section, key)) return value;
    const IniValue* extends = ini_.find(section, "extends");
    if (!extends) return nullptr;
    if (depth == kDeepest)
      throw InputError({path_.string(), extends->line},
                       "extends: sections that extend each other in a circle");
    for (const std::string& other : list_of(extends->text))
      if (const IniValue* value = find_in(other, key, depth + 1, without)) return value;
    without.insert(section);
    return nullptr;
  }

  /// Returns the value of ${name}; nullopt if it is unknown.
  std::optional<std::string> value_of(const std::string& name, const std::string& section, int line,
                                      int depth) const {
    if (name == "PROJECT_DIR" || name == "platformio.project_dir")
      return fs::absolute(path_).parent_path().string();
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos) return std::nullopt;
    std::string in = name.substr(0, dot);
    const std::string key = name.substr(dot + 1);
    if (in == "this") in = section;
    if (key == "__env__") return in.substr(in.rfind(':') + 1);
    const IniValue* value = in.rfind(kEnvironment, 0) == 0 ? find(in.substr(4), key) : find_in(in, key);
    if (!value) return std::nullopt;
    if (depth == kDeepest)
      throw InputError({path_.string(), line}, fmt::format("${{{}}} refers to itself", name));
    if (++references_ > kMostReferences)
      throw InputError(
          {path_.string(), line},
          fmt::format("too many ${{…}}: expected at most {}; a value that is inserted twice counts twice",
                      kMostReferences));
    return filled(*value, in, depth + 1);
  }

  std::string filled(const IniValue& value, const std::string& section, int depth) const {
    std::string text;
    for (std::size_t at = 0;;) {
      const std::size_t begin = value.text.find("${", at);
      text += value.text.substr(at, begin - at);
      if (begin == std::string::npos) return text;
      const std::size_t end = value.text.find('}', begin);
      if (end == std::string::npos) return text + value.text.substr(begin);
      const std::string name = value.text.substr(begin + 2, end - begin - 2);
      text += value_of(name, section, value.line, depth).value_or("${" + name + "}");
      if (text.size() > kMostProjectFile_bytes)
        throw InputError({path_.string(), value.line},
                         "the value is too large: expected at most 1 MB after its ${…} are replaced");
      at = end + 1;
    }
  }

  fs::path path_;
  IniFile ini_;
  std::vector<std::string> environments_;
  mutable int references_ = 0;  ///< number of references so far
};

void set_board(Project& project, const Settings& settings) {
  project.board_name = settings.text(project.environment, "board");
  project.board = board_of_platformio(project.board_name);
  const IniValue* value = settings.find(project.environment, "board");
  project.board_place = {project.file.string(), value ? value->line : 0};
}

std::string choose(Project& project, const Settings& settings, const std::string& wanted) {
  std::vector<std::string> all = settings.environments();
  const auto is_one = [&](const std::string& name) {
    return std::find(all.begin(), all.end(), name) != all.end();
  };
  if (!wanted.empty()) {
    if (!is_one(wanted)) refuse_environment(project.file, "environment", wanted, all);
    return wanted;
  }
  std::vector<std::string> usual = list_of(settings.common("default_envs", ""));
  for (const std::string& name : usual)
    if (!is_one(name))
      throw InputError({project.file.string()}, fmt::format("default_envs: no such section [env:{}]", name));
  if (usual.empty()) usual = all;
  if (usual.empty())
    throw InputError({project.file.string()},
                     "the file has no environment: expected a section such as [env:uno]");
  for (const std::string& name : usual) {
    if (!board_of_platformio(settings.text(name, "board"))) continue;
    if (usual.size() > 1)
      project.remarks.push_back(
          fmt::format("{1}, one of {0} environments in platformio.ini, is used; choose another with --env",
                      usual.size(), name));
    return name;
  }
  return usual[0];
}

/// Returns whether a macro's definition is valid: NAME, NAME=value or NAME(parameters)=value, on one line.
bool is_macro(const std::string& text) {
  const auto in_name = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  const auto end = std::find_if_not(text.begin(), text.end(), in_name);
  return end != text.begin() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
         (end == text.end() || *end == '=' || *end == '(') && text.find('\n') == std::string::npos;
}

/// Uses only -D, -U and -I, because other options could name programs and files of this machine.
void take_flags(Project& project, const std::string& text, const fs::path& folder) {
  std::vector<std::string> left_out;
  const std::vector<std::string> words = words_of(text);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const std::string kind = word.substr(0, 2);
    if (kind == "-D" || kind == "-U" || kind == "-I") {
      std::string value = word.substr(2);
      if (value.empty() && i + 1 < words.size()) value = words[++i];
      if (kind == "-I")
        project.includes.push_back((folder / value).lexically_normal());
      else if (is_macro(value))
        project.flags.push_back(kind + value);
      else
        left_out.push_back(kind + value);
    } else if (kind != "-W" && kind != "-O" && kind != "-g" && word != "-w") {
      left_out.push_back(word);
    }
  }
  if (left_out.empty()) return;
  std::string names = fmt::format("{}", fmt::join(left_out, " "));
  std::replace(names.begin(), names.end(), '\n', ' ');
  project.remarks.push_back("only -D, -U and -I of build_flags are used; ignored: " + names);
}

bool is_folder(const fs::path& path) {
  std::error_code none;
  return fs::is_directory(path, none);
}

void take_libraries(Project& project, const Settings& settings, const fs::path& folder) {
  const auto add = [&](const fs::path& path) {
    if (is_folder(path)) project.libraries.push_back(path.lexically_normal());
  };
  add(folder / settings.common("lib_dir", "lib"));
  const fs::path fetched = folder / settings.common("libdeps_dir", ".pio/libdeps") / project.environment;
  add(fetched);
  const std::string extra = settings.text(project.environment, "lib_extra_dirs");
  for (const std::string& path : list_of(extra)) add(folder / path);
  const auto wanted = list_of(settings.text(project.environment, "lib_deps"));
  if (!wanted.empty() && !is_folder(fetched))
    project.remarks.push_back(fmt::format(
        "lib_deps names {}, but {} does not exist yet (“pio pkg install” fetches it); Robosim searches "
        "elsewhere for libraries",
        wanted.size() == 1 ? wanted[0] : fmt::format("{} libraries", wanted.size()),
        fetched.lexically_relative(folder).string()));
}

void check_framework(const Project& project, const Settings& settings) {
  const auto frameworks = list_of(settings.text(project.environment, "framework"));
  if (!project.board || frameworks.empty() ||
      std::find(frameworks.begin(), frameworks.end(), "arduino") != frameworks.end())
    return;
  const IniValue* value = settings.find(project.environment, "framework");
  throw InputError(
      {project.file.string(), value->line},
      fmt::format("framework: expected arduino, got {}; for another framework, let PlatformIO build "
                  "firmware.elf, and run that file",
                  frameworks[0]));
}

}  // namespace

Project read_platformio(const fs::path& given, const std::string& wanted) {
  const fs::path folder = fs::absolute(given).lexically_normal();
  Project project;
  project.platformio = true;
  project.file = (given / "platformio.ini").lexically_normal();
  const Settings settings(project.file);
  project.environment = choose(project, settings, wanted);
  set_board(project, settings);
  check_framework(project, settings);
  project.sources = (folder / settings.common("src_dir", "src")).lexically_normal();
  if (!is_folder(project.sources))
    throw InputError({project.sources.string()},
                     "no such folder; platformio.ini names it as the folder of the sources");
  project.includes = {(folder / settings.common("include_dir", "include")).lexically_normal()};
  take_flags(project,
             settings.text(project.environment, "build_flags") + "\n" +
                 settings.text(project.environment, "build_src_flags"),
             folder);
  take_libraries(project, settings, folder);
  std::erase_if(project.includes, [](const fs::path& path) { return !is_folder(path); });
  return project;
}

}  // namespace robosim::project
