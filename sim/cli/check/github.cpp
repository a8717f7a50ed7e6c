#include "sim/cli/check/github.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace robosim::cli {
namespace fs = std::filesystem;

namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// Escapes data for GitHub's workflow commands. Also escapes each character of `special`, such as the colon
/// and the comma in a property.
std::string workflow_text(const std::string& text, const char* special) {
  std::string data;
  for (const char c : text) {
    const bool plain = std::string_view("%\r\n").find(c) == std::string_view::npos &&
                       std::string_view(special).find(c) == std::string_view::npos;
    data += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return data;
}

/// Returns the file's path in the repository, which GitHub needs.
std::string in_the_repository(const std::string& file) {
  const std::string workspace = environment("GITHUB_WORKSPACE");
  if (workspace.empty()) return file;
  std::error_code error;
  const fs::path path =
      fs::weakly_canonical(file, error).lexically_relative(fs::weakly_canonical(workspace, error));
  return path.empty() || *path.begin() == ".." ? file : path.string();
}

std::string note(const Place& place, const std::string& title, const std::string& text) {
  std::string properties;
  if (!place.file.empty()) properties += "file=" + workflow_text(in_the_repository(place.file), ":,") + ",";
  if (place.line > 0) properties += fmt::format("line={},", place.line);
  return fmt::format("::error {}title={}::{}\n", properties, workflow_text(title, ":,"),
                     workflow_text(text, ""));
}

/// Escapes text for a cell of a table.
std::string cell(const std::string& text) {
  std::string plain;
  for (const char c : text) {
    if (c == '\n') {
      plain += ' ';
    } else {
      if (std::string_view("|\\`*_<>[]").find(c) != std::string_view::npos) plain += '\\';
      plain += c;
    }
  }
  return plain;
}

}  // namespace

bool on_github() { return environment("GITHUB_ACTIONS") == "true"; }

std::string github_notes(const std::vector<campaign::SketchResult>& sketches) {
  std::string text;
  for (const campaign::SketchResult& sketch : sketches) {
    if (sketch.problem) text += note(sketch.problem->place, sketch.name, sketch.problem->text);
    for (const campaign::CheckResult& result : sketch.results) {
      if (result.ok() || sketch.problem) continue;
      text += note(result.place, sketch.name + ": " + result.name,
                   result.replay.empty() ? result.why : result.why + "\n" + result.replay);
    }
  }
  return text;
}

std::string github_summary(const std::vector<campaign::SketchResult>& sketches) {
  std::string text = "| sketch | check | where | result | why |\n|---|---|---|---|---|\n";
  for (const campaign::SketchResult& sketch : sketches) {
    if (sketch.problem) {
      text += fmt::format("| {} | | | ❌ error | {} |\n", cell(sketch.name), cell(sketch.problem->line));
      continue;
    }
    for (const campaign::CheckResult& result : sketch.results) {
      text += fmt::format("| {} | {} | {} | {} | {} |\n", cell(sketch.name), cell(result.name),
                          cell(result.where), result.ok() ? "✅ passed" : "❌ failed", cell(result.why));
    }
  }
  return text + "\n";
}

void add_github_summary(const std::vector<campaign::SketchResult>& sketches) {
  const std::string file = environment("GITHUB_STEP_SUMMARY");
  if (file.empty()) return;
  std::ofstream out(file, std::ios::binary | std::ios::app);
  out << github_summary(sketches) << std::flush;
  if (!out) throw InputError({file, 0, 0}, "GITHUB_STEP_SUMMARY: the summary cannot be written to this file");
}

}  // namespace robosim::cli
