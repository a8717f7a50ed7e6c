#include "sim/view/terminal/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/base/utf8.h"

namespace robosim::terminal {

int width_of(std::string_view utf8) { return static_cast<int>(count_characters(utf8)); }

std::vector<std::string> wrap(std::string_view text, int columns) {
  std::vector<std::string> lines;
  std::string line;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
    const std::string_view word = text.substr(at, end - at);
    at = end + 1;
    if (word.empty()) continue;
    if (!line.empty() && width_of(line) + 1 + width_of(word) > columns) {
      lines.push_back(std::move(line));
      line.clear();
    }
    if (!line.empty()) line += ' ';
    line += word;
  }
  if (!line.empty()) lines.push_back(std::move(line));
  return lines;
}

std::vector<std::string> last_lines(std::string_view text, std::size_t count) {
  if (!text.empty() && text.back() == '\n') text.remove_suffix(1);
  std::vector<std::string> lines;
  while (!text.empty() && lines.size() < count) {
    const std::size_t feed = text.rfind('\n');
    std::string line(feed == std::string_view::npos ? text : text.substr(feed + 1));
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(std::move(line));
    text = feed == std::string_view::npos ? std::string_view() : text.substr(0, feed);
  }
  std::reverse(lines.begin(), lines.end());
  return lines;
}

std::u32string bar(double share, int columns, bool utf8) {
  constexpr char32_t kEighths[] = U" ▏▎▍▌▋▊▉█";
  const long eighths = std::lround(std::clamp(share, 0.0, 1.0) * columns * 8.0);
  std::u32string text;
  for (int i = 0; i < columns; ++i) {
    const long here = std::clamp(eighths - i * 8L, 0L, 8L);
    text += utf8 ? kEighths[here] : here >= 4 ? U'#' : U' ';
  }
  return text;
}

std::string time_text(double seconds) {
  if (seconds < 60.0) return fmt::format("{:.2f} s", seconds);
  // Rounds first, so that 119.96 s does not become "1 min 60.0 s".
  const auto tenths = static_cast<long long>(std::llround(seconds * 10.0));
  return fmt::format("{} min {}.{} s", tenths / 600, tenths % 600 / 10, tenths % 10);
}

}  // namespace robosim::terminal
