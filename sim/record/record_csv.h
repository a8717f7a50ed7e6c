// Recordings as .csv: a run's samples as a table. The format is in docs/recordings.md.
#pragma once

#include <filesystem>
#include <string>

#include "sim/wire/messages.h"

namespace robosim::record {

/// How often a recording takes a sample, simulated time.
constexpr std::int64_t kRecordEvery_ns = 10'000'000;

/// Gathers rows in memory; nothing is written before save().
class CsvRecord {
 public:
  explicit CsvRecord(std::filesystem::path path) : path_(std::move(path)) {}
  /// Takes `started` for the header and samples for the rows; ignores everything else.
  void add(const wire::Event& event);
  const std::string& text() const { return text_; }
  /// Whole or not at all. Throws InputError.
  void save() const;

 private:
  std::filesystem::path path_;
  std::string text_;
};

/// The file endings of recordings: ".csv", ".vcd" (record_vcd.h).
const std::vector<std::string>& record_endings();
/// Throws InputError naming the endings that exist if the file has another.
void check_record_ending(const std::filesystem::path& path);

}  // namespace robosim::record
