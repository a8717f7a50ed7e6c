#include "sim/build/coverage.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim/base/archive.h"
#include "sim/base/descriptor.h"
#include "sim/base/file.h"
#include "sim/base/terminal_text.h"
#include "sim/build/cache.h"
#include "sim/build/process.h"
#include "sim/build/source.h"
#include "sim/build/target.h"
#include "sim/build/toolchain.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

constexpr const char* kUnreadableCounts = "gcov cannot read the counts of the sketch";

FileCoverage& file_of(Coverage& coverage, const fs::path& path) {
  auto at = std::find_if(coverage.begin(), coverage.end(),
                         [&](const FileCoverage& one) { return one.file >= path; });
  if (at == coverage.end() || at->file != path) at = coverage.insert(at, FileCoverage{path, {}, {}});
  return *at;
}

/// Returns the names of the sketch's own files, as gcc prints them.
std::vector<std::string> own_files(const Sketch& sketch) {
  std::vector<std::string> names;
  for (const auto* group : {&sketch.inos, &sketch.sources, &sketch.headers})
    names.insert(names.end(), group->begin(), group->end());
  // lcov's tracefile has one line for each name. A name that contains a line end could therefore make genhtml
  // show another file of this machine.
  std::erase_if(names, [](const std::string& name) { return in_one_line(name) != name; });
  return names;
}

/// Adds gcov's report on one source. A line of a template or a header may appear several times.
void add_report(Coverage& coverage, const Sketch& sketch, const std::string& report) try {
  const std::vector<std::string> own = own_files(sketch);
  const nlohmann::json json = nlohmann::json::parse(report);
  for (const nlohmann::json& file : json.at("files")) {
    const std::string name = fs::path(file.at("file").get<std::string>()).lexically_normal().string();
    if (std::find(own.begin(), own.end(), name) == own.end()) continue;
    FileCoverage& one = file_of(coverage, sketch.folder / name);
    for (const nlohmann::json& line : file.at("lines"))
      one.lines[line.at("line_number").get<int>()] += line.at("count").get<std::uint64_t>();
    for (const nlohmann::json& function : file.at("functions")) {
      FileCoverage::Function& known =
          one.functions[in_one_line(function.at("demangled_name").get<std::string>())];
      known.line = function.at("start_line").get<int>();
      known.calls += function.at("execution_count").get<std::uint64_t>();
    }
  }
} catch (const nlohmann::json::exception&) {
  throw InputError(kUnreadableCounts);
}

/// A lock that at most one process holds at a time, until the end of the lock's scope.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder)
      : lock_(::open((folder / ".lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666)) {
    if (!lock_.is_open()) throw InputError({folder.string()}, "cannot write into the folder");
    while (::flock(lock_.get(), LOCK_EX) != 0 && errno == EINTR) {
    }
  }

 private:
  Descriptor lock_;
};

std::vector<fs::path> info_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".info") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string short_hash(const std::string& text) { return sha256(text).substr(0, 8); }

/// Returns the lines as "12-14, 30".
std::string ranges(const std::vector<int>& lines, const std::map<int, std::uint64_t>& all) {
  std::string text;
  for (std::size_t i = 0; i < lines.size();) {
    std::size_t last = i;
    // Two lines that never ran belong to one range if only lines without code are between them.
    while (last + 1 < lines.size() && std::next(all.find(lines[last]))->first == lines[last + 1]) ++last;
    text += text.empty() ? "" : ", ";
    text += last == i ? fmt::format("{}", lines[i]) : fmt::format("{}-{}", lines[i], lines[last]);
    i = last + 1;
  }
  return text;
}

template <typename Number>
Number number(std::string_view& text) {
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) throw std::invalid_argument("no number");
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (text.starts_with(',')) text.remove_prefix(1);
  return value;
}

/// Reads an emulated chip's counts. Each line is "LINE COUNT FILE".
Coverage read_line_counts(const Sketch& sketch, const std::vector<ArchivedFile>& counters) {
  const std::vector<std::string> own = own_files(sketch);
  Coverage coverage;
  for (const ArchivedFile& counter : counters) {
    std::istringstream lines(counter.content);
    int line = 0;
    std::uint64_t count = 0;
    for (std::string name; lines >> line >> count && std::getline(lines >> std::ws, name);) {
      name = fs::path(name).lexically_normal().string();
      if (std::find(own.begin(), own.end(), name) != own.end())
        file_of(coverage, sketch.folder / name).lines[line] += count;
    }
  }
  return coverage;
}

}  // namespace

Coverage read_coverage(const Request& request, const Image& image, const std::string& counters) {
  const Target& target = find_target(request.target);
  const Sketch sketch = read_sketch(request.sketch);
  if (target.chip) return read_line_counts(sketch, unpack(counters));
  const Cache cache(cache_folder());
  const fs::path gcov = find_tool(target, {"gcov", "gcc"});
  const std::vector<ArchivedFile> notes = unpack(read_file(image.notes));
  Coverage coverage;
  // Each power cycle has its own counters. A source that never ran may have none.
  std::vector<ArchivedFile> pending = unpack(counters);
  // Limits the number of power cycles. The number and the counters' names come from the sketch's memory, and
  // cannot be trusted.
  constexpr int kMostCycles = 1000;
  std::erase_if(pending, [&](const ArchivedFile& counter) {
    return std::none_of(notes.begin(), notes.end(), [&](const ArchivedFile& note) {
      return fs::path(counter.name).filename().string() == note.name + ".gcda";
    });
  });
  int cycles = 0;
  do {
    const WorkFolder work(cache);
    for (const ArchivedFile& note : notes) write_file(work.path() / (note.name + ".gcno"), note.content);
    std::vector<ArchivedFile> later;
    for (const ArchivedFile& counter : pending) {
      const std::string name = fs::path(counter.name).filename().string();
      if (fs::exists(work.path() / name))
        later.push_back(counter);
      else
        write_file(work.path() / name, counter.content);
    }
    std::vector<Command> commands;
    for (const ArchivedFile& note : notes)
      commands.push_back(
          {{gcov.string(), "--json-format", "--stdout", note.name + ".gcno"}, work.path(), {}, work.path()});
    for (const CommandResult& result : run_within({}, std::move(commands))) {
      const std::size_t begin = result.output.find("{\"");
      if (result.status != 0 || begin == std::string::npos)
        throw InputError(std::string(kUnreadableCounts) + ": " + result.output);
      add_report(coverage, sketch, result.output.substr(begin));
    }
    pending = std::move(later);
  } while (!pending.empty() && ++cycles < kMostCycles);
  return coverage;
}

void add(Coverage& sum, const Coverage& more) {
  for (const FileCoverage& file : more) {
    FileCoverage& one = file_of(sum, file.file);
    for (const auto& [line, count] : file.lines) one.lines[line] += count;
    for (const auto& [name, function] : file.functions) {
      one.functions[name].line = function.line;
      one.functions[name].calls += function.calls;
    }
  }
}

std::string to_info(const Coverage& coverage) {
  std::string text = "TN:\n";
  for (const FileCoverage& file : coverage) {
    text += fmt::format("SF:{}\n", file.file.string());
    std::size_t called = 0, ran = 0;
    for (const auto& [name, function] : file.functions)
      text += fmt::format("FN:{},{}\n", function.line, name);
    for (const auto& [name, function] : file.functions) {
      text += fmt::format("FNDA:{},{}\n", function.calls, name);
      called += function.calls > 0;
    }
    text += fmt::format("FNF:{}\nFNH:{}\n", file.functions.size(), called);
    for (const auto& [line, count] : file.lines) {
      text += fmt::format("DA:{},{}\n", line, count);
      ran += count > 0;
    }
    text += fmt::format("LF:{}\nLH:{}\nend_of_record\n", file.lines.size(), ran);
  }
  return text;
}

Coverage parse_info(const std::string& text, const fs::path& path) {
  Coverage coverage;
  FileCoverage* file = nullptr;
  std::istringstream lines(text);
  int at = 0;
  for (std::string line; std::getline(lines, line);) {
    ++at;
    std::string_view rest = line;
    const std::string_view key = rest.substr(0, std::min(rest.find(':'), rest.size()));
    rest.remove_prefix(std::min(key.size() + 1, rest.size()));
    try {
      if (key == "SF") file = &file_of(coverage, fs::path(rest));
      if (key != "DA" && key != "FN" && key != "FNDA") continue;
      if (!file) throw std::invalid_argument("no file");
      const auto first = number<std::uint64_t>(rest);
      if (key == "DA") file->lines[static_cast<int>(first)] += number<std::uint64_t>(rest);
      if (key == "FN") file->functions[std::string(rest)].line = static_cast<int>(first);
      if (key == "FNDA") file->functions[std::string(rest)].calls += first;
    } catch (const std::invalid_argument&) {
      throw InputError({path.string(), at, 0}, "expected a line of a coverage file (.info)");
    }
  }
  return coverage;
}

Coverage add_to_folder(const fs::path& folder, const Request& request, const Image& image,
                       const Coverage& coverage, const std::string& description) try {
  const fs::path runs = folder / "runs";
  fs::create_directories(runs);
  const FolderLock lock(folder);
  // The first part of a file's name, which identifies the sketch, its version and its run.
  const std::string sketch =
      fmt::format("{}-{}-", image.name, short_hash(read_sketch(request.sketch).folder.string()));
  const std::string version = sketch + image.sketch_sha256.substr(0, 8);
  for (const fs::path& file : info_files(runs)) {
    const std::string name = file.filename().string();
    if (name.starts_with(sketch) && !name.starts_with(version)) fs::remove(file);
  }
  write_file(runs / fmt::format("{}-{}.info", version, short_hash(description)), to_info(coverage));
  Coverage sum;
  for (const fs::path& file : info_files(runs)) add(sum, parse_info(read_file(file), file));
  write_file(folder / "coverage.info", to_info(sum));
  return sum;
} catch (const fs::filesystem_error& error) {
  throw InputError({error.path1().string()}, "cannot use the file: " + error.code().message());
}

std::string summary(const Coverage& coverage) {
  std::string text;
  for (const FileCoverage& file : coverage) {
    std::vector<int> never;
    for (const auto& [line, count] : file.lines)
      if (count == 0) never.push_back(line);
    text += fmt::format("{} of {} lines of {} ran{}\n", file.lines.size() - never.size(), file.lines.size(),
                        file.file.filename().string(),
                        never.empty() ? "" : "; never ran: " + ranges(never, file.lines));
  }
  return text;
}

bool make_page(const fs::path& folder) {
  const fs::path genhtml = find_program("genhtml");
  if (genhtml.empty()) return false;
  const FolderLock lock(folder);
  const CommandResult result =
      run(Command{{genhtml.string(), "--quiet", "--output-directory", "html", "coverage.info"}, folder, {}});
  if (result.status != 0) throw InputError("genhtml rejects coverage.info: " + result.output);
  return true;
}

}  // namespace robosim::build
