// Writes recordings as .rec, and as .html: a recording inside the page of sim/view/page, which opens in any
// browser.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "sim/base/new_file.h"
#include "sim/record/compressed.h"
#include "sim/record/recording.h"

namespace robosim::record {

class RecRecorder : public Recorder {
 public:
  explicit RecRecorder(std::filesystem::path path) : path_(std::move(path)) {}
  void ask(wire::RunRequest& request) const override;
  void begin(const RecordedRun& run) override { gatherer_.begin(run); }
  void add(const wire::Event& event) override { gatherer_.add(event); }
  void finish(const result::RunResult& result) override;

 protected:
  virtual void write(Gatherer& gatherer, const result::RunResult& result, NewFile& file) const;

 private:
  std::filesystem::path path_;
  Gatherer gatherer_{std::make_unique<Deflater>()};
};

/// Another run, drawn over the first one.
struct Over {
  std::string bytes;  ///< content of a .rec, or of a table that a real robot has logged (track.h)
  std::string name;   ///< name of its file
};

/// Returns the page that replays a recording. `recording` is the content of a .rec.
std::string page_of(const std::string& recording, const Over* over = nullptr);

class PageRecorder final : public RecRecorder {
 public:
  using RecRecorder::RecRecorder;

 protected:
  void write(Gatherer& gatherer, const result::RunResult& result, NewFile& file) const override;
};

/// Returns the content of a .rec: the argument itself, or the recording inside a page. For any other content,
/// throws an InputError that does not name a file.
std::string recording_in(std::string content);

}  // namespace robosim::record
