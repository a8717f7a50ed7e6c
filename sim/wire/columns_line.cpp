#include "sim/wire/columns_line.h"

#include <charconv>

#include "sim/base/base64.h"
#include "sim/base/error.h"
#include "sim/wire/json_reader.h"

namespace robosim::wire {
namespace {

constexpr std::size_t kLong = 24;

}  // namespace

std::string columns_text(const Columns& columns) {
  std::string text = "{\"streams\":[";
  for (const Rows& rows : columns.streams) {
    if (&rows != columns.streams.data()) text += ',';
    text += text_of(to_json(Rows{rows.stream, rows.count, rows.columns, {}}));
    text.resize(text.size() - 2);  // removes the ]} of an empty "bytes", the last key
    for (std::size_t i = 0; i < rows.bytes.size(); ++i) {
      if (i > 0) text += ',';
      text.append(1, '"').append(base64(rows.bytes[i])).append(1, '"');
    }
    text += "]}";
  }
  text += ']';
  Columns named;
  named.sources = columns.sources;
  if (!columns.sources.empty())  // appends the key `sources` of `named`
    text += ',' + text_of(to_json(named)).substr(sizeof R"({"streams":[],)" - 1);
  else
    text += '}';
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
      from = end;  // at the closing quote
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
      std::string_view text = bytes;
      std::size_t number = 0;
      if (bytes.starts_with('#')) {
        const auto [end, error] = std::from_chars(bytes.data() + 1, bytes.data() + bytes.size(), number);
        if (error == std::errc() && end == bytes.data() + bytes.size() && number < texts_.size())
          text = texts_[number];
      }
      try {
        bytes = from_base64(text);
      } catch (const InputError&) {
        throw BadValue("bytes", "expected base64");
      }
    }
}

}  // namespace robosim::wire
