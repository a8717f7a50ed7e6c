#include "sim/build/width_check.h"

#include <fmt/format.h>

#include <set>
#include <string_view>
#include <utility>

#include "sim/base/error.h"
#include "sim/build/messages.h"
#include "sim/build/warning_filter.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

constexpr const char* kAvrTarget = "avr";

bool is_wanted(const Toolchain& host) {
  return !host.target.chip && host.warnings != Warnings::none &&
         host.board.chip->target == std::string_view(kAvrTarget);
}

/// Returns "My.ino:4:" of "My.ino:4:11: warning: ...".
std::string line_of(const std::string& message) {
  const std::size_t colon = message.find(':');
  return message.substr(0, message.find(':', colon + 1) + 1);
}

}  // namespace

std::unique_ptr<const WidthCheck> WidthCheck::of(const Toolchain& host, const GenuineCore& core,
                                                 const fs::path& cache) try {
  if (!is_wanted(host)) return nullptr;
  const Target& target = find_target(kAvrTarget);
  const Compiler compiler = find_compiler(target);
  Toolchain avr{target, compiler, ask(compiler, cache), core_for(target, host.board, core, cache),
                host.board};
  avr.rules = host.rules;
  return std::unique_ptr<const WidthCheck>(new WidthCheck(std::move(avr)));
} catch (const ToolMissing&) {
  return nullptr;
}

Command WidthCheck::command(const Unit& unit, const fs::path& scratch) const {
  Command command = check_command(avr_, unit, scratch);
  command.read = read_by_all(avr_, {});
  return command;
}

std::string WidthCheck::warnings(const Sketch& sketch, const std::string& output,
                                 const std::string& host_messages) const {
  std::set<std::string> own;
  for (const auto* names : {&sketch.inos, &sketch.sources, &sketch.headers})
    own.insert(names->begin(), names->end());
  std::set<std::string> known;
  for (const std::string& message : width_warnings(host_messages)) known.insert(line_of(message));
  std::string text;
  for (std::string message : width_warnings(readable(avr_, sketch.folder, output))) {
    if (!own.contains(message.substr(0, message.find(':'))) || known.contains(line_of(message))) continue;
    message.insert(message.find(" [-W"), fmt::format(" on the {}, whose int has 16 bits", avr_.board.name));
    text += (text.empty() ? "" : "\n") + message;
  }
  return text;
}

std::string width_check_identity(const Toolchain& host) try {
  return is_wanted(host) ? find_compiler(find_target(kAvrTarget)).identity : "";
} catch (const ToolMissing&) {
  return "";
}

}  // namespace robosim::build
