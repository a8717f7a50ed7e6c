#include "sim/record/record_page.h"

#include <fmt/format.h>

#include "sim/base/base64.h"
#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/record/page_text.h"

namespace robosim::record {
namespace {

// In the page's source an empty element, which begins and ends so.
constexpr std::string_view kBegin = R"(<script id="recording" type="application/octet-stream">)";
constexpr std::string_view kOver = R"(<script id="over" type="application/octet-stream">)";
constexpr std::string_view kEnd = "</script>";

}  // namespace

void RecRecorder::ask(wire::RunRequest& request) const {
  request.columns_every_ns = kRecordEvery_ns;
  request.serial = request.notes = true;
}

void RecRecorder::finish(const wire::RunResult& result) {
  write_file(path_, content(gatherer_.encoded(result)));
}

std::string page_of(const std::string& recording, const Over* over) {
  const std::string_view page = page_text();
  const std::size_t at = page.find(kBegin) + kBegin.size();
  std::string text(page.substr(0, at));
  text += base64(recording);
  const std::size_t next = page.find(kOver, at);
  text += page.substr(at, next - at);
  if (over)
    text += fmt::format(R"({} data-name="{}">{})", kOver.substr(0, kOver.size() - 1), base64(over->name),
                        base64(over->bytes));
  else
    text += kOver;
  text += page.substr(next + kOver.size());
  return text;
}

std::string recording_in(std::string content) {
  if (is_recording(content)) return content;
  const std::string_view page = content;
  const std::size_t begin = page.find(kBegin);
  if (begin == std::string_view::npos) throw InputError("it is neither a .rec nor a page of Robosim's");
  const std::string_view rest = page.substr(begin + kBegin.size());
  const std::size_t end = rest.find(kEnd);
  if (end == std::string_view::npos) throw InputError("the page is cut off");
  return from_base64(rest.substr(0, end));
}

}  // namespace robosim::record
