#include "sim/cli/report/junit_cases.h"

#include <expat.h>
#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <type_traits>

#include "sim/base/error.h"

namespace robosim::cli {
namespace {

class Reader {
 public:
  Reader() : parser_(XML_ParserCreate(nullptr)) {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), begin, end);
    // What a document type may declare could make a small file a huge one.
    XML_SetStartDoctypeDeclHandler(parser_.get(), [](void* self, auto...) {
      static_cast<Reader*>(self)->refused_ = "a document type is not allowed here";
      XML_StopParser(static_cast<Reader*>(self)->parser_.get(), XML_FALSE);
    });
  }

  std::vector<JunitCase> read(std::string_view text, const std::string& file) {
    const auto fail = [&](const std::string& problem) {
      throw InputError({file, static_cast<int>(XML_GetCurrentLineNumber(parser_.get()))}, problem);
    };
    if (text.size() > kMost) fail(fmt::format("this has more than {} MB", kMost >> 20));
    if (XML_Parse(parser_.get(), text.data(), static_cast<int>(text.size()), XML_TRUE) != XML_STATUS_OK)
      fail(refused_.empty()
               ? fmt::format("this is no XML: {}", XML_ErrorString(XML_GetErrorCode(parser_.get())))
               : refused_);
    if (cases_.empty())
      fail("there is no <testcase> in it: robosim test --junit and ctest --output-junit write some");
    return std::move(cases_);
  }

 private:
  static constexpr std::size_t kMost = std::size_t{256} << 20;

  static void begin(void* self, const XML_Char* name, const XML_Char** attributes) {
    static_cast<Reader*>(self)->begin(name, attributes);
  }
  static void end(void* self, const XML_Char* name) {
    if (std::string_view(name) == "testcase") static_cast<Reader*>(self)->open_ = false;
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
      const std::string_view time = attribute("time"), status = attribute("status");
      std::from_chars(time.data(), time.data() + time.size(), one.time_s);
      if (status == "fail") one.ending = JunitCase::Ending::failed;
      if (status == "notrun" || status == "disabled") one.ending = JunitCase::Ending::skipped;
    } else if (open_ && (name == "failure" || name == "error")) {
      cases_.back().ending = JunitCase::Ending::failed;
      if (cases_.back().message.empty()) cases_.back().message = attribute("message");
    } else if (open_ && name == "skipped") {
      cases_.back().ending = JunitCase::Ending::skipped;
    }
  }

  struct Free {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
  };
  std::unique_ptr<std::remove_pointer_t<XML_Parser>, Free> parser_;
  std::vector<JunitCase> cases_;
  std::string refused_;
  bool open_ = false;  // a case
};

}  // namespace

std::vector<JunitCase> read_junit(std::string_view text, const std::string& file) {
  return Reader().read(text, file);
}

}  // namespace robosim::cli
