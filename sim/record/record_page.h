// Recordings as .rec, and as .html: the same inside the page of sim/page, which any browser opens.
#pragma once

#include <string>
#include <string_view>

#include "sim/record/recording.h"

namespace robosim::record {

class RecRecorder : public Recorder {
 public:
  explicit RecRecorder(std::filesystem::path path) : path_(std::move(path)) {}
  void ask(wire::RunRequest& request) const override;
  void begin(const RecordedRun& run) override { gatherer_.begin(run); }
  void add(const wire::Event& event) override { gatherer_.add(event); }
  void finish(const wire::RunResult& result) override;

 protected:
  /// What is written.
  virtual std::string content(const std::string& recording) const { return recording; }

 private:
  std::filesystem::path path_;
  Gatherer gatherer_;
};

/// Another run that a page lays over its own.
struct Over {
  std::string bytes;  ///< of a .rec or of a table
  std::string name;   ///< of its file
};

/// The page that replays a recording, the bytes of a .rec.
std::string page_of(const std::string& recording, const Over* over = nullptr);

class PageRecorder final : public RecRecorder {
 public:
  using RecRecorder::RecRecorder;

 protected:
  std::string content(const std::string& recording) const override { return page_of(recording); }
};

/// The bytes of a .rec: these, or those in a page; throws InputError, without a place, if it is neither.
std::string recording_in(std::string content);

}  // namespace robosim::record
