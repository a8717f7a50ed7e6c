#include "sim/wire/columns_line.h"

#include <algorithm>
#include <charconv>

#include "sim/wire/json_writer.h"

namespace robosim::wire {
namespace {

constexpr std::size_t kLong = 24;
constexpr std::string_view kBatchBegin = R"({"bytes":")";
constexpr std::size_t kMostHead_bytes = 128;  // before the text

bool is_plain(
    const std::string& text) {  // base64 is; without a branch, many characters are looked at at once
  unsigned other = 0;
  for (const char c : text)
    other |=
        static_cast<unsigned>(c < '+') | static_cast<unsigned>(c > 'z') | static_cast<unsigned>(c == '\\');
  return other == 0;
}

}  // namespace

std::string columns_text(const Columns& columns) {
  std::string text = "{\"streams\":[";
  for (const Rows& rows : columns.streams) {
    if (&rows != columns.streams.data()) text += ',';
    text += text_of(to_json(Rows{rows.stream, rows.count, rows.columns, {}}));
    text.resize(text.size() - 2);  // ]} of an empty "bytes", which stands last
    for (std::size_t i = 0; i < rows.bytes.size(); ++i) {
      if (i > 0) text += ',';
      if (is_plain(rows.bytes[i]))
        text.append(1, '"').append(rows.bytes[i]).append(1, '"');
      else
        text += text_of(OrderedJson(rows.bytes[i]));
    }
    text += "]}";
  }
  text += ']';
  Columns named;
  named.sources = columns.sources;
  if (!columns.sources.empty())  // without its {
    text += ',' + text_of(to_json(named)).substr(sizeof R"({"streams":[],)" - 1);
  else
    text += '}';
  return text;
}

std::string batch_text(const Batch& batch) {
  if (!is_plain(batch.bytes)) return text_of(to_json(batch));
  return std::string(kBatchBegin) + batch.bytes + "\"}";
}

std::optional<std::string_view> cut_batch(std::string_view line, std::string& left) {
  while (line.ends_with('\n')) line.remove_suffix(1);
  const std::string_view key = kBatchBegin.substr(1);
  const std::size_t begin = line.substr(0, kMostHead_bytes).find(key);
  if (begin == line.npos || line.size() < begin + key.size() + 2 || !line.ends_with("\"}"))
    return std::nullopt;
  const std::string_view text = line.substr(begin + key.size(), line.size() - 2 - begin - key.size());
  if (text.find('"') != text.npos || text.find('\\') != text.npos) return std::nullopt;
  left = std::string(line.substr(0, begin + key.size())) + kCutText + "\"}";
  return text;
}

std::string LongTexts::cut(std::string_view line) {
  texts_.clear();
  if (line.find('\\') != line.npos) return std::string(line);
  std::string left;
  std::size_t from = 0;
  for (;;) {
    const std::size_t begin = line.find('"', from);
    const std::size_t end = begin == line.npos ? line.npos : line.find('"', begin + 1);
    if (end == line.npos) break;
    const std::string_view text = line.substr(begin + 1, end - begin - 1);
    const bool in_array = begin > 0 && (line[begin - 1] == '[' || line[begin - 1] == ',');
    if (in_array && text.size() >= kLong) {
      left.append(line.substr(from, begin + 1 - from)).append("#" + std::to_string(texts_.size()));
      texts_.push_back(text);
      from = end;  // its quote follows
    } else {
      left.append(line.substr(from, end - from));
      from = end;
    }
    left += '"';
    ++from;
  }
  return left.append(line.substr(from));
}

void LongTexts::put_back(Columns& columns) const {
  for (Rows& rows : columns.streams)
    for (std::string& bytes : rows.bytes) {
      std::size_t number = 0;
      if (!bytes.starts_with('#')) continue;
      const auto [end, error] = std::from_chars(bytes.data() + 1, bytes.data() + bytes.size(), number);
      if (error == std::errc() && end == bytes.data() + bytes.size() && number < texts_.size())
        bytes = texts_[number];
    }
}

}  // namespace robosim::wire
