// Implements checks of a target, and reads the limits that an image declares (sketch.h).
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "sim/base/file.h"
#include "sim/build/elf_facts.h"
#include "sim/build/sketch.h"
#include "sim/build/toolchain.h"

namespace robosim::build {

std::string missing_tool(const std::string& target_name) {
  const Target& target = find_target(target_name);
  try {
    find_compiler(target);
    if (target.archiver.name) find_tool(target, target.archiver);
    for (const Product& product : target.products) find_tool(target, product.program);
    find_core();
    find_ctags();
    return {};
  } catch (const ToolMissing& error) {
    return error.what();
  }
}

void check_can_sanitize(const std::string& target) {
  if (find_target(target).sanitizer.undefined.empty())
    throw InputError(fmt::format("the target {} has no checks", target));
}

std::vector<Limit> stated_limits(const Image& image) {
  std::string file = read_file(image.image);
  if (!ElfFile::is_one(file)) return {};
  const std::vector<AbsoluteSymbol> symbols =
      absolute_symbols(ElfFile(std::move(file), image.image.string()));
  const auto stated = [&](const std::string& prefix) {
    std::map<std::string, std::uint64_t> values;
    for (const AbsoluteSymbol& symbol : symbols)
      if (symbol.name.starts_with(prefix)) values[symbol.name.substr(prefix.size())] = symbol.value;
    return values;
  };
  const auto most = stated("linekit_most_"), bytes_each = stated("linekit_bytes_each_");
  const auto of = [](const auto& values, const std::string& name) {
    const auto found = values.find(name);
    return found == values.end() ? 0 : found->second;
  };
  std::vector<Limit> limits;
  for (const auto& [name, value] : stated("linekit_limit_")) {
    std::string what = name;
    std::replace(what.begin(), what.end(), '_', ' ');
    limits.push_back({what, value, of(bytes_each, name), of(most, name)});
  }
  return limits;
}

}  // namespace robosim::build
