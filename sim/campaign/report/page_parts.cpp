#include "sim/campaign/report/page_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "sim/base/markup.h"
#include "sim/record/record_svg.h"

namespace robosim::campaign {
namespace {

constexpr int kBins = 24;

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --text: #1c1f23; --dim: #5d646d; --edge: #d9d7d0; --page: #f3f2ee; --panel: #fff; --good: #00694c; --bad: #a83f00; --bar: #0072b2; }
@media (prefers-color-scheme: dark) { :root { --text: #e8e6e1; --dim: #9da5af; --edge: #343a42; --page: #15181c; --panel: #1e2227; --good: #4fd1a5; --bad: #ff9a5c; --bar: #56b4e9; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 82rem; padding: 1rem; background: var(--page); color: var(--text); font: 15px/1.45 system-ui, sans-serif; }
h1 { font-size: 1.4rem; margin: .2rem 0; } h2 { font-size: 1.1rem; margin: 1.6rem 0 .5rem; }
p { margin: .3rem 0; } .dim { color: var(--dim); }
.wide { overflow-x: auto; background: var(--panel); border: 1px solid var(--edge); border-radius: 8px; }
.wide:focus-visible { outline: 2px solid var(--bar); outline-offset: 1px; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { padding: .35rem .5rem; text-align: right; border-bottom: 1px solid var(--edge); white-space: nowrap; }
th { font-weight: 600; font-size: .85rem; vertical-align: bottom; white-space: normal; } tr:last-child td { border-bottom: 0; }
th.left, td.left { text-align: left; } td.why { white-space: pre-line; text-align: left; min-width: 16rem; overflow-wrap: anywhere; }
.good { color: var(--good); } .bad { color: var(--bad); font-weight: 600; }
.share { display: inline-block; width: 4rem; height: .6rem; margin-right: .5rem; border-radius: 3px; background: var(--bad); overflow: hidden; vertical-align: 0; }
.share i { display: block; height: 100%; background: var(--good); }
svg.bars { width: 7rem; height: 1.8rem; display: block; margin-left: auto; }
figure.times svg.bars { width: 100%; height: 5rem; margin: 0; } svg.bars rect { fill: var(--bar); }
.maps { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 24rem), 1fr)); gap: 1rem; }
figure { margin: 0; padding: .6rem; background: var(--panel); border: 1px solid var(--edge); border-radius: 8px; }
figure svg { width: 100%; height: auto; max-height: 28rem; display: block; } figcaption { margin-top: .4rem; font-size: .9rem; }
a { color: var(--bar); } td.bad { white-space: normal; } td.bad a { color: inherit; }
@media (max-width: 60rem) {
  table:not(.list) th:first-child, table:not(.list) td:first-child { position: sticky; left: 0; max-width: 8rem; overflow: hidden; text-overflow: ellipsis; background: var(--panel); border-right: 1px solid var(--edge); }
}
@media (max-width: 40rem) {
  table.list tr:first-child { display: none; } table.list tr { display: block; padding: .4rem .6rem; border-bottom: 1px solid var(--edge); }
  table.list td { display: inline; padding: 0 .4rem 0 0; border: 0; } table.list td.why { display: block; padding: .2rem 0 0; }
}
)";

std::string heat_map(const LeftOn& left) {
  const record::FloorShapes& floor = left.floor;
  std::string text = fmt::format(
      "<figure><svg viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" aria-label=\"where robots left the line on "
      "{2}\">"
      "<defs><radialGradient id=\"heat\"><stop offset=\"0\" stop-color=\"#d55e00\" stop-opacity=\".75\"/>"
      "<stop offset=\"1\" stop-color=\"#d55e00\" stop-opacity=\"0\"/></radialGradient></defs>{3}",
      floor.width_mm, floor.height_mm, markup_text(left.map), record::floor_elements(floor));
  const double radius = std::max(floor.width_mm, floor.height_mm) / 28.0;
  // Draws many places with lower opacity, because they overlap.
  text += fmt::format("<g fill-opacity=\"{:.2f}\">",
                      std::clamp(20.0 / static_cast<double>(left.places_mm.size() + 1), 0.08, 1.0));
  for (const auto& [x, y] : left.places_mm)
    fmt::format_to(std::back_inserter(text),
                   R"x(<circle cx="{:.0f}" cy="{:.0f}" r="{:.0f}" fill="url(#heat)"/>)x", x,
                   floor.height_mm - y, radius);
  return text + fmt::format("</g></svg><figcaption><b>{}</b>: {} in {}</figcaption></figure>\n",
                            markup_text(left.map),
                            left.places_mm.size() == 1
                                ? "the line was left once"
                                : fmt::format("the line was left {} times", left.places_mm.size()),
                            left.runs == 1 ? "one run" : fmt::format("{} runs", left.runs));
}

}  // namespace

std::string page_of(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "img-src data:\">\n<link rel=\"icon\" href=\"data:,\">\n<title>{}</title>\n<style>{}</style>\n</head>\n"
      "<body>\n{}</body>\n</html>\n",
      markup_text(title), kStyle, body);
}

std::string rows_shown(std::size_t count, std::size_t most) {
  return count > most ? fmt::format(", the first {} of {}", most, count) : "";
}

std::string share_bar(std::size_t good, std::size_t all) {
  return fmt::format(R"(<span class="share"><i style="width:{:.1f}%"></i></span>{}/{})",
                     100.0 * static_cast<double>(good) / static_cast<double>(std::max<std::size_t>(all, 1)),
                     good, all);
}

std::string bars(const std::vector<double>& values, double most, const std::string& unit) {
  std::vector<int> counts(kBins, 0);
  for (const double value : values)
    ++counts[static_cast<std::size_t>(std::clamp(value / most * kBins, 0.0, kBins - 1.0))];
  const int highest = std::max(1, *std::max_element(counts.begin(), counts.end()));
  std::string text = fmt::format(
      R"(<svg class="bars" viewBox="0 0 {} 20" preserveAspectRatio="none" role="img"><title>{} values from 0 to {:.2f} {}</title>)",
      kBins, values.size(), most, unit);
  for (int i = 0; i < kBins; ++i)
    if (const double h = 20.0 * counts[static_cast<std::size_t>(i)] / highest; h > 0.0)
      fmt::format_to(std::back_inserter(text), R"(<rect x="{}" y="{:.2f}" width="0.9" height="{:.2f}"/>)", i,
                     20.0 - h, h);
  return text + "</svg>";
}

double most_of(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

std::string linked(const ReportExtras& extras, std::size_t run, const std::string& markup) {
  const auto replay = extras.replays.find(run);
  return replay == extras.replays.end()
             ? markup
             : fmt::format("<a href=\"{}\">{}</a>", markup_text(replay->second), markup);
}

std::vector<std::string> remarks_on(const ReportExtras& extras) {
  std::vector<std::string> remarks;
  if (extras.other > 0)
    remarks.push_back(
        fmt::format("{} of the runs had another result when they were repeated, and are not shown. Pass "
                    "the sweep's options to “robosim report”, unless the sketch, map or robot has changed "
                    "since.",
                    extras.other));
  if (extras.cannot_be > 0)
    remarks.push_back(fmt::format(
        "{} could not be repeated: {}",
        extras.cannot_be == 1 ? "One run" : fmt::format("{} runs", extras.cannot_be), extras.cannot));
  return remarks;
}

std::string places_left(const ReportExtras& extras) {
  std::string maps, text;
  std::size_t nowhere = 0;  // runs in which the line was never left
  for (const LeftOn& left : extras.left) {
    if (left.places_mm.empty())
      nowhere += left.runs;
    else
      maps += heat_map(left);
  }
  if (maps.empty() && nowhere > 0)
    text += fmt::format("<p class=\"dim\">{} never left the line.</p>\n",
                        nowhere == 1 ? "The repeated run" : fmt::format("The {} repeated runs", nowhere));
  if (!maps.empty())
    text += "<h2>Where robots left the line</h2>\n<div class=\"maps\">\n" + maps + "</div>\n";
  for (const std::string& remark : remarks_on(extras))
    text += fmt::format("<p class=\"bad\">{}</p>\n", markup_text(remark));
  if (extras.not_made > 0)
    text +=
        fmt::format("<p class=\"dim\">{} more runs failed and were not repeated (--runs repeats more).</p>\n",
                    extras.not_made);
  return text;
}

}  // namespace robosim::campaign
