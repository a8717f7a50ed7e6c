#include "tests/museum/random_bugs.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "sim/base/file.h"
#include "sim/build/parse_context.h"
#include "sim/campaign/mutate/operators.h"

namespace robosim::museum {
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> files_of_library() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(data_folder() / "firmware/src"))
    if (entry.is_regular_file()) files.push_back(fs::canonical(entry.path()));
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> sketches() {
  std::vector<fs::path> found;
  for (const char* folder : {"firmware/examples", "tests/firmware/sketches"})
    for (const auto& entry : fs::directory_iterator(data_folder() / folder))
      if (entry.is_directory()) found.push_back(fs::canonical(entry.path()));
  std::sort(found.begin(), found.end());
  return found;
}

auto place(const mutate::Mutation& bug) {
  const mutate::Edit& edit = bug.edits.front();
  return std::tie(edit.file, edit.from, edit.to, bug.kind, bug.now);
}

}  // namespace

std::vector<mutate::Mutation> bugs_of_firmware() {
  const fs::path root = fs::canonical(data_folder());
  std::vector<mutate::Mutation> all;
  for (const fs::path& sketch : sketches()) {
    const build::Request request{sketch, *find_board("uno")};
    for (mutate::Mutation& bug :
         mutate::mutations(mutate::parse(parse_context_of(request), files_of_library()))) {
      for (mutate::Edit& edit : bug.edits) edit.file = (sketch / edit.file).lexically_relative(root).string();
      if (bug.edits.front().file.starts_with("firmware/")) all.push_back(std::move(bug));
    }
  }
  const auto before = [](const auto& a, const auto& b) { return place(a) < place(b); };
  const auto same = [](const auto& a, const auto& b) { return place(a) == place(b); };
  std::sort(all.begin(), all.end(), before);
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

const char* word(Attempt::Ending ending) {
  switch (ending) {
    case Attempt::Ending::found:
      return "found";
    case Attempt::Ending::late:
      return "late";
    case Attempt::Ending::survived:
      return "survived";
    case Attempt::Ending::unobserved:
      return "unobserved";
    case Attempt::Ending::not_compiled:
      return "not compiled";
  }
  return "";
}

Attempt attempt(Stage& stage, const LibraryTests& library, const mutate::Mutation& bug,
                const std::vector<std::string>& targets, const TestRun& unchanged) {
  Attempt result{bug, Attempt::Ending::unobserved, "", ""};
  stage.restore();
  stage.spoil(bug.edits);
  try {
    for (const std::string& target : targets) {
      const TestRun run = stage.test({target, {}});
      if (!run.failed.empty()) {
        result.ending = Attempt::Ending::found;
        result.by = target + ": " + run.failed;
        return result;
      }
      if (target == "host" && run.traces != unchanged.traces) result.ending = Attempt::Ending::survived;
    }
    result.library = library.failure(stage, bug.edits.front().file);
  } catch (const mutate::CouldNotRun&) {
    result.ending = Attempt::Ending::not_compiled;
  } catch (const mutate::ProgramBroke& broken) {
    result.ending = Attempt::Ending::late;
    result.by = broken.what();
  }
  return result;
}

std::string summary_of(const std::vector<Attempt>& attempts, std::uint64_t seed, std::size_t places,
                       const std::string& targets) {
  using enum Attempt::Ending;
  const auto count = [&](Attempt::Ending ending) {
    return std::count_if(attempts.begin(), attempts.end(),
                         [&](const Attempt& one) { return one.ending == ending; });
  };
  const auto by_library = [&](Attempt::Ending ending) {
    return std::count_if(attempts.begin(), attempts.end(),
                         [&](const Attempt& one) { return one.ending == ending && !one.library.empty(); });
  };
  const auto percent = [](auto part, auto whole) {
    return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0;
  };
  const auto killed = count(found) + count(late), all = killed + count(survived);
  const auto more = by_library(survived), unseen = by_library(unobserved);
  std::string text = fmt::format(
      "Of {} bugs that compile, drawn by seed {} from {} in `firmware/`, {} changed no run of a sketch. Of "
      "the "
      "other {} the sketches' tests found {} ({:.0f} %) on {}, {} of them since their time was up, and the "
      "library's unit tests {} more: {} ({:.0f} %). Of those that changed no run the unit tests found {}; "
      "with them it is {} of {} ({:.0f} %).\n",
      all + count(unobserved), seed, places, count(unobserved), all, killed, percent(killed, all), targets,
      count(late), more, killed + more, percent(killed + more, all), unseen, killed + more + unseen,
      all + unseen, percent(killed + more + unseen, all + unseen));
  const auto list = [&](const char* heading, const auto& belongs) {
    if (std::none_of(attempts.begin(), attempts.end(), belongs)) return;
    text += fmt::format("\n{}\n\n", heading);
    for (const Attempt& one : attempts)
      if (belongs(one))
        text += fmt::format("- {}{}\n", mutate::described(one.bug),
                            one.library.empty() ? "" : ": " + one.library);
  };
  list("Bugs that change a run, but that no test finds:",
       [](const Attempt& one) { return one.ending == survived && one.library.empty(); });
  list("Bugs that only the unit tests find:", [](const Attempt& one) { return !one.library.empty(); });
  list("Bugs that change no run, and that no test finds:",
       [](const Attempt& one) { return one.ending == unobserved && one.library.empty(); });
  return text;
}

}  // namespace robosim::museum
