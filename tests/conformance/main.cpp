// robosim_conformance [FILE]: prints a table of the results of each program of tests/conformance/avr. The
// programs run on Robosim's emulated AVR, on the target host and on other emulators (referees.h). With FILE,
// writes the table into that file, between the lines "<!-- table -->" and "<!-- end -->".
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <fstream>

#include "sim/base/file.h"
#include "tests/conformance/host.h"
#include "tests/conformance/referees.h"

namespace robosim::conformance {
namespace {

std::string cell(const Program& program, const std::optional<Report>& report) {
  if (!report) return "";
  if (is_right(program, *report)) return "yes";
  const std::string bytes = text_of(report->bytes);
  return (bytes.empty() ? "nothing" : "`" + bytes.substr(0, 47) + (bytes.size() > 47 ? "…`" : "`")) +
         (report->ended ? "" : ", does not end");
}

/// Returns the program's result on the host, or its reason to fail.
std::string host_cell(const Program& program) {
  if (!is_for(program, kHostChip)) return "";
  const Report report = run_on_host(program);
  return is_right(program, report) || program.host.empty() ? cell(program, report) : program.host;
}

std::string table(int& wrong) {
  std::string text =
      "| program | what must hold | source | expected | Robosim | host | simavr 1.6 | "
      "avr8js |\n|---|---|---|---|---|---|---|---|\n";
  int count = 0, host_count = 0, host_right = 0, simavr_right = 0, avr8js_right = 0;
  for (const Program& program : programs_in(ROBOSIM_CONFORMANCE_PROGRAMS)) {
    const auto flash = compile(program, program.chips.front());
    const Report ours = run_on_ours(program, flash), simavr = run_on_simavr(program, flash);
    const std::optional<Report> avr8js = run_on_avr8js(program, flash);
    const std::string host = host_cell(program);
    ++count;
    host_count += !host.empty();
    host_right += host == "yes";
    wrong += !is_right(program, ours);
    simavr_right += is_right(program, simavr);
    avr8js_right += avr8js && is_right(program, *avr8js);
    text += fmt::format("| `{}` | {} | {} | `{}` | {} | {} | {} | {} |\n", program.name, program.sentence,
                        program.source, text_of(program.expected), cell(program, ours), host,
                        cell(program, simavr), cell(program, avr8js));
  }
  return text + fmt::format("| {} programs | | | | {} | {} of {} | {} | {} |\n", count, count - wrong,
                            host_right, host_count, simavr_right, avr8js_right);
}

int write_table(const std::filesystem::path& file) {
  constexpr const char* kBegin = "<!-- table -->\n";
  constexpr const char* kEnd = "<!-- end -->\n";
  int wrong = 0;
  const std::string made = table(wrong);
  if (file.empty()) {
    fmt::print("{}", made);
  } else {
    std::string page = read_file(file);
    const auto begin = page.find(kBegin), end = page.find(kEnd);
    if (begin == page.npos || end == page.npos)
      throw std::runtime_error(file.string() + " lacks the marks of the table");
    const auto from = begin + std::string(kBegin).size();
    page.replace(from, end - from, made);
    std::ofstream(file) << page;
  }
  return wrong;
}

}  // namespace
}  // namespace robosim::conformance

int main(int argc, char** argv) try {
  return robosim::conformance::write_table(argc > 1 ? argv[1] : "") > 0 ? 1 : 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "robosim_conformance: {}\n", error.what());
  return 1;
}
