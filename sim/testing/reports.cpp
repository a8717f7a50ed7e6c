#include "sim/testing/reports.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "sim/testing/failure_context.h"

namespace robosim::testing {
namespace {

/// Escapes the text of a GitHub workflow command.
std::string annotation(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '%')
      result += "%25";
    else if (c == '\n')
      result += "%0A";
    else if (c == '\r')
      result += "%0D";
    else
      result += c;
  }
  return result;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Summarises a failure in one line. From a matcher's message, it extracts the finding and the end of the
/// run.
std::string essence(const std::string& message) {
  const std::string mark = "  Actual: ";
  const std::size_t at = message.find(mark);
  if (at == std::string::npos) return first_line(message);
  const std::string actual = message.substr(at + mark.size());
  const std::size_t type = first_line(actual).find(" (of type ");
  if (type == std::string::npos) return first_line(actual);
  std::string found = actual.substr(0, type) + ":";
  for (const char* told : {"\n", "\n  the run ended at "}) {
    const std::size_t line = actual.find(told);
    if (line != std::string::npos) found += first_line(actual.substr(line + 1)).substr(1);
  }
  return found;
}

std::string name_of(const ::testing::TestInfo& test) {
  return fmt::format("{}.{}", test.test_suite_name(), test.name());
}

class GithubListener final : public ::testing::EmptyTestEventListener {
 public:
  GithubListener(std::string summary, std::string test)
      : summary_(std::move(summary)), test_(std::move(test)) {}

  void OnTestStart(const ::testing::TestInfo& test) override { test_ = name_of(test); }

  void OnTestPartResult(const ::testing::TestPartResult& part) override {
    if (!part.failed()) return;
    // Google Test holds a lock here: calling its functions for the current test would deadlock.
    const std::string then = state_at_failure(part);
    fmt::print("::error file={},line={},title={}::{}\n", part.file_name() ? part.file_name() : "",
               part.line_number() > 0 ? part.line_number() : 1, test_,
               annotation(std::string(part.message()) + (then.empty() ? "" : "\n" + then)));
    std::fflush(stdout);
    rows_ += fmt::format("| `{}` | {} |\n", test_, in_cell(essence(part.message())));
  }

  void OnTestProgramEnd(const ::testing::UnitTest& tests) override {
    if (summary_.empty()) return;
    const bool alone = tests.test_to_run_count() == 1;  // each process of ctest runs one test
    if (alone && rows_.empty()) return;
    const bool continued = alone && ends_in_table();
    std::ofstream out(summary_, std::ios::app | std::ios::binary);
    if (alone && !continued)
      out << "### Robosim: failed tests\n\n";
    else if (!alone)
      out << fmt::format("### Robosim: {} passed, {} failed, {} skipped\n\n", tests.successful_test_count(),
                         tests.failed_test_count(), tests.skipped_test_count());
    if (!continued && !rows_.empty()) out << "| test | what was found |\n|---|---|\n";
    out << rows_;
    if (!alone && !rows_.empty()) out << "\n";
  }

 private:
  static std::string in_cell(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
    return result;
  }

  bool ends_in_table() const {
    std::ifstream in(summary_, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    return text.size() > 1 && text.compare(text.size() - 2, 2, "|\n") == 0;
  }

  std::string summary_, test_, rows_;
};

}  // namespace

void report_to_github() {
  static bool done = false;
  if (done || !std::getenv("GITHUB_ACTIONS")) return;
  done = true;
  const char* summary = std::getenv("GITHUB_STEP_SUMMARY");
  const ::testing::TestInfo* now = ::testing::UnitTest::GetInstance()->current_test_info();
  ::testing::UnitTest::GetInstance()->listeners().Append(
      new GithubListener(summary ? summary : "", now ? name_of(*now) : "a test"));
}

void record_figures(const RunLog& log, const result::RunResult& result) {
  if (!::testing::UnitTest::GetInstance()->current_test_info()) return;
  const auto record = [](const char* key, const std::string& value) {
    ::testing::Test::RecordProperty(std::string("robosim_") + key, value);
  };
  record("target", log.trial.target);
  record("seed", std::to_string(log.trial.seed));
  record("time_s", fmt::format("{:.3f}", result.time_s));
  record("distance_m", fmt::format("{:.3f}", result.metrics.distance_m));
  record("cross_track_rms_mm", fmt::format("{:.2f}", result.metrics.cross_track_rms_mm));
  record("cross_track_max_mm", fmt::format("{:.2f}", result.metrics.cross_track_max_mm));
  record("collisions", std::to_string(result.metrics.collisions));
  record("trace_hash", result.trace_hash);
  if (!result.resources) return;
  record("flash_bytes", std::to_string(result.resources->flash_bytes));
  record("free_bytes_min", std::to_string(result.resources->free_bytes_min));
  record("ram_bytes", std::to_string(result.resources->ram_bytes));
  record("stack_bytes_max", std::to_string(result.resources->stack_bytes_max));
  record("loop_us_max", fmt::format("{:.1f}", result.resources->loop_us_max));
}

void record_trace(const std::string& trace_hash) {
  static const ::testing::TestInfo* test = nullptr;
  static std::uint64_t sum = 0;
  const ::testing::TestInfo* now = ::testing::UnitTest::GetInstance()->current_test_info();
  if (!now) return;
  if (now != test) sum = 0;
  test = now;
  std::uint64_t hash = 0;
  const char* digits = trace_hash.data() + trace_hash.find(':') + 1;
  std::from_chars(digits, trace_hash.data() + trace_hash.size(), hash, 16);
  sum += hash;
  ::testing::Test::RecordProperty("robosim_traces", fmt::format("{:016x}", sum));
}

void record_kept(const std::string& folder) {
  static const ::testing::TestInfo* test = nullptr;
  static std::string folders;
  const ::testing::TestInfo* now = ::testing::UnitTest::GetInstance()->current_test_info();
  if (!now) return;
  folders = now == test ? folders + "; " + folder : folder;
  test = now;
  ::testing::Test::RecordProperty("robosim_kept", folders);
}

}  // namespace robosim::testing
