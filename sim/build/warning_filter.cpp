#include "sim/build/warning_filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace robosim::build {
namespace {

bool has(std::string_view text, std::string_view what) { return text.find(what) != text.npos; }

std::string_view trimmed(std::string_view text) {
  const std::size_t last = text.find_last_not_of(" \t");
  return last == text.npos ? "" : text.substr(0, last + 1);
}

bool ends_in_word(std::string_view text, std::string_view word) {
  if (!text.ends_with(word)) return false;
  if (text.size() == word.size()) return true;
  const char before = text[text.size() - word.size() - 1];
  return before == ' ' || before == '\t' || before == '}' || before == ';' || before == '{' || before == ')';
}

/// Returns whether the semicolon at `at` is itself the body of an `if` or `else`. If it is not,
/// an empty macro precedes the semicolon.
bool is_whole_body(std::string_view line, std::size_t at) {
  std::string_view before = trimmed(line.substr(0, at));
  if (ends_in_word(before, "else")) return true;
  int open = 0;
  for (std::size_t i = before.size(); i-- > 0;) {
    open += before[i] == ')' ? 1 : before[i] == '(' ? -1 : 0;
    if (open == 0) return before[i] == '(' && ends_in_word(trimmed(before.substr(0, i)), "if");
  }
  return false;
}

constexpr std::string_view kIncluded = "In file included from";

bool is_context(std::string_view line) {
  return line.starts_with(kIncluded) || has(line, ": In ") || has(line, ": At global scope") ||
         has(line, ":   required from ");
}

/// Returns the function whose result a statement ignores, if Arduino defines it as a macro. gcc then reports
/// each part of the macro.
std::string ignored_macro(const std::vector<std::string>& message) {
  if (message.size() < 2 || !has(message[0], "conditional expression has no effect")) return "";
  for (const char* macro : {"constrain", "abs", "min", "max", "round"})
    if (has(message[1], std::string(macro) + "(")) return macro;
  return "";
}

/// Returns the first name in quotes; empty if the message has none.
std::string name_in_quotes(const std::string& message) {
  const std::size_t begin = message.find('\'');
  if (begin == message.npos) return "";
  return message.substr(begin + 1, message.find('\'', begin + 1) - begin - 1);
}

/// Returns whether a warning shows a likely mistake. `message` contains the line of the warning, and the
/// source lines that gcc shows below it.
bool is_slip(const std::vector<std::string>& message) {
  const std::string& first = message.front();
  if (has(first, "[-Wdangling-else]")) return false;
  if (has(first, "[-Wshadow")) return false;  // part of the -Wunused-… warning about the new variable
  // gcc 12 gives these messages without a line. condition_warnings() reports the line.
  if (has(first, "equal-tests is always")) return false;
  // A macro such as constrain() may compare a byte with 0.
  if (has(first, "[-Wtype-limits]"))
    return std::none_of(message.begin(), message.end(),
                        [](const std::string& line) { return has(line, "in expansion of macro"); });
  if (has(first, "[-Wparentheses]"))
    return has(first, "assignment used as truth value") || has(first, "comparisons like");
  if (!has(first, "[-Wempty-body]") || message.size() < 3) return true;
  const std::size_t caret = message[2].find('^');
  return caret >= message[1].size() || is_whole_body(message[1], caret);
}

/// Returns the lines of a text. Removes the includes that gcc lists before a note on a line in another file.
/// The note then follows its message.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  const auto lists_include = [](const std::string& line) {
    return line.starts_with(kIncluded) || line.starts_with("                 from ");
  };
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, end - at);
    while (has(line, ": note: ") && !lines.empty() && lists_include(lines.back())) lines.pop_back();
    lines.push_back(std::move(line));
    at = end + 1;
  }
  return lines;
}

/// Calls `use(context, message)` for each message. `context` contains the lines since the previous message,
/// such as "My.ino: In function 'void loop()':". `message` contains the line of the message, and the source
/// lines that gcc shows below it.
template <typename Use>
void for_each_message(const std::string& messages, Use use) {
  std::vector<std::string> context, message;
  const auto close = [&] {
    if (!message.empty()) use(context, message);
    message.clear();
  };
  for (std::string& line : lines_of(messages)) {
    const bool follows = line.empty() || line.front() == ' ' || line.front() == '\t' || has(line, ": note: ");
    std::vector<std::string>* part = &message;
    if (follows && message.empty()) {
      part = &context;
    } else if (!follows && is_context(line)) {
      if (!message.empty()) {
        close();
        context.clear();
      }
      part = &context;
    } else if (!follows) {
      close();
    }
    part->push_back(std::move(line));
  }
  close();
}

/// Returns "My.ino:4:11" of "My.ino:4:11: warning: ...".
std::string place_of(const std::string& message) { return message.substr(0, message.find(": ")); }

/// Returns the places of declarations that hide another variable. The values are the hidden variables' lines:
/// "line 4", or "My.h, line 4" in another file.
std::map<std::string, std::string> hidden_variables(const std::string& messages) {
  std::map<std::string, std::string> hidden;
  if (!has(messages, "[-Wshadow")) return hidden;
  for_each_message(messages, [&](std::vector<std::string>&, const std::vector<std::string>& message) {
    if (!has(message[0], "[-Wshadow")) return;
    for (const std::string& line : message) {
      if (!has(line, ": note: ")) continue;
      const std::string place = line_of(line), file = place.substr(0, place.find(':'));
      const std::string number = place.substr(file.size() + 1, place.size() - file.size() - 2);
      const bool is_here = message[0].starts_with(file + ':');
      hidden.emplace(place_of(message[0]), (is_here ? "line " : file + ", line ") + number);
    }
  });
  return hidden;
}

/// Returns the warnings of these gcc options, each with the lines that gcc shows below it.
std::vector<std::string> warnings_of(const std::string& messages,
                                     std::initializer_list<std::string_view> options) {
  const auto has_one = [&](std::string_view text) {
    return std::any_of(options.begin(), options.end(), [&](std::string_view one) { return has(text, one); });
  };
  std::vector<std::string> found;
  if (!has_one(messages)) return found;
  for_each_message(messages, [&](std::vector<std::string>&, std::vector<std::string>& message) {
    if (!has_one(message.front()) || !has(message.front(), ": warning: ")) return;
    std::string& text = found.emplace_back(message.front());
    for (std::size_t i = 1; i < message.size(); ++i) text += '\n' + message[i];
  });
  return found;
}

}  // namespace

std::string line_of(const std::string& message) {
  const std::size_t colon = message.find(':');
  return message.substr(0, message.find(':', colon + 1) + 1);
}

std::string without_style_warnings(const std::string& messages) {
  constexpr std::string_view kFiltered[] = {
      "[-Wparentheses]",       "[-Wempty-body]", "[-Wtype-limits]",     "[-Wunused-value]",
      "equal-tests is always", "[-Wshadow",      "[-Wunused-variable]", "[-Wunused-but-set-variable]"};
  if (std::none_of(std::begin(kFiltered), std::end(kFiltered),
                   [&](std::string_view one) { return has(messages, one); }))
    return messages;
  const std::map<std::string, std::string> hidden = hidden_variables(messages);
  std::string shown, last_without_effect;
  for_each_message(messages, [&](std::vector<std::string>& context, std::vector<std::string>& message) {
    if (!is_slip(message)) return;
    if (has(message[0], "assignment used as truth value"))
      message[0] = place_of(message[0]) +
                   ": warning: '=' assigns a value in this condition: write '==' to compare [-Wparentheses]";
    if (has(message[0], "[-Wunused-value]")) {
      const std::string line = line_of(message[0]);
      if (std::exchange(last_without_effect, line) == line) return context.clear();  // one per line
      if (const std::string macro = ignored_macro(message); !macro.empty()) {
        message.resize(std::min<std::size_t>(message.size(), 2));
        message[0] =
            fmt::format("{} warning: {}() changes nothing here, but returns a result: write x = {}(x, …)",
                        line, macro, macro);
      }
    }
    if (has(message[0], "[-Wunused-variable]") || has(message[0], "[-Wunused-but-set-variable]")) {
      const auto one = hidden.find(place_of(message[0]));
      if (one == hidden.end()) return;
      message[0] = fmt::format(
          "{}: warning: '{}' is a new variable that hides the one of {}, and nothing uses it: to set the "
          "other "
          "one, remove the type",
          one->first, name_in_quotes(message[0]), one->second);
    }
    for (const std::vector<std::string>* part : {&context, &message})
      for (const std::string& line : *part) shown += line + '\n';
    context.clear();
  });
  if (!shown.empty()) shown.pop_back();
  return shown;
}

std::vector<std::string> width_warnings(const std::string& messages) {
  return warnings_of(messages, {"[-Woverflow]", "[-Wshift-count-overflow]", "[-Wshift-overflow"});
}

std::vector<std::string> unset_warnings(const std::string& messages) {
  std::vector<std::string> found = warnings_of(
      messages, {"[-Wanalyzer-use-of-uninitialized-value]", "[-Wmaybe-uninitialized]", "[-Wuninitialized]"});
  std::erase_if(found, [](const std::string& message) { return has(message, "'<unknown>'"); });
  return found;
}

}  // namespace robosim::build
