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
  /// Which of a robot's readings stands in a column; the table's columns behind the last have none.
  using Cells = std::vector<std::size_t>;
  static constexpr std::size_t kEmpty = static_cast<std::size_t>(-1);

  void begin_robot(const wire::Started& started);
  std::size_t column_of(const std::string& reading);
  void add_row(const wire::Sample& sample);

  std::filesystem::path path_;
  struct Row {
    std::size_t end;    ///< in rows_
    std::size_t width;  ///< in readings; columns that came later are not there
  };

  std::vector<std::string> robots_;    ///< names, where there are several
  std::vector<std::string> readings_;  ///< columns
  std::vector<Cells> cells_;           ///< of each robot
  std::string rows_;                   ///< one behind the other
  std::vector<Row> row_ends_;
};

}  // namespace robosim::record
