// A recorded run: gathered while it lasts, and read back. The same in run.rec and, wrapped in a page, in
// run.html.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/record/column.h"
#include "sim/record/recorder.h"
#include "sim/record/recording_header.h"

namespace robosim::record {

/// Rows, column by column.
class Stream {
 public:
  Stream(std::string name, std::vector<ColumnSpec> columns);
  /// One value for each column.
  void add(const std::vector<double>& row);
  std::size_t bytes() const;
  /// Adds its bytes to `body`.
  StreamInfo write(std::string& body) const;

 private:
  std::string name_;
  std::vector<Column> columns_;
  std::int64_t count_ = 0;
};

/// What happens at one pin: every change as long as that fits, and beside it the last in each span.
class Changes {
 public:
  Changes(const std::string& name, const std::vector<ColumnSpec>& columns)
      : all_(name, columns), few_(all_) {}
  /// The first is the time in ns. A row that says nothing new is left out.
  void add(const std::vector<double>& row);
  std::size_t bytes() const { return all_.bytes(); }
  /// Keeps all changes no longer.
  void thin() { thinned_ = true; }
  StreamInfo write(std::string& body);

 private:
  void flush();

  Stream all_, few_;
  std::vector<double> last_;
  bool thinned_ = false, pending_ = false;
};

/// Gathers a run; encoded() is the recording.
class Gatherer {
 public:
  /// More bytes of changes are thinned, and more text of the serial line is left out.
  static constexpr std::size_t kMostChanges_bytes = 4'000'000;
  static constexpr std::size_t kMostSerial_bytes = 8'000'000;
  static constexpr std::int64_t kThinned_ns = 20'000'000;

  explicit Gatherer(std::size_t most_changes_bytes = kMostChanges_bytes)
      : most_changes_bytes_(most_changes_bytes) {}
  void begin(const RecordedRun& run);
  void add(const wire::Event& event);
  std::string encoded(const wire::RunResult& result);

 private:
  void add_sample(const wire::Sample& sample);
  void add_change(const std::string& stream, const std::vector<ColumnSpec>& columns,
                  const std::vector<double>& row);
  void add_serial(const wire::SerialText& serial);

  std::size_t most_changes_bytes_;
  RecordingHeader header_;
  std::optional<grid::Map> map_;
  std::optional<Stream> samples_;
  std::map<std::string, Changes> changes_;
  std::size_t changes_bytes_ = 0;
  std::optional<Stream> serial_;
  std::string serial_text_;
  bool thinned_ = false, serial_cut_ = false;
  std::vector<double> row_;
};

/// One that was read.
class Recording {
 public:
  /// A .rec, or a page that holds one. Throws InputError with one sentence for what is neither, is damaged or
  /// comes from a newer version.
  static Recording read(const std::filesystem::path& file);
  static Recording decode(std::string_view bytes, const std::string& file);

  const RecordingHeader& header() const { return header_; }
  /// A stream's columns in their units; empty if there is none of that name.
  std::vector<std::vector<double>> stream(const std::string& name) const;
  /// Tells samples, serial text and notes in the order of time, after `started`.
  void play(const wire::OnEvent& on_event) const;

 private:
  RecordingHeader header_;
  std::string body_;
  std::string file_;
};

}  // namespace robosim::record
