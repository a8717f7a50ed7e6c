// Collects the data of a run during the run, and reads recordings. A .rec file contains only the recording.
// A .html file contains the recording inside a page.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/record/compressed.h"
#include "sim/record/compressed_stream.h"
#include "sim/record/recorder.h"
#include "sim/record/recording_header.h"

namespace robosim::record {

/// Collects the data of a run. encode() writes the recording; content() returns its uncompressed form.
class Gatherer {
 public:
  /// Limits for all robots together. Beyond them, changes of pins and voltages are thinned, and further
  /// serial text is dropped.
  static constexpr std::size_t kMostChanges_bytes = 4'000'000;
  static constexpr std::size_t kMostSerial_bytes = 8'000'000;
  static constexpr std::int64_t kThinned_ns = 20'000'000;

  /// With a packer, compresses during the run.
  explicit Gatherer(std::unique_ptr<Packer> packer = nullptr,
                    std::size_t most_changes_bytes = kMostChanges_bytes)
      : packer_(std::move(packer)), most_changes_bytes_(most_changes_bytes) {
    streams_.emplace_back(packer_.get());
  }
  void begin(const RecordedRun& run);
  void add(const wire::Event& event);
  /// Returns the header so far. content() and encode() add the result and the streams.
  const RecordingHeader& header() const { return header_; }
  std::string content(const result::RunResult& result);
  void encode(const result::RunResult& result, const Put& put);
  std::string encoded(const result::RunResult& result);

 private:
  /// The columns that `watch` needs from each sample: first the time, then the sensors.
  struct LineColumns {
    LineWatch watch;
    std::vector<std::size_t> numbers;
    std::vector<wire::ColumnReader> readers;
  };
  /// The streams of one robot.
  struct Streams {
    explicit Streams(Packer* packer) : serial(packer), serial_text(packer) {}

    std::map<std::string, CompressedStream> columns;
    std::optional<LineColumns> line;
    wire::Stream serial_rows{"serial", {{"t_ns"}, {"bytes"}}};  ///< rows that are not in `serial` yet
    CompressedStream serial;
    CompressedBytes serial_text;
    bool thinned = false, serial_cut = false;
  };
  RobotRecord& record_of(std::size_t robot) { return robot == 0 ? header_ : header_.others[robot - 1]; }
  void add_columns(const wire::Columns& columns);
  LineColumns line_columns(std::size_t robot, const std::vector<wire::ColumnSpec>& columns);
  void watch_line(std::size_t robot, const std::vector<wire::ColumnSpec>& columns, const wire::Rows& rows);
  void add_serial(const wire::SerialText& serial);
  void finish(std::size_t robot, const result::RunResult& result, std::vector<const CompressedBytes*>& body);
  /// Returns the header's line, and adds the remaining content to `body`.
  std::string finish(const result::RunResult& result, std::vector<const CompressedBytes*>& body);

  std::unique_ptr<Packer> packer_;
  std::size_t most_changes_bytes_;
  RecordingHeader header_;
  std::optional<map::Map> map_;
  std::vector<Streams> streams_;  ///< in the order of robot numbers
};

/// A recording, read from a file.
class Recording {
 public:
  /// Reads a .rec, or a page that contains a recording. Throws InputError for any other file, for a damaged
  /// file, and for a file from a newer version of Robosim. The message is one sentence.
  static Recording read(const std::filesystem::path& file);
  static Recording decode(std::string_view bytes, const std::string& file);

  const RecordingHeader& header() const { return header_; }
  /// Returns a stream's columns in their units. Returns no columns if there is no such stream. `robot` is the
  /// robot's number.
  std::vector<std::vector<double>> stream(const std::string& name, std::size_t robot = 0) const;
  /// Returns a stream's columns as integers: values times the column's scale.
  std::vector<std::vector<std::int64_t>> steps(const std::string& name, std::size_t robot = 0) const;
  /// Reports the events of all robots: first `started`, then samples, serial text and notes in the order of
  /// time.
  void play(const wire::OnEvent& on_event) const;

 private:
  /// Calls visit(column, its bytes, count of its numbers) for each column of a robot's stream.
  template <class Visit>
  void each_column(std::size_t robot, const std::string& stream_name, Visit visit) const;
  /// Calls take(column, its integers) for each column of a robot's stream that is not text.
  template <class Take>
  void each_steps(std::size_t robot, const std::string& stream_name, Take take) const;

  RecordingHeader header_;
  std::string body_;
  std::string file_;
};

}  // namespace robosim::record
