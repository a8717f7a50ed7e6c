#include "tests/museum/table.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/error.h"

namespace robosim::museum {

namespace {

constexpr const char* kBegin = "<!-- robosim_museum writes from here -->\n";
constexpr const char* kEnd = "<!-- to here -->\n";

std::string link_to(const Bug& bug) {
  std::string title = bug.name;
  std::replace(title.begin(), title.end(), '_', ' ');
  return fmt::format("[{}](../../tests/museum/bugs/{}.patch)", title, bug.name);
}

}  // namespace

std::string catches_of(const Result& result) {
  std::string text;
  for (std::size_t i = 0; i < result.catches.size(); ++i) {
    const Result::Catch& one = result.catches[i];
    text += one.target;
    const bool same_follows = i + 1 < result.catches.size() && result.catches[i + 1].test == one.test;
    text += same_follows ? ", " : ": " + one.test + (i + 1 < result.catches.size() ? "; " : "");
  }
  return text;
}

std::string table_of(const std::vector<Result>& results, const std::string& targets) {
  const auto count = [&](auto holds) { return std::count_if(results.begin(), results.end(), holds); };
  const auto caught = count([](const Result& one) { return one.caught(); });
  const auto on_host = count([](const Result& one) { return one.on_host(); });
  const auto by_unit_tests = count([](const Result& one) { return one.by_unit_tests(); });
  std::string text =
      fmt::format("{} of {} bugs are caught on {}: {} of them on a chip only, {} by unit tests only.\n\n",
                  caught, results.size(), targets, caught - on_host - by_unit_tests, by_unit_tests);
  text += "| kind | bug | what is wrong | caught by | s |\n|---|---|---|---|---|\n";
  for (const Result& one : results)
    text += fmt::format("| {} | {} | {} | {} | {:.1f} |\n", one.bug->kind, link_to(*one.bug), one.bug->story,
                        one.caught() ? catches_of(one) : "**not caught**", one.seconds);
  if (caught == static_cast<std::ptrdiff_t>(results.size())) return text;
  text += "\n### Not caught\n\n| bug | why no test finds it |\n|---|---|\n";
  for (const Result& one : results)
    if (!one.caught()) text += fmt::format("| {} | {} |\n", link_to(*one.bug), one.bug->survives);
  return text;
}

std::string with_table(const std::string& text, const std::string& table) {
  const std::size_t begin = text.find(kBegin), end = text.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos || end < begin)
    throw InputError(fmt::format("the page lacks the lines “{}” and “{}” around its table",
                                 std::string(kBegin, std::string(kBegin).size() - 1),
                                 std::string(kEnd, std::string(kEnd).size() - 1)));
  const std::size_t inside = begin + std::string(kBegin).size();
  return text.substr(0, inside) + "\n" + table + "\n" + text.substr(end);
}

}  // namespace robosim::museum
