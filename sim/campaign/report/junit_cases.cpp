#include "sim/campaign/report/junit_cases.h"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <system_error>
#include <type_traits>

#include "sim/base/error.h"

namespace robosim::campaign {
namespace {

constexpr std::size_t kMostMessage_bytes = 4000;

/// Returns the part of a test's output that explains its failure. For GoogleTest, this is the text between
/// the lines that begin and end the test. Otherwise, it is the end of the output.
std::string why_in(std::string_view printed) {
  const std::size_t failed = printed.find("\n[  FAILED  ]");
  if (failed != printed.npos) {
    printed = printed.substr(0, failed);
    const std::size_t run = printed.rfind("[ RUN      ]");
    if (run != printed.npos) printed.remove_prefix(std::min(printed.find('\n', run), printed.size()));
  } else if (printed.size() > kMostMessage_bytes) {
    printed.remove_prefix(printed.size() - kMostMessage_bytes);
    printed.remove_prefix(std::min(printed.find('\n'), printed.size()));
  }
  const std::size_t first = printed.find_first_not_of(" \r\n"), last = printed.find_last_not_of(" \r\n");
  return first == printed.npos ? std::string() : std::string(printed.substr(first, last + 1 - first));
}

class Reader {
 public:
  Reader() : parser_(XML_ParserCreate(nullptr)) {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), begin, end);
    XML_SetCharacterDataHandler(parser_.get(), [](void* self, const XML_Char* text, int size) {
      Reader& reader = *static_cast<Reader*>(self);
      if (reader.text_ && reader.text_->size() < kMostText)
        reader.text_->append(text, static_cast<std::size_t>(size));
    });
    // Rejects a document type, because its declarations could expand a small file to a huge one.
    XML_SetStartDoctypeDeclHandler(parser_.get(), [](void* self, auto...) {
      static_cast<Reader*>(self)->refused_ = "document types are not supported";
      XML_StopParser(static_cast<Reader*>(self)->parser_.get(), XML_FALSE);
    });
  }

  std::vector<JunitCase> read(std::string_view text, const std::string& file) {
    const auto fail = [&](const std::string& problem) { throw InputError({file, line()}, problem); };
    if (text.size() > kMost) fail(fmt::format("the file is too large: expected at most {} MB", kMost >> 20));
    if (XML_Parse(parser_.get(), text.data(), static_cast<int>(text.size()), XML_TRUE) != XML_STATUS_OK)
      fail(refused_.empty()
               ? fmt::format("this is not valid XML: {}", XML_ErrorString(XML_GetErrorCode(parser_.get())))
               : refused_);
    if (cases_.empty())
      fail("expected at least one <testcase>, as robosim test --junit and ctest --output-junit write them");
    return std::move(cases_);
  }

 private:
  int line() const {
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9  // Expat 2.9 deprecates the function below
    return static_cast<int>(XML_GetCurrentLineNumber64(parser_.get()));
#else
    return static_cast<int>(XML_GetCurrentLineNumber(parser_.get()));
#endif
  }

  static constexpr std::size_t kMost = std::size_t{256} << 20, kMostText = std::size_t{1} << 20;

  static void begin(void* self, const XML_Char* name, const XML_Char** attributes) {
    static_cast<Reader*>(self)->begin(name, attributes);
  }
  static void end(void* self, const XML_Char* name) {
    Reader& reader = *static_cast<Reader*>(self);
    reader.text_ = nullptr;
    if (std::string_view(name) == "testcase") reader.end_case();
  }

  void begin(std::string_view name, const XML_Char** attributes) {
    const auto attribute = [&](std::string_view key) -> std::string_view {
      for (const XML_Char** at = attributes; *at; at += 2)
        if (key == *at) return at[1];
      return {};
    };
    if (name == "testcase") {
      open_ = true;
      JunitCase& one = cases_.emplace_back();
      one.name = attribute("name");
      const std::string_view owner = attribute("classname");
      one.group = !owner.empty() && owner != one.name ? owner : one.name.substr(0, one.name.find('.'));
      one.time_s = number(attribute("time")).value_or(0.0);
      const std::string_view status = attribute("status");
      if (status == "fail") one.ending = JunitCase::Ending::failed;
      if (status == "notrun" || status == "disabled") one.ending = JunitCase::Ending::skipped;
    } else if (!open_) {
      return;
    } else if (name == "failure" || name == "error") {
      JunitCase& one = cases_.back();
      one.ending = JunitCase::Ending::failed;
      const std::string_view message = attribute("message");
      if (message.empty()) text_ = &failure_;
      one.message += one.message.empty() || message.empty() ? message : "\n" + std::string(message);
    } else if (name == "skipped") {
      cases_.back().ending = JunitCase::Ending::skipped;
    } else if (name == "system-out") {
      text_ = &printed_;
    } else if (name == "property") {
      property(attribute("name"), attribute("value"));
    }
  }

  void property(std::string_view name, std::string_view value) {
    JunitCase& one = cases_.back();
    if (name == "failed_run") one.again = value;
    if (name == "failed_trace_hash") one.trace_hash = value;
    if (name == "cross_track_max_mm") one.off_line_mm = number(value);
    if (name == "best_lap_s") one.best_lap_s = number(value);
  }

  void end_case() {
    JunitCase& one = cases_.back();
    if (one.ending == JunitCase::Ending::failed && one.message.empty()) one.message = why_in(failure_);
    if (one.ending == JunitCase::Ending::failed && one.message.empty()) one.message = why_in(printed_);
    failure_.clear();
    printed_.clear();
    open_ = false;
  }

  /// Returns nothing for a text that is not a finite number.
  static std::optional<double> number(std::string_view text) {
    double value = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    return read.ec == std::errc() && std::isfinite(value) ? std::optional(value) : std::nullopt;
  }

  struct Free {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
  };
  std::unique_ptr<std::remove_pointer_t<XML_Parser>, Free> parser_;
  std::vector<JunitCase> cases_;
  std::string refused_;
  bool open_ = false;              ///< whether a case is open
  std::string failure_, printed_;  ///< texts of the open case
  std::string* text_ = nullptr;    ///< destination of the current text
};

}  // namespace

std::vector<JunitCase> read_junit(std::string_view text, const std::string& file) {
  return Reader().read(text, file);
}

std::string kept_page(const std::string& message) {
  constexpr std::string_view kBefore = "\n  kept:   ", kBetween = "; open its ", kBehind = " in a browser";
  std::size_t begin = message.find(kBefore);
  if (begin == message.npos) return {};
  begin += kBefore.size();
  const std::string line = message.substr(begin, message.find('\n', begin) - begin);
  const std::size_t between = line.rfind(kBetween), behind = line.rfind(kBehind);
  if (between == line.npos || behind == line.npos || behind < between) return {};
  const std::size_t name = between + kBetween.size();
  return line.substr(0, between) + "/" + line.substr(name, behind - name);
}

}  // namespace robosim::campaign
