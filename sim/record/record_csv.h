// Recordings as .csv: a run's samples as a table. The format is in docs/recordings.md.
#pragma once

#include "sim/record/recorder.h"

namespace robosim::record {

/// Gathers rows in memory; nothing is written before the end.
class CsvRecorder final : public Recorder {
 public:
  explicit CsvRecorder(std::filesystem::path path) : path_(std::move(path)) {}
  void begin(const RecordedRun& run) override;
  /// Takes `started` for the header and samples for the rows; ignores everything else.
  void add(const wire::Event& event) override;
  void finish(const wire::RunResult&) override;
  /// The table so far.
  std::string text() const;

 private:
  std::size_t column_of(const std::string& reading);
  void add_row(const wire::Sample& sample);

  std::filesystem::path path_;
  std::vector<std::string> robots_;                ///< names, where there are several
  std::vector<std::string> readings_;              ///< columns
  std::vector<std::vector<std::size_t>> columns_;  ///< of each robot's readings
  std::vector<std::string> rows_;                  ///< without the cells of columns that came later
  std::vector<std::size_t> widths_;                ///< of rows, in readings
};

}  // namespace robosim::record
