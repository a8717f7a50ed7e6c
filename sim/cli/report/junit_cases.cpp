#include "sim/cli/report/junit_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "sim/base/error.h"

namespace robosim::cli {
namespace {

std::string character(unsigned code) {
  std::string text;
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) {
    text += static_cast<char>(0xC0 | code >> 6);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0 | code >> 12);
    text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
  } else {
    text += static_cast<char>(0xF0 | (code >> 18 & 7));
    text += static_cast<char>(0x80 | (code >> 12 & 0x3F));
    text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
  }
  return text += static_cast<char>(0x80 | (code & 0x3F));
}

class XmlReader {
 public:
  XmlReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  struct Tag {
    std::string name;
    std::map<std::string, std::string> attributes;
    bool opens = false, closes = false;
  };

  /// The next element's beginning or end; without a name at the end of the text.
  Tag next() {
    for (;;) {
      at_ = std::min(text_.find('<', at_), text_.size());
      if (at_ == text_.size()) return {};
      if (skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<?", "?>")) continue;
      if (text_.substr(at_).starts_with("<!")) fail("a document type is not allowed here");
      return tag();
    }
  }

  [[noreturn]] void fail(const std::string& problem) const {
    const auto before = text_.substr(0, std::min(at_, text_.size()));
    throw InputError({file_, 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'))}, problem);
  }

 private:
  bool skip(std::string_view begin, std::string_view end) {
    if (!text_.substr(at_).starts_with(begin)) return false;
    const std::size_t found = text_.find(end, at_);
    if (found == text_.npos) fail(fmt::format("“{}” is never ended by “{}”", begin, end));
    at_ = found + end.size();
    return true;
  }

  Tag tag() {
    Tag tag;
    ++at_;
    if (take('/'))
      tag.closes = true;
    else
      tag.opens = true;
    tag.name = word();
    for (;;) {
      space();
      if (take('>')) return tag;
      if (take('/')) {
        tag.closes = true;
        continue;
      }
      const std::string key = word();
      space();
      if (!take('=')) fail("an attribute has no value");
      space();
      tag.attributes[key] = value();
    }
  }

  std::string word() {
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n=/>", at_), text_.size());
    if (end == at_ || end == text_.size()) fail("this is no XML");
    std::string word(text_.substr(at_, end - at_));
    at_ = end;
    return word;
  }

  std::string value() {
    const char quote = at_ < text_.size() ? text_[at_] : ' ';
    const std::size_t end = quote == '"' || quote == '\'' ? text_.find(quote, at_ + 1) : text_.npos;
    if (end == text_.npos) fail("an attribute's value is not in quotes");
    const std::string_view raw = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    std::string plain;
    for (std::size_t i = 0; i < raw.size(); ++i) {
      const std::size_t semicolon = raw[i] == '&' ? raw.find(';', i) : raw.npos;
      if (semicolon == raw.npos) {
        plain += raw[i];
        continue;
      }
      plain += entity(std::string(raw.substr(i + 1, semicolon - i - 1)));
      i = semicolon;
    }
    return plain;
  }

  static std::string entity(const std::string& name) {
    static const std::map<std::string, std::string> named{
        {"amp", "&"}, {"lt", "<"}, {"gt", ">"}, {"quot", "\""}, {"apos", "'"}};
    if (const auto found = named.find(name); found != named.end()) return found->second;
    unsigned code = 0;
    const bool hex = name.starts_with("#x");
    const char* const begin = name.data() + (hex ? 2 : 1);
    const auto [end, error] = std::from_chars(begin, name.data() + name.size(), code, hex ? 16 : 10);
    const bool good = name.starts_with('#') && error == std::errc() && end == name.data() + name.size();
    return good && code >= 0x20 && code < 0x110000 ? character(code)
           : good && code == 10                    ? "\n"
                                                   : "\xEF\xBF\xBD";
  }

  void space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
  bool take(char c) {
    if (at_ == text_.size()) fail("it ends within an element");
    return text_[at_] == c ? ++at_, true : false;
  }

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<JunitCase> read_junit(std::string_view text, const std::string& file) {
  XmlReader reader(text, file);
  std::vector<JunitCase> cases;
  bool open = false;  // a case
  for (;;) {
    XmlReader::Tag tag = reader.next();
    if (tag.name.empty()) break;
    auto& attributes = tag.attributes;
    if (tag.name == "testcase" && tag.opens) {
      JunitCase& one = cases.emplace_back();
      const std::string& owner = attributes["classname"];
      one.name = attributes["name"];
      one.group = !owner.empty() && owner != one.name ? owner : one.name.substr(0, one.name.find('.'));
      const std::string& time = attributes["time"];
      std::from_chars(time.data(), time.data() + time.size(), one.time_s);
      if (attributes["status"] == "fail") one.ending = JunitCase::Ending::failed;
      if (attributes["status"] == "notrun" || attributes["status"] == "disabled")
        one.ending = JunitCase::Ending::skipped;
      open = true;
    }
    if (open && tag.opens && (tag.name == "failure" || tag.name == "error")) {
      cases.back().ending = JunitCase::Ending::failed;
      if (cases.back().message.empty()) cases.back().message = attributes["message"];
    }
    if (open && tag.opens && tag.name == "skipped") cases.back().ending = JunitCase::Ending::skipped;
    if (tag.name == "testcase" && tag.closes) open = false;
  }
  if (cases.empty())
    reader.fail("there is no <testcase> in it: robosim test --junit and ctest --output-junit write some");
  return cases;
}

}  // namespace robosim::cli
