#include "sim/record/record_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "sim/base/base64.h"
#include "sim/base/error.h"
#include "sim/record/page_text.h"

namespace robosim::record {
namespace {

// The page's source contains two empty elements. They begin with kBegin and kOver, and end with kEnd.
constexpr std::string_view kBegin = R"(<script id="recording" type="application/octet-stream">)";
constexpr std::string_view kOver = R"(<script id="over" type="application/octet-stream">)";
constexpr std::string_view kEnd = "</script>";
constexpr std::size_t kPiece_bytes = std::size_t{1} << 16;

/// Calls put(text) with each piece of the page, and put_recording() where the recording's base64 belongs.
template <class PutRecording>
void put_page(const Over* over, const Put& put, const PutRecording& put_recording) {
  const std::string_view page = page_text();
  const std::size_t at = page.find(kBegin) + kBegin.size();
  put(page.substr(0, at));
  put_recording();
  const std::size_t next = page.find(kOver, at);
  put(page.substr(at, next - at));
  put(over ? fmt::format(R"({} data-name="{}">{})", kOver.substr(0, kOver.size() - 1), base64(over->name),
                         base64(over->bytes))
           : std::string(kOver));
  put(page.substr(next + kOver.size()));
}

}  // namespace

void RecRecorder::ask(wire::RunRequest& request) const {
  request.columns_every_ns = kRecordEvery_ns;
  request.serial = request.notes = true;
}

void RecRecorder::finish(const result::RunResult& result) {
  NewFile file(path_);
  write(gatherer_, result, file);
  file.finish();
}

void RecRecorder::write(Gatherer& gatherer, const result::RunResult& result, NewFile& file) const {
  gatherer.encode(result, [&file](std::string_view piece) { file.add(piece); });
}

std::string page_of(const std::string& recording, const Over* over) {
  std::string text;
  const Put put = [&text](std::string_view piece) { text += piece; };
  put_page(over, put, [&] { put(base64(recording)); });
  return text;
}

void PageRecorder::write(Gatherer& gatherer, const result::RunResult& result, NewFile& file) const {
  const Put put = [&file](std::string_view piece) { file.add(piece); };
  put_page(nullptr, put, [&] {
    Base64 digits;
    gatherer.encode(result, [&](std::string_view bytes) {
      for (; !bytes.empty(); bytes.remove_prefix(std::min(kPiece_bytes, bytes.size()))) {
        const std::string_view piece = bytes.substr(0, kPiece_bytes);
        file.added(digits.put(file.room(Base64::most(piece.size())), piece));
      }
    });
    file.added(digits.finish(file.room(Base64::most(0))));
  });
}

std::string recording_in(std::string content) {
  if (is_recording(content)) return content;
  const std::string_view page = content;
  const std::size_t begin = page.find(kBegin);
  if (begin == std::string_view::npos) throw InputError("expected a .rec or a page written by Robosim");
  const std::string_view rest = page.substr(begin + kBegin.size());
  const std::size_t end = rest.find(kEnd);
  if (end == std::string_view::npos) throw InputError("the page is cut off");
  return from_base64(rest.substr(0, end));
}

}  // namespace robosim::record
