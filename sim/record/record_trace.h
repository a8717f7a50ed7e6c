// Writes recordings as .perfetto.json: a run as a trace, for ui.perfetto.dev and chrome://tracing. The format
// is Chromium's "Trace Event Format" (JSON object form); docs/reference/recordings.md describes the content.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/new_file.h"
#include "sim/record/recording.h"

namespace robosim::record {

/// Writes a trace as its data arrives. Data may arrive stream by stream, or in pieces that alternate between
/// streams.
class TraceFile {
 public:
  struct Robot {
    std::string name;  ///< empty if there is only one robot
    std::string sketch, robot, board;
  };
  TraceFile(const std::filesystem::path& path, const std::string& map, std::uint64_t seed,
            const std::vector<Robot>& robots);

  /// Adds rows of a stream, as integers, column by column. A stream always has the same columns.
  void add(std::size_t robot, const std::string& stream, const std::vector<wire::ColumnSpec>& specs,
           const std::vector<std::vector<std::int64_t>>& columns);
  /// Adds notes and serial text. Ignores everything else.
  void add(const wire::Event& event);
  void finish(const result::RunResult& result);

 private:
  /// A value that is drawn as a curve.
  struct Counter {
    std::string head;
    double scale = 1.0;
    int decimals = -1;  ///< decimals of the values; -1: the scale is not a power of ten
    std::int64_t last = 0;
    bool is_told = false;
  };
  /// A state that is drawn as bars.
  struct Pin {
    std::string head;
    std::int64_t from_ns = 0;
    std::string text;  ///< text of the present bar; empty = no bar
  };
  struct Streams {
    std::map<std::string, std::vector<Counter>> counters;
    std::map<std::string, Pin> pins;
    std::string name;
  };

  void put(std::string_view text);
  void put(std::string_view head, std::int64_t t_ns);
  void name(int group, int row, const std::string& name);
  void count(Counter& counter, std::int64_t t_ns, std::int64_t steps);
  void add_counters(std::size_t robot, const std::string& stream, const std::vector<wire::ColumnSpec>& specs,
                    const std::vector<std::vector<std::int64_t>>& columns);
  void add_pin(std::size_t robot, const std::string& stream, const std::vector<wire::ColumnSpec>& specs,
               const std::vector<std::vector<std::int64_t>>& columns);
  void end_bar(Pin& pin, std::int64_t t_ns);
  void moment(std::size_t robot, int row, std::int64_t t_ns, const std::string& text);
  void finish(std::size_t robot, const result::RunResult& result);

  NewFile file_;
  std::vector<Streams> robots_;
};

class TraceRecorder final : public Recorder {
 public:
  explicit TraceRecorder(std::filesystem::path path) : path_(std::move(path)) {}
  void ask(wire::RunRequest& request) const override;
  void begin(const RecordedRun& run) override;
  void add(const wire::Event& event) override;
  void finish(const result::RunResult& result) override;

 private:
  struct Stream {
    std::vector<wire::ColumnSpec> specs;
    std::vector<wire::ColumnReader> readers;
  };

  std::filesystem::path path_;
  std::unique_ptr<TraceFile> trace_;
  std::vector<std::map<std::string, Stream>> streams_;  ///< per robot
};

/// Writes a recording as a trace.
void write_trace(const Recording& recording, const std::filesystem::path& file);

}  // namespace robosim::record
