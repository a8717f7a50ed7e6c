// Writes recordings as .csv: a run's samples as a table. docs/reference/recordings.md describes the format.
#pragma once

#include "sim/base/new_file.h"
#include "sim/record/number_text.h"
#include "sim/record/recorder.h"

namespace robosim::record {

/// Writes a table. Rows wait until all robots have begun, because the header contains the names of all their
/// readings.
class CsvRecorder final : public Recorder {
 public:
  explicit CsvRecorder(const std::filesystem::path& path) : file_(path) {}
  void begin(const RecordedRun& run) override;
  /// Uses `started` for the header and samples for the rows. Ignores everything else.
  void add(const wire::Event& event) override;
  void finish(const result::RunResult&) override;

 private:
  /// For each column of the table: index of the robot's reading, or kEmpty. Columns beyond the end of this
  /// list are empty, too.
  using Cells = std::vector<std::size_t>;
  static constexpr std::size_t kEmpty = static_cast<std::size_t>(-1);

  void begin_robot(const wire::Started& started);
  std::size_t column_of(const std::string& reading);
  void add_row(const wire::Sample& sample);
  void write_header();

  NewFile file_;
  std::vector<std::string> robots_;    ///< names, if there are several
  std::vector<std::string> readings_;  ///< columns of the table
  std::vector<Cells> cells_;           ///< per robot
  std::size_t begun_ = 0;              ///< number of robots that have begun
  bool has_header_ = false;
  std::vector<wire::Sample> early_;  ///< samples that wait for the header
  std::vector<LastNumber> last_;     ///< per column
};

}  // namespace robosim::record
