#include "sim/build/warning_filter.h"

#include <algorithm>
#include <initializer_list>
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

bool is_context(std::string_view line) {
  return line.starts_with("In file included from") || has(line, ": In ") || has(line, ": At global scope");
}

/// Returns whether a warning shows a likely mistake. `message` contains its line, and the source that gcc
/// shows below.
bool is_slip(const std::vector<std::string>& message) {
  const std::string& first = message.front();
  if (has(first, "[-Wdangling-else]")) return false;
  if (has(first, "[-Wparentheses]"))
    return has(first, "assignment used as truth value") || has(first, "comparisons like");
  if (!has(first, "[-Wempty-body]") || message.size() < 3) return true;
  const std::size_t caret = message[2].find('^');
  return caret >= message[1].size() || is_whole_body(message[1], caret);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

/// Calls `use(context, message)` for each message. `context` contains the lines since the previous message,
/// such as "My.ino: In function 'void loop()':". `message` contains its line, and the lines that gcc shows
/// below.
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

/// Returns the warnings by options of gcc, each with the lines that gcc shows below it.
std::vector<std::string> warnings_of(const std::string& messages,
                                     std::initializer_list<std::string_view> options) {
  const auto has_one = [&](std::string_view text) {
    return std::any_of(options.begin(), options.end(), [&](std::string_view one) { return has(text, one); });
  };
  std::vector<std::string> found;
  if (!has_one(messages)) return found;
  for_each_message(messages, [&](std::vector<std::string>&, const std::vector<std::string>& message) {
    if (!has_one(message.front()) || !has(message.front(), ": warning: ")) return;
    std::string& text = found.emplace_back(message.front());
    for (std::size_t i = 1; i < message.size(); ++i) text += '\n' + message[i];
  });
  return found;
}

}  // namespace

std::string without_style_warnings(const std::string& messages) {
  if (!has(messages, "[-Wparentheses]") && !has(messages, "[-Wempty-body]")) return messages;
  std::string shown;
  for_each_message(messages, [&](std::vector<std::string>& context, const std::vector<std::string>& message) {
    if (!is_slip(message)) return;
    for (const std::vector<std::string>* part : {&std::as_const(context), &message})
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
