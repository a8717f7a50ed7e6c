#include "tests/unit/structure/prose_ratchet.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "sim/base/error.h"
#include "tests/unit/structure/prose_rules.h"

namespace robosim::structure {
namespace {

constexpr const char* kHead =
    "# Findings of prose_test by rule and area: no number may rise. If one has fallen, write this file "
    "again:\n"
    "# ROBOSIM_WRITE_RATCHET=1 structure_test --gtest_filter='Prose.*'\n";

void add(Findings& findings, const std::string& rule, const std::string& area,
         const std::vector<std::string>& messages) {
  if (messages.empty()) return;
  std::vector<std::string>& all = findings[{rule, area}];
  all.insert(all.end(), messages.begin(), messages.end());
}

void check_passages(const std::vector<Passage>& passages, Findings& findings) {
  for (const Passage& passage : passages) {
    const std::string area = area_of(passage.file);
    const std::string prefix = passage.kind == Passage::Kind::message ? "message-" : "";
    add(findings, prefix + "words", area, odd_words(passage));
    add(findings, prefix + "sentences", area, long_sentences(passage));
    add(findings, "message-forms", area, odd_messages(passage));
    add(findings, "openings", area, bare_openings(passage));
  }
}

}  // namespace

std::string area_of(const std::string& path) {
  const std::size_t first = path.find('/');
  if (first == path.npos) return path;
  const std::size_t second = path.find('/', first + 1);
  return path.substr(0, second == path.npos ? first : second);
}

void check_documents(const Files& documents, Findings& findings) {
  for (const auto& [file, content] : documents) {
    check_passages(passages_of_document(file, content), findings);
    add(findings, "lines", area_of(file), long_lines(file, content));
  }
}

void check_sources(const Files& sources, Findings& findings) {
  for (const auto& [file, content] : sources)
    check_passages(passages_of_source(file, content, !file.starts_with("tests/")), findings);
}

void check_scripts(const Files& scripts, Findings& findings) {
  for (const auto& [file, content] : scripts) check_passages(passages_of_script(file, content), findings);
}

void check_names(const Files& files, Findings& findings) {
  for (const auto& [file, content] : files) add(findings, "names", area_of(file), odd_name(file));
}

void check_subjects(const std::vector<std::string>& subjects, Findings& findings) {
  for (const std::string& subject : subjects) add(findings, "commits", "subjects", odd_subject(subject));
}

Ratchet read_ratchet(const std::string& file, std::string_view text) {
  static const std::set<std::string> rules = {
      "words",   "sentences",     "openings",          "lines",        "names",
      "commits", "message-words", "message-sentences", "message-forms"};
  Ratchet ratchet;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    std::string rule, area, rest;
    std::size_t most = 0;
    if (!(words >> rule >> area >> most) || words >> rest || rules.count(rule) == 0)
      throw InputError({file, number}, "expected a rule, an area and a number");
    ratchet[{rule, area}] = most;
  }
  return ratchet;
}

std::string ratchet_text(const Findings& findings) {
  std::string text = kHead;
  for (const auto& [key, messages] : findings)
    text += fmt::format("{:<18} {:<24} {:>4}\n", key.first, key.second, messages.size());
  return text;
}

Comparison compare(const Findings& findings, const Ratchet& ratchet) {
  Comparison result;
  for (const auto& [key, messages] : findings) {
    const auto row = ratchet.find(key);
    const std::size_t most = row == ratchet.end() ? 0 : row->second;
    if (messages.size() > most)
      result.risen.push_back(
          fmt::format("{} in {}: expected at most {} findings, got {}; one of these is new:\n  {}", key.first,
                      key.second, most, messages.size(), fmt::join(messages, "\n  ")));
  }
  for (const auto& [key, most] : ratchet) {
    const auto found = findings.find(key);
    const std::size_t now = found == findings.end() ? 0 : found->second.size();
    if (now < most)
      result.fallen.push_back(fmt::format("{} in {}: {} findings are left of {}: lower the number", key.first,
                                          key.second, now, most));
  }
  return result;
}

}  // namespace robosim::structure
