#include "sim/build/static_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "sim/base/error.h"
#include "sim/build/messages.h"
#include "sim/build/warning_filter.h"

namespace robosim::build {
namespace fs = std::filesystem;

struct StaticCheck::Kind {
  /// The checking compiler is the compiler of this target.
  const char* target;
  std::vector<std::string> options;
  bool (*is_for)(const Toolchain& build);
  /// Returns the messages of this kind in the output of any compiler.
  std::vector<std::string> (*messages)(const std::string& output);
  /// Returns a key that is equal for all messages about one mistake.
  std::string (*subject)(const std::string& message);
  /// Returns the message for users.
  std::string (*text)(const std::string& message, const BoardSpec& board);
};

namespace {

bool overflows_only_on_chip(const Toolchain& build) {
  return !build.target.chip && build.warnings != Warnings::none &&
         build.board.chip->target == std::string_view("avr");
}

std::string text_of_width(const std::string& message, const BoardSpec& board) {
  std::string text = message;
  const std::size_t option = std::min(text.find(" [-W"), text.find('\n'));
  return text.insert(std::min(option, text.size()),
                     fmt::format(" on the {}, whose int has 16 bits", board.name));
}

bool is_sanitized(const Toolchain& build) { return build.sanitize && build.warnings != Warnings::none; }

/// Returns the quoted name in a message about a variable, with "q.x" for "q.Class::x"; empty if the message
/// has no name.
std::string variable_of(const std::string& message) {
  const std::size_t begin = std::min(message.find('\''), message.size() - 1) + 1;
  std::string name = message.substr(begin, message.find('\'', begin) - begin);
  for (std::size_t at; (at = name.find("::")) != name.npos;) {
    const std::size_t dot = name.rfind('.', at);
    name.erase(dot + 1, at + 2 - (dot + 1));
  }
  return name;
}

std::string text_of_unset(const std::string& message, const BoardSpec&) {
  constexpr std::string_view kBegin = "warning: ";
  const std::size_t begin = message.find(kBegin) + kBegin.size();
  const std::size_t end = std::min(message.find('\n'), message.size());
  return message.substr(0, begin) +
         fmt::format("'{}' {}: give it one where it is declared", variable_of(message), kUnset) +
         message.substr(end);
}

/// A limit of branches (analyzer-bb-explosion-factor) makes the analyser faster than the compiler, even for a
/// large sketch.
const std::array<StaticCheck::Kind, 2> kKinds = {
    {{"avr", {"-fsyntax-only"}, overflows_only_on_chip, width_warnings, line_of, text_of_width},
     {"host",
      {"-O0", "-fanalyzer", "-fdiagnostics-path-format=none", "--param=analyzer-bb-explosion-factor=2", "-S",
       "-o", "/dev/null"},
      is_sanitized,
      unset_warnings,
      variable_of,
      text_of_unset}}};

}  // namespace

Command StaticCheck::command(const Unit& unit, const fs::path& scratch) const {
  Command command = check_command(checker_, unit, kind_.options, scratch);
  command.read = read_by_all(checker_, {});
  return command;
}

std::string StaticCheck::warnings(const Sketch& sketch, const std::string& output,
                                  const std::string& build_messages) const {
  std::set<std::string> own, known;
  for (const auto* names : {&sketch.inos, &sketch.sources, &sketch.headers})
    own.insert(names->begin(), names->end());
  for (const std::string& message : kind_.messages(build_messages)) known.insert(kind_.subject(message));
  std::string text;
  for (const std::string& message : kind_.messages(readable(checker_, sketch.folder, output))) {
    if (!own.contains(message.substr(0, message.find(':')))) continue;
    if (!known.insert(kind_.subject(message)).second) continue;
    text += (text.empty() ? "" : "\n") + kind_.text(message, checker_.board);
  }
  return text;
}

std::vector<StaticCheck> static_checks(const Toolchain& build, const GenuineCore& core,
                                       const fs::path& cache) {
  std::vector<StaticCheck> checks;
  for (const StaticCheck::Kind& kind : kKinds) try {
      if (!kind.is_for(build)) continue;
      const Target& target = find_target(kind.target);
      const Compiler compiler = find_compiler(target);
      Toolchain checker{target, compiler, ask(compiler, cache), core_for(target, build.board, core, cache),
                        build.board};
      checker.rules = build.rules;
      checks.emplace_back(kind, std::move(checker));
    } catch (const ToolMissing&) {
    }
  return checks;
}

std::string static_checks_identity(const Toolchain& build) {
  std::string identity;
  for (const StaticCheck::Kind& kind : kKinds) try {
      if (kind.is_for(build)) identity += find_compiler(find_target(kind.target)).identity + "\n";
    } catch (const ToolMissing&) {
    }
  return identity;
}

}  // namespace robosim::build
