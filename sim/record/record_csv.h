// Recordings as .csv: a run's samples as a table. The format is in docs/recordings.md.
#pragma once

#include "sim/record/recorder.h"

namespace robosim::record {

/// Gathers rows in memory; nothing is written before the end.
class CsvRecorder final : public Recorder {
 public:
  explicit CsvRecorder(std::filesystem::path path) : path_(std::move(path)) {}
  /// Takes `started` for the header and samples for the rows; ignores everything else.
  void add(const wire::Event& event) override;
  void finish(const wire::RunResult&) override;
  const std::string& text() const { return text_; }

 private:
  std::filesystem::path path_;
  std::string text_;
};

}  // namespace robosim::record
