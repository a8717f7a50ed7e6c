#include "sim/build/core.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <stdexcept>

#include "sim/base/file.h"
#include "sim/build/messages.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> sources_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (const fs::path ending = entry.path().extension();
        ending == ".cpp" || ending == ".c" || ending == ".S")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Returns all sources of the core. The object of the first one is core0.o.
std::vector<fs::path> sources_of_core(const Toolchain& toolchain) {
  std::vector<fs::path> sources;
  for (const fs::path& folder : toolchain.core.sources) {
    const std::vector<fs::path> files = sources_in(folder);
    sources.insert(sources.end(), files.begin(), files.end());
  }
  return sources;
}

Unit core_unit(const Toolchain& toolchain, const fs::path& source) {
  Unit unit;
  unit.kind = Unit::Kind::core;
  unit.folder = toolchain.core.root;
  unit.place = toolchain.core.place;
  unit.source = source.string();
  return unit;
}

/// Runs the commands in sandboxes, because a project's `-D` option can make the core's own code include any
/// file. Returns the output of the last command.
std::string run_checked(const Toolchain& toolchain, std::vector<Command> commands) {
  std::string output;
  for (CommandResult& result : run_within(read_by_all(toolchain, {}), std::move(commands))) {
    output = std::move(result.output);
    if (result.status == 0) continue;
    check_machine("the compiler", output);
    if (toolchain.rules.flags.empty()) throw std::runtime_error("the core does not compile:\n" + output);
    throw CompileError(fmt::format("the core does not compile with build_flags {}: {}",
                                   fmt::join(toolchain.rules.flags, " "),
                                   readable(toolchain, toolchain.core.root, output)));
  }
  return output;
}

// Makes defined symbols weak. Undefined symbols stay strong, so that the link fails if such a symbol is
// missing.
void weaken(const Toolchain& toolchain, const fs::path& object) {
  const fs::path work = object.parent_path();
  const auto tool = [&](const char* name) {
    return find_tool(toolchain.target, {name, "binutils"}).string();
  };
  write_file(work / "names",
             run_checked(toolchain,
                         {{{tool("nm"), "--defined-only", "-g", "-j", object.string()}, work, {}, work}}));
  run_checked(toolchain, {{{tool("objcopy"), "--weaken-symbols=names", object.string()}, work, {}, work}});
}

fs::path join(const Toolchain& toolchain, const std::vector<fs::path>& objects, const fs::path& work) {
  if (toolchain.target.archiver.name) {
    run_checked(toolchain, {archive_command(toolchain, objects, work / "core.a")});
    return work / "core.a";
  }
  run_checked(toolchain, {merge_command(toolchain, objects, work / "core.o")});
  weaken(toolchain, work / "core.o");
  return work / "core.o";
}

}  // namespace

std::string with_names_of_core(const Toolchain& toolchain, const std::string& messages) {
  static const std::regex object(
      R"((^|[\n ])(?:[^\n :(]*\()?core(\d{1,3})\.o\)?( \(symbol from plugin\))?:)");
  const std::vector<fs::path> sources = sources_of_core(toolchain);
  std::string result;
  auto rest = messages.begin();
  for (std::sregex_iterator one(messages.begin(), messages.end(), object), end; one != end; ++one) {
    const std::size_t number = std::stoul((*one)[2]);
    if (number >= sources.size()) continue;
    result.append(rest, (*one)[0].first);
    result += fmt::format("{}core/{}:", (*one)[1].str(), sources[number].filename().string());
    rest = (*one)[0].second;
  }
  return result.append(rest, messages.end());
}

Object core_object(const Toolchain& toolchain, const Cache& cache, WorkFolder& work) {
  const std::string key = key_of({"core", recipe(toolchain)});
  const auto known = [&]() -> std::optional<Object> {
    const auto entry = cache.find(key);
    if (!entry) return std::nullopt;
    return Object{"core", work.give(entry->result), split_paths(entry->facts.at("inputs"))};
  };
  if (const auto object = known()) return *object;
  const CacheLock lock(cache);
  if (const auto object = known()) return *object;  // another process has compiled it in the meantime
  if (toolchain.core_begins) toolchain.core_begins();
  const auto since = fs::file_time_type::clock::now();
  std::vector<Command> commands;
  std::vector<fs::path> objects;
  const fs::path scratch = work.scratch();
  for (const fs::path& source : sources_of_core(toolchain)) {
    objects.push_back(scratch / fmt::format("core{}.o", objects.size()));
    commands.push_back(compile_command(toolchain, core_unit(toolchain, source), objects.back()));
  }
  run_checked(toolchain, std::move(commands));
  const fs::path joined = join(toolchain, objects, scratch);

  Inputs inputs;
  for (const fs::path& object : objects) {
    const auto files = read_dependencies(read_made(object.string() + ".d"), toolchain.core.root);
    inputs.files.insert(inputs.files.end(), files.begin(), files.end());
  }
  std::sort(inputs.files.begin(), inputs.files.end());
  inputs.files.erase(std::unique(inputs.files.begin(), inputs.files.end()), inputs.files.end());
  inputs.folders = toolchain.core.sources;
  const Entry entry = cache.store(key, inputs, read_made(joined), joined.filename().string(),
                                  {{"inputs", join_paths(inputs.files)}}, since);
  return {"core", work.give(entry.result), inputs.files};
}

}  // namespace robosim::build
