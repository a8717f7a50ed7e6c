#include "sim/base/file_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace robosim {
namespace {

constexpr std::size_t kLooked_bytes = std::size_t{64} << 10;

struct KindText {
  const char* name;
  const char* hint;
};

KindText text_of(FileKind kind) {
  switch (kind) {
    case FileKind::map:
      return {"a map", "give it with --map"};
    case FileKind::robot:
      return {"a robot file", "give it with --robot"};
    case FileKind::checks:
      return {"a file of checks", "robosim test --checks runs it"};
    case FileKind::fleet:
      return {"a fleet's file", "robosim run runs it in place of a sketch"};
    case FileKind::script:
      return {"a script", "give it with --script"};
    case FileKind::sketch:
      return {"a sketch", "robosim run runs it"};
    case FileKind::image:
      return {"a compiled image", "robosim run runs it in place of a sketch"};
    case FileKind::recording:
      return {"a recording", "robosim replay plays it"};
    case FileKind::log:
      return {"a calibration log", "robosim calibrate ROBOT LOG reads it"};
    case FileKind::table:
      return {"a table", "robosim report reads the table of a sweep"};
  }
  return {"", ""};
}

std::string_view trimmed(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == line.npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
}

/// Returns the key that a line of TOML sets; empty if the line sets no key.
std::string_view key_in(std::string_view line) {
  const std::size_t end =
      line.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-");
  const std::string_view rest = end == line.npos ? "" : trimmed(line.substr(end));
  return rest.starts_with('=') ? line.substr(0, end) : "";
}

std::optional<FileKind> kind_of_toml(std::string_view line) {
  for (const char* table : {"[chassis]", "[motors]", "[driver]", "[electronics]", "[budget]", "[[part]]"})
    if (line.starts_with(table)) return FileKind::robot;
  if (line.starts_with("[[check]]")) return FileKind::checks;
  if (line.starts_with("[[agent]]")) return FileKind::fleet;
  const std::string_view key = key_in(line);
  return key == "base" || key == "board" ? std::optional(FileKind::robot) : std::nullopt;
}

bool is_row_of_map(std::string_view line) {
  return line.size() > 1 && line.find_first_not_of("0123456789 _.#SGx") == line.npos;
}

std::optional<FileKind> kind_of_bytes(std::string_view text) {
  if (text.starts_with("\x7F"
                       "ELF"))
    return FileKind::image;
  if (text.starts_with(":10") && text.size() > 11 &&
      text.substr(1, 10).find_first_not_of("0123456789ABCDEF") == text.npos)
    return FileKind::image;
  if (text.find("# robosim calibration log") != text.npos) return FileKind::log;
  if (text.starts_with("robosim.rec/")) return FileKind::recording;
  if (text.starts_with("<!DOCTYPE html") || text.starts_with("<!doctype html")) return FileKind::recording;
  return std::nullopt;
}

}  // namespace

std::optional<FileKind> kind_of(std::string_view text) {
  text = text.substr(0, kLooked_bytes);
  text = without_byte_order_mark(text);
  if (const auto kind = kind_of_bytes(text)) return kind;
  if (text.starts_with("+++")) return FileKind::map;
  bool only_rows = true, is_first = true;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view whole = text.substr(begin, end - begin), line = trimmed(whole);
    begin = end + 1;
    if (line.empty() || line[0] == '#') {
      only_rows &= line.empty() || is_row_of_map(line);
      continue;
    }
    if (const auto kind = kind_of_toml(line)) return kind;
    if (line.starts_with("void setup(") || line.starts_with("void loop(") || line.starts_with("#include"))
      return FileKind::sketch;
    if (is_first && (line.starts_with("at ") || line.starts_with("after "))) return FileKind::script;
    if (is_first && line.starts_with("t_us,")) return FileKind::log;
    if (is_first && std::count(line.begin(), line.end(), ',') >= 2 &&
        line.find_first_of("[]=\"{}") == line.npos)
      return FileKind::table;
    only_rows &= is_row_of_map(line);
    is_first = false;
  }
  return only_rows && !is_first ? std::optional(FileKind::map) : std::nullopt;
}

void refuse_other_kind(std::string_view text, FileKind wanted, const std::string& file) {
  const std::optional<FileKind> kind = kind_of(text);
  if (!kind || *kind == wanted) return;
  if (wanted == FileKind::log && *kind == FileKind::table) return;  // the log may have unusual columns
  const KindText got = text_of(*kind);
  throw InputError({file}, fmt::format("expected {}, got {}; {}", text_of(wanted).name, got.name, got.hint));
}

}  // namespace robosim
