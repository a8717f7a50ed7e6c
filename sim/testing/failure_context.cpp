#include "sim/testing/failure_context.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <utility>
#include <vector>

namespace robosim::testing {
namespace {

std::vector<std::shared_ptr<const RunLog>>& standing_runs() {
  static std::vector<std::shared_ptr<const RunLog>> runs;
  return runs;
}

class StandingListener final : public ::testing::EmptyTestEventListener {
 public:
  void OnTestStart(const ::testing::TestInfo&) override { told_.clear(); }

  void OnTestPartResult(const ::testing::TestPartResult& part) override {
    if (!part.failed()) return;
    const std::string text = state_at_failure(part);
    if (text.empty() || text == told_) return;
    fmt::print("{}\n", text);
    std::fflush(stdout);
    told_ = text;
  }

 private:
  std::string told_;
};

}  // namespace

FailureContext::FailureContext(std::shared_ptr<const RunLog> log) : log_(std::move(log)) {
  static bool listens = false;
  if (!listens) ::testing::UnitTest::GetInstance()->listeners().Append(new StandingListener);
  listens = true;
  standing_runs().push_back(log_);
}

FailureContext::~FailureContext() {
  auto& runs = standing_runs();
  runs.erase(std::remove(runs.begin(), runs.end(), log_), runs.end());
}

std::string state_at_failure(const ::testing::TestPartResult& failure) {
  if (std::string_view(failure.message()).find("\n  replay: ") != std::string_view::npos) return "";
  std::string text;
  for (const auto& log : standing_runs()) {
    const Duration now(log->legs.empty() ? 0 : log->legs.back().end_ns);
    const Drive all(log, Duration(0), now);
    text += (text.empty() ? "  " : "\n  ") + all.title() + all.epilogue(now);
  }
  return text;
}

}  // namespace robosim::testing
