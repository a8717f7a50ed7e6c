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

#include "sim/record/kept_stream.h"
#include "sim/record/recorder.h"
#include "sim/record/recording_header.h"

namespace robosim::record {

/// Gathers a run; encoded() is the recording, and content() what is compressed in it.
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
  /// As far as it is known: without result and streams until encoded().
  const RecordingHeader& header() const { return header_; }
  std::string content(const wire::RunResult& result);
  std::string encoded(const wire::RunResult& result);

 private:
  void add_columns(const wire::Columns& columns);
  std::vector<LineEvent> line_events() const;
  void add_serial(const wire::SerialText& serial);

  std::size_t most_changes_bytes_;
  RecordingHeader header_;
  std::optional<grid::Map> map_;
  std::map<std::string, KeptStream> streams_;
  std::optional<wire::Stream> serial_;
  std::string serial_text_;
  bool thinned_ = false, serial_cut_ = false;
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
