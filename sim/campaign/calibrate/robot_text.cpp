#include "sim/campaign/calibrate/robot_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/config.h"
#include "sim/base/error.h"

namespace robosim::calibrate {
namespace {

/// Converts a line and column to an offset in the text.
std::size_t offset_of(std::string_view text, const Place& place) {
  std::size_t at = 0;
  for (int line = 1; line < place.line; ++line) at = std::min(text.find('\n', at), text.size() - 1) + 1;
  for (int column = 1; column < place.column && at < text.size(); ++column) {
    ++at;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) ++at;
  }
  return at;
}

std::size_t end_of_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool lines = text.substr(at).starts_with(three);
  at += lines ? 3 : 1;
  while (at < text.size() && (lines ? !text.substr(at).starts_with(three) : text[at] != quote))
    at += quote == '"' && text[at] == '\\' ? 2 : 1;
  at = std::min(at + (lines ? 3 : 1), text.size());
  for (int more = 0; lines && more < 2 && at < text.size() && text[at] == quote; ++more) ++at;
  return at;
}

/// Returns the end of the value that begins at `at`. The text must be valid TOML.
std::size_t end_of_value(std::string_view text, std::size_t at) {
  int depth = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = end_of_string(text, at);
      if (depth == 0) return at;
      continue;
    }
    if (depth == 0 && (c == ',' || c == '#' || c == '\n' || c == '\r' || c == ' ' || c == '\t')) return at;
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') {
      if (depth == 0) return at;
      ++at;
      if (--depth == 0) return at;
      continue;
    }
    ++at;
  }
  return at;
}

struct Change {
  std::size_t begin, end;  // range that is replaced
  std::string text;
};

const ConfigValue* table_of(const ConfigValue& tree, const Figure& figure) {
  if (!figure.of_part) return tree.find(figure.table);
  const ConfigValue* parts = tree.find("part");
  if (!parts) return nullptr;
  for (const ConfigValue& part : parts->items)
    if (const ConfigValue* name = part.find("name"); name && name->string == figure.table) return &part;
  return nullptr;
}

/// Returns the end of the line of a table's last key.
std::size_t end_of_table(std::string_view text, const ConfigValue& table) {
  std::size_t at = offset_of(text, table.place);
  for (const auto& [key, value] : table.members)
    at = std::max(at, end_of_value(text, offset_of(text, value.place)));
  return std::min(text.find('\n', at), text.size());
}

}  // namespace

std::string with_figures(std::string_view text, const std::string& file, const std::vector<Figure>& figures) {
  const ConfigValue tree = parse_toml(text, file);
  const bool returns = text.find("\r\n") != text.npos;
  std::vector<Change> changes;
  std::vector<std::pair<std::string, std::string>> added;  // new tables in order: header, and lines of keys
  for (const Figure& figure : figures) {
    const std::string value = toml_value(figure);
    const ConfigValue* table = table_of(tree, figure);
    if (!table) {
      const std::string header = figure.of_part ? fmt::format("[[part]]\nname = \"{}\"\n", figure.table)
                                                : fmt::format("[{}]\n", figure.table);
      if (added.empty() || added.back().first != header) {
        const auto old =
            std::find_if(added.begin(), added.end(), [&](const auto& one) { return one.first == header; });
        if (old != added.end()) {
          old->second += fmt::format("{} = {}\n", figure.key, value);
          continue;
        }
        added.emplace_back(header, "");
      }
      added.back().second += fmt::format("{} = {}\n", figure.key, value);
    } else if (const ConfigValue* old = table->find(figure.key)) {
      const std::size_t begin = offset_of(text, old->place);
      changes.push_back({begin, end_of_value(text, begin), value});
    } else {
      if (const std::size_t at = offset_of(text, table->place); at >= text.size() || text[at] != '[')
        throw InputError(
            table->place,
            fmt::format("{0} is an inline table, to which {1} cannot be added: expected a table {2}",
                        figure.table, figure.key,
                        figure.of_part ? "[[part]]" : fmt::format("[{}]", figure.table)));
      const std::size_t end = end_of_table(text, *table);
      changes.push_back({end, end, fmt::format("\n{} = {}", figure.key, value)});
    }
  }
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.begin < b.begin; });
  std::string result;
  std::size_t at = 0;
  for (const Change& change : changes) {
    // A new line is inserted before the carriage return of the preceding line.
    std::size_t begin = change.begin;
    std::size_t end = change.end;
    if (end == begin && begin > at && text[begin - 1] == '\r') end = --begin;
    result += text.substr(at, begin - at);
    for (const char c : change.text) result += returns && c == '\n' ? std::string("\r\n") : std::string(1, c);
    at = end;
  }
  result += text.substr(at);
  const std::string line_end = returns ? "\r\n" : "\n";
  for (const auto& [header, keys] : added) {
    if (!result.empty() && !result.ends_with('\n')) result += line_end;
    result += line_end;
    for (const char c : header + keys) result += c == '\n' ? line_end : std::string(1, c);
  }
  return result;
}

}  // namespace robosim::calibrate
