// Recordings as .csv: a run's samples as a table. The format is in docs/reference/recordings.md.
#pragma once

#include "sim/base/new_file.h"
#include "sim/record/number_text.h"
#include "sim/record/recorder.h"

namespace robosim::record {

/// Rows wait until all robots have begun, since the header names what each of them reads.
class CsvRecorder final : public Recorder {
 public:
  explicit CsvRecorder(const std::filesystem::path& path) : file_(path) {}
  void begin(const RecordedRun& run) override;
  /// Takes `started` for the header and samples for the rows; ignores everything else.
  void add(const wire::Event& event) override;
  void finish(const wire::RunResult&) override;

 private:
  /// Which of a robot's readings stands in a column; the table's columns behind the last have none.
  using Cells = std::vector<std::size_t>;
  static constexpr std::size_t kEmpty = static_cast<std::size_t>(-1);

  void begin_robot(const wire::Started& started);
  std::size_t column_of(const std::string& reading);
  void add_row(const wire::Sample& sample);
  void write_header();

  NewFile file_;
  std::vector<std::string> robots_;    ///< names, where there are several
  std::vector<std::string> readings_;  ///< columns
  std::vector<Cells> cells_;           ///< of each robot
  std::size_t begun_ = 0;              ///< robots
  bool has_header_ = false;
  std::vector<wire::Sample> early_;  ///< that wait for the header
  std::vector<LastNumber> last_;     ///< of each column
};

}  // namespace robosim::record
