// Recordings as .rec, and as .html: the same inside the page of sim/page, which any browser opens.
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
  void finish(const wire::RunResult& result) override;

 protected:
  virtual void write(Gatherer& gatherer, const wire::RunResult& result, NewFile& file) const;

 private:
  std::filesystem::path path_;
  Gatherer gatherer_{std::make_unique<Deflater>()};
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
  void write(Gatherer& gatherer, const wire::RunResult& result, NewFile& file) const override;
};

/// The bytes of a .rec: these, or those in a page; throws InputError, without a place, if it is neither.
std::string recording_in(std::string content);

}  // namespace robosim::record
