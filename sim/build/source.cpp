#include "sim/build/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <system_error>

#include "sim/base/did_you_mean.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/utf8.h"
#include "sim/build/lexing.h"
#include "sim/build/project.h"
#include "sim/build/sketch.h"

namespace robosim::build {
namespace fs = std::filesystem;

bool is_source(const fs::path& path) {
  const fs::path extension = path.extension();
  return extension == ".cpp" || extension == ".c" || extension == ".cc" || extension == ".cxx";
}

bool is_ino(const fs::path& path) { return path.extension() == ".ino" || path.extension() == ".pde"; }

bool is_header(const fs::path& path) {
  const fs::path extension = path.extension();
  return extension == ".h" || extension == ".hpp" || extension == ".hh" || extension == ".ipp" ||
         extension == ".tpp" || extension == ".inc";
}

std::vector<std::string> headers_in(const fs::path& folder) {
  constexpr int kMostFiles = 20'000;
  std::vector<std::string> headers;
  std::error_code error;
  int files = 0;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator entry(folder, options, error), end;
       !error && entry != end && ++files < kMostFiles; entry.increment(error)) {
    const fs::path& path = entry->path();
    if (path.filename().string().starts_with('.')) entry.disable_recursion_pending();
    if (is_header(path)) headers.push_back(path.lexically_relative(folder).string());
  }
  std::sort(headers.begin(), headers.end());
  return headers;
}

namespace {

bool hidden(const fs::path& path) { return path.filename().string()[0] == '.'; }

void take(Sketch& sketch, const fs::path& file) {
  const std::string name = file.lexically_relative(sketch.folder).string();
  if (is_source(file)) sketch.sources.push_back(name);
  if (is_header(file)) sketch.headers.push_back(name);
  if (file.extension() == ".S" || file.extension() == ".s") sketch.assembler.push_back(name);
}

/// Throws InputError if `folder` or a folder below it cannot be read. A missing folder is not an error.
void check_all_read(const fs::path& folder, const std::error_code& error) {
  if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory)
    throw InputError({folder.string()}, "cannot read this folder or a subfolder: " + error.message());
}

void take_all_below(Sketch& sketch, const fs::path& folder) {
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; entry != end; entry.increment(error)) {
    if (hidden(entry->path())) {
      entry.disable_recursion_pending();
      continue;
    }
    if (entry->is_regular_file()) take(sketch, entry->path());
  }
  check_all_read(folder, error);
}

void take_headers(Sketch& sketch, const fs::path& folder) {
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; entry != end; entry.increment(error))
    if (entry->is_regular_file() && is_header(entry->path()))
      sketch.headers.push_back(entry->path().lexically_relative(sketch.folder).string());
  check_all_read(folder, error);
}

void sort(Sketch& sketch) {
  std::sort(sketch.sources.begin(), sketch.sources.end());
  std::sort(sketch.assembler.begin(), sketch.assembler.end());
  std::sort(sketch.headers.begin(), sketch.headers.end());
}

// Adds the files of the folder itself and, at any depth, of src/.
void take_folder(Sketch& sketch) {
  for (const auto& entry : fs::directory_iterator(sketch.folder))
    if (entry.is_regular_file() && !hidden(entry.path())) take(sketch, entry.path());
  take_all_below(sketch, sketch.folder / "src");
  sort(sketch);
}

std::vector<std::string> inos_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && !hidden(entry.path()) && is_ino(entry.path()))
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// Returns a hint if a folder contains sketches in subfolders, as archives often do; otherwise "".
std::string nested_sketch_hint(const fs::path& folder) try {
  std::set<std::string> nested;
  for (const auto& entry : fs::directory_iterator(folder))
    if (!hidden(entry.path()) && !entry.is_symlink() && entry.is_directory() &&
        !inos_in(entry.path()).empty())
      nested.insert(entry.path().filename().string());
  return nested.empty() ? "" : fmt::format("; it contains the sketch {}: name that folder", *nested.begin());
} catch (const fs::filesystem_error&) {
  return "";  // the folder cannot be read
}

// Puts the .ino file with the folder's name first. The name of a single .ino file does not matter.
bool put_main_first(std::vector<std::string>& inos, const std::string& folder_name) {
  const auto own = std::find_if(inos.begin(), inos.end(), [&](const std::string& name) {
    return fs::path(name).stem().string() == folder_name;
  });
  if (own == inos.end()) return inos.size() == 1;
  std::rotate(inos.begin(), own, own + 1);
  return true;
}

/// Limits the total size of a sketch's files, because Robosim reads them completely.
constexpr std::size_t kMostSources_bytes = std::size_t{2} << 20;

/// Returns the code of a C++ source, with a blank for each comment and literal.
std::string code_of(const std::string& source) {
  std::string code;
  for (CodeScanner scan(source, 0); !scan.done();) {
    const std::size_t from = scan.at();
    scan.step();
    code += scan.at() == from + 1 ? source[from] : ' ';
  }
  return code;
}

/// Returns whether the code defines `void NAME() {…}` or `void NAME(void) {…}`.
bool defines(std::string_view code, std::string_view name) {
  const auto skip_blanks = [&](std::size_t at) {
    return std::min(code.find_first_not_of(" \t\r\n", at), code.size());
  };
  for (std::size_t at = code.find(name); at != code.npos; at = code.find(name, at + 1)) {
    const std::size_t open = skip_blanks(at + name.size());
    const std::size_t before = at == 0 ? code.npos : code.find_last_not_of(" \t\r\n", at - 1);
    if (before == code.npos || before + 1 == at || !code.substr(0, before + 1).ends_with("void")) continue;
    if (open == code.size() || code[open] != '(') continue;
    std::size_t close = skip_blanks(open + 1);
    if (code.substr(close).starts_with("void")) close = skip_blanks(close + std::string_view("void").size());
    if (close == code.size() || code[close] != ')') continue;
    if (const std::size_t body = skip_blanks(close + 1); body < code.size() && code[body] == '{') return true;
  }
  return false;
}

/// Puts the only .ino file that defines setup() and loop() first. Returns false if no file defines both, or
/// if another file defines one of them: such a folder may contain several sketches. Also returns false for
/// links and for files that are too large, which read_sketch() has not refused yet.
bool put_file_with_loop_first(std::vector<std::string>& inos, const fs::path& folder) {
  auto main = inos.end();
  for (auto ino = inos.begin(); ino != inos.end(); ++ino) {
    if (fs::is_symlink(folder / *ino) || fs::file_size(folder / *ino) > kMostSources_bytes) return false;
    const std::string code = code_of(read_file(folder / *ino));
    const int found = defines(code, "setup") + defines(code, "loop");
    if (found == 1 || (found == 2 && main != inos.end())) return false;
    if (found == 2) main = ino;
  }
  if (main == inos.end()) return false;
  std::rotate(inos.begin(), main, main + 1);
  return true;
}

std::string unix_text(std::string_view text) {
  text = without_byte_order_mark(text);
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\r') {
      result += text[i];
    } else if (i + 1 == text.size() || text[i + 1] != '\n') {
      result += '\n';
    }
  }
  return result;
}

}  // namespace

namespace {

/// Throws InputError if a project file would give compilers access to other folders of this machine.
void check_within_project(const fs::path& project, const fs::path& folder) {
  const fs::path reach = reach_of(project);
  if (!lies_in(folder, reach))
    throw InputError(
        {(project / "platformio.ini").string()},
        fmt::format("folder of sources or headers outside of the project: expected one below {}, "
                    "got {}; --libraries DIR names a folder of code that sketches share",
                    reach.string(), folder.string()));
}

/// Reads a project by PlatformIO's rules: the files of its source folder. The .ino file with setup() comes
/// first.
Sketch read_project(const fs::path& folder, const ProjectRules& rules) {
  std::error_code error;
  const fs::path sources = fs::canonical(rules.sources, error);
  if (error) throw InputError({rules.sources.string()}, "no such folder");
  Sketch sketch;
  sketch.name = folder.filename().string();
  check_within_project(folder, sources);
  const fs::path relative = sources.lexically_relative(folder);
  sketch.folder = relative.empty() || *relative.begin() == ".." ? sources : folder;
  take_all_below(sketch, sources);
  for (const std::string& name : inos_in(sources))
    sketch.inos.push_back((sources / name).lexically_relative(sketch.folder).string());
  std::stable_partition(sketch.inos.begin(), sketch.inos.end(), [&](const std::string& name) {
    return read_file(sketch.folder / name, kMostSources_bytes).find("void setup") != std::string::npos;
  });
  if (sketch.inos.empty() && sketch.sources.empty())
    throw InputError({rules.sources.string()}, "a folder without sources: expected a .cpp or an .ino file");
  for (const fs::path& include : rules.includes) {
    const fs::path real = fs::canonical(include, error);
    if (error) continue;
    check_within_project(folder, real);
    if (real != sources) take_headers(sketch, real);
    sketch.includes.push_back(real);
  }
  sketch.includes.insert(sketch.includes.begin(), sources);
  sort(sketch);
  return sketch;
}

void check_size(const Sketch& sketch) {
  std::uintmax_t bytes = 0;
  std::error_code none;
  for (const auto* names : {&sketch.inos, &sketch.sources, &sketch.assembler, &sketch.headers})
    for (const std::string& name : *names) {
      const std::uintmax_t more = fs::file_size(sketch.folder / name, none);
      if (!none) bytes += more;
    }
  if (bytes > kMostSources_bytes)
    throw InputError(
        {sketch.folder.string()},
        fmt::format("the sketch is too large: expected sources of at most {} MB together, got {} MB",
                    kMostSources_bytes >> 20, (bytes + (1u << 20) - 1) >> 20));
}

/// Removes headers that are links out of the project. Throws InputError for sources that are links out of the
/// project. Compilers cannot open the removed headers either (shared_files()), and report the line that
/// includes one.
void check_links(Sketch& sketch) {
  const fs::path reach = reach_of(sketch.folder);
  std::error_code none;
  const auto leads_out = [&](const std::string& name) {
    const fs::path file = sketch.folder / name;
    return fs::is_symlink(file, none) && !lies_in(file, sketch.folder) && !lies_in(file, reach);
  };
  std::erase_if(sketch.headers, leads_out);
  for (const auto* names : {&sketch.inos, &sketch.sources, &sketch.assembler})
    for (const std::string& name : *names)
      if (leads_out(name))
        throw InputError(
            {name}, fmt::format("a link to {}, outside of the sketch's project: expected a file below {}; "
                                "--libraries DIR names a folder of code that sketches share",
                                fs::read_symlink(sketch.folder / name, none).string(), reach.string()));
}

Sketch find_files(const fs::path& path, const ProjectRules& rules) {
  std::error_code error;
  const fs::path absolute = fs::canonical(path, error);
  if (error) throw InputError({path.string()}, "no such sketch");
  if (!rules.sources.empty()) return read_project(absolute, rules);

  Sketch sketch;
  sketch.includes = {fs::is_regular_file(absolute) ? absolute.parent_path() : absolute};
  if (fs::is_regular_file(absolute)) {
    if (!is_ino(absolute) && !is_source(absolute))
      throw InputError({path.string()}, "expected a sketch: a folder, an .ino or a .cpp file");
    sketch.folder = absolute.parent_path();
    sketch.name = absolute.stem().string();
    const std::string own = absolute.filename().string();
    if (is_source(absolute)) {
      sketch.sources = {own};
      return sketch;
    }
    sketch.inos = inos_in(sketch.folder);
    if (put_main_first(sketch.inos, sketch.folder.filename().string())) {
      sketch.name = fs::path(sketch.inos[0]).stem().string();
      take_folder(sketch);
    } else {
      sketch.inos = {own};  // one of several sketches in one folder
    }
    return sketch;
  }

  sketch.folder = absolute;
  sketch.name = absolute.filename().string();
  sketch.inos = inos_in(absolute);
  take_folder(sketch);
  if (sketch.inos.empty() && sketch.sources.empty())
    throw InputError({path.string()},
                     "expected a sketch, got a folder without an .ino file" + nested_sketch_hint(absolute));
  if (!sketch.inos.empty() && !put_main_first(sketch.inos, sketch.name) &&
      !put_file_with_loop_first(sketch.inos, absolute))
    throw InputError(
        {path.string()},
        fmt::format("expected {0}.ino, named like its folder, among the {1} .ino files, got {2}; rename "
                    "the main file to {0}.ino, or name one of the files, as in {3}",
                    sketch.name, sketch.inos.size(), all_of(sketch.inos), (path / sketch.inos[0]).string()));
  if (!sketch.inos.empty()) sketch.name = fs::path(sketch.inos[0]).stem().string();
  return sketch;
}

}  // namespace

Sketch read_sketch(const fs::path& path, const ProjectRules& rules) try {
  Sketch sketch = find_files(path, rules);
  check_links(sketch);
  check_size(sketch);
  return sketch;
} catch (const fs::filesystem_error& error) {  // a folder that cannot be read, or a link to itself
  const fs::path& place = error.path1().empty() ? path : error.path1();
  throw InputError({place.string()}, "cannot read the file: " + error.code().message());
}

std::string remark_on_main_file(const fs::path& folder) try {
  std::vector<std::string> inos = inos_in(folder);
  const std::string name = fs::canonical(folder).filename().string();
  if (inos.empty() || put_main_first(inos, name) || !put_file_with_loop_first(inos, folder)) return "";
  return fmt::format(
      "{0} has no {0}.ino: its main file is {1}, which defines setup() and loop(); Arduino's IDE requires "
      "that the folder is called {2}",
      name, inos[0], fs::path(inos[0]).stem().string());
} catch (const fs::filesystem_error&) {
  return "";  // the sketch is a file, or the folder cannot be read
}

std::string content_sha256(const Sketch& sketch) {
  std::string all;
  for (const auto* names : {&sketch.inos, &sketch.sources, &sketch.assembler, &sketch.headers})
    for (const std::string& name : *names) {
      const std::string content = read_file(sketch.folder / name);
      all += fmt::format("{}\n{}\n", name, content.size());
      all += content;
    }
  return sha256(all);
}

std::string c_literal(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + '"';
}

std::string join_inos(const Sketch& sketch) {
  std::string joined = fmt::format("#line 1 {}\n#include <Arduino.h>\n", c_literal(sketch.inos.at(0)));
  for (const std::string& name : sketch.inos) {
    joined += fmt::format("#line 1 {}\n", c_literal(name));
    joined += unix_text(read_file(sketch.folder / name));
    if (joined.back() != '\n') joined += '\n';
  }
  return joined;
}

}  // namespace robosim::build
