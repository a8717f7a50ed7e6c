#include "tests/museum/bug.h"

#include <algorithm>
#include <sstream>
#include <tuple>

#include "sim/base/error.h"
#include "sim/base/file.h"

namespace robosim::museum {
namespace fs = std::filesystem;

namespace {

/// Returns whether the line begins with `word`. If it does, sets `rest` to the text after `word`.
bool take(const std::string& line, const std::string& word, std::string& rest) {
  if (!line.starts_with(word)) return false;
  rest = line.substr(word.size());
  return true;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream words(text);
  std::vector<std::string> found;
  for (std::string word; words >> word;) found.push_back(word);
  return found;
}

Bug read_bug(const fs::path& file) {
  Bug bug;
  bug.name = file.stem().string();
  bug.patch = file;
  std::istringstream lines(read_file(file));
  std::string rest;
  bool in_story = true, in_diff = false;
  for (std::string line; std::getline(lines, line);) {
    in_diff = in_diff || line.starts_with("--- ");
    if (take(line, "+++ b/", rest)) {
      bug.files.push_back(rest.substr(0, rest.find('\t')));
    } else if (in_diff) {
      continue;
    } else if (line.empty()) {
      in_story = false;
    } else if (in_story) {
      bug.story += (bug.story.empty() ? "" : " ") + line;
    } else if (take(line, "Tests: ", rest)) {
      bug.tests = words_of(rest);
    } else if (!take(line, "Kind: ", bug.kind) && !take(line, "Survives: ", bug.survives)) {
      throw InputError({file.string()}, "has the line “" + line +
                                            "” above its diff; allowed are sentences, an "
                                            "empty line, and Kind:, Tests: and Survives:");
    }
  }
  if (bug.story.empty() || bug.kind.empty() || bug.tests.empty() || bug.files.empty())
    throw InputError({file.string()},
                     "must have a sentence, an empty line, “Kind: …”, “Tests: …” and a diff with “+++ b/…”");
  return bug;
}

}  // namespace

bool Bug::in_one_sketch() const {
  return std::none_of(files.begin(), files.end(),
                      [](const std::string& file) { return file.starts_with("firmware/src/"); });
}

std::vector<Bug> read_bugs(const fs::path& folder) {
  std::vector<Bug> bugs;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".patch") bugs.push_back(read_bug(entry.path()));
  std::sort(bugs.begin(), bugs.end(),
            [](const Bug& a, const Bug& b) { return std::tie(a.kind, a.name) < std::tie(b.kind, b.name); });
  return bugs;
}

}  // namespace robosim::museum
