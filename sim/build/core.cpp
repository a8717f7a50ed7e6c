#include "sim/build/core.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
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

Unit core_unit(const Toolchain& toolchain, const fs::path& source) {
  Unit unit;
  unit.kind = Unit::Kind::core;
  unit.folder = toolchain.core.root;
  unit.place = toolchain.core.place;
  unit.source = source.string();
  return unit;
}

void check(const CommandResult& result) {
  if (result.status == 0) return;
  check_machine("the compiler", result.output);
  throw std::runtime_error("the core does not compile:\n" + result.output);
}

// Only what is defined: an undefined symbol must still be found, or the link fail.
void weaken(const Target& target, const fs::path& object, const fs::path& work) {
  const auto tool = [&](const char* name) { return find_tool(target, {name, "binutils"}).string(); };
  const CommandResult names =
      run(Command{{tool("nm"), "--defined-only", "-g", "-j", object.string()}, work, {}});
  check(names);
  write_file(work / "names", names.output);
  check(run(Command{{tool("objcopy"), "--weaken-symbols=names", object.string()}, work, {}}));
}

fs::path join(const Toolchain& toolchain, const std::vector<fs::path>& objects, const fs::path& work) {
  if (toolchain.target.archiver.name) {
    check(run(archive_command(toolchain, objects, work / "core.a")));
    return work / "core.a";
  }
  check(run(merge_command(toolchain, objects, work / "core.o")));
  weaken(toolchain.target, work / "core.o", work);
  return work / "core.o";
}

}  // namespace

Object core_object(const Toolchain& toolchain, const Cache& cache, const fs::path& work) {
  const std::string key = "core\n" + recipe(toolchain);
  const auto known = [&]() -> std::optional<Object> {
    const auto entry = cache.find(key);
    if (!entry) return std::nullopt;
    return Object{"core", entry->result, split_paths(entry->facts.at("inputs"))};
  };
  if (const auto object = known()) return *object;
  const CacheLock lock(cache);
  if (const auto object = known()) return *object;  // another process has made it meanwhile
  if (toolchain.core_begins) toolchain.core_begins();
  const auto since = fs::file_time_type::clock::now();
  std::vector<Command> commands;
  std::vector<fs::path> objects;
  for (const fs::path& folder : toolchain.core.sources)
    for (const fs::path& source : sources_in(folder)) {
      objects.push_back(work / fmt::format("core{}.o", objects.size()));
      commands.push_back(compile_command(toolchain, core_unit(toolchain, source), objects.back()));
    }
  for (const CommandResult& result : run(commands)) check(result);
  const fs::path joined = join(toolchain, objects, work);

  Inputs inputs;
  for (const fs::path& object : objects) {
    const auto files = read_dependencies(object.string() + ".d", toolchain.core.root);
    inputs.files.insert(inputs.files.end(), files.begin(), files.end());
  }
  std::sort(inputs.files.begin(), inputs.files.end());
  inputs.files.erase(std::unique(inputs.files.begin(), inputs.files.end()), inputs.files.end());
  inputs.folders = toolchain.core.sources;
  const Entry entry = cache.store(key, inputs, joined, joined.filename().string(),
                                  {{"inputs", join_paths(inputs.files)}}, since);
  return {"core", entry.result, inputs.files};
}

}  // namespace robosim::build
