#include "sim/campaign/wiring/pin_remarks.h"

#include <algorithm>
#include <set>

namespace robosim::wiring {
namespace {

constexpr std::size_t kLongestTitle = 5;
const WordList kNone;

// The comments of one file.
class Remarks {
 public:
  explicit Remarks(const SourceText& source) : source_(source) {
    std::set<Side> sides;
    for (const Comment& comment : source.comments) {
      const WordList& words = comment.words;
      if (!comment.is_alone || words.size() > kLongestTitle) continue;
      sides.insert(only_side(words));
    }
    has_titles_ = sides.count(Side::left) != 0 && sides.count(Side::right) != 0;
  }

  // Returns the words of the comment after the code of this line.
  const WordList& beside(int line) const {
    for (const Comment& comment : source_.comments)
      if (comment.line == line && !comment.is_alone) return comment.words;
    return kNone;
  }

  // Returns the words of the nearest comment above the line, if it names one side.
  const WordList& title(int line) const {
    const WordList* words = &kNone;
    if (!has_titles_) return kNone;
    for (const Comment& comment : source_.comments) {
      if (comment.line >= line) break;
      if (comment.is_alone) words = &comment.words;
    }
    return words->size() <= kLongestTitle && only_side(*words) != Side::unknown ? *words : kNone;
  }

 private:
  const SourceText& source_;
  bool has_titles_ = false;
};

}  // namespace

std::map<Pin, WordList> remarks_of(const SketchNames& names, const std::vector<SourceText>& sources) {
  std::map<Pin, WordList> result;
  for (const bool is_title : {false, true}) {
    for (const SourceText& source : sources) {
      const Remarks remarks(source);
      std::map<int, std::set<Pin>> pins;  // by the line of a declaration, or of a pinMode()
      for (const Named& named : names.named)
        if (named.spot.file == source.file)
          pins[named.spot.line].insert(named.pins.begin(), named.pins.end());
      for (const Given& given : names.given) {
        const bool is_mode = given.type == "OUTPUT" || given.type == "pinMode";
        if (is_mode && !is_title && given.spot.file == source.file)
          pins[given.spot.line].insert(given.pins.begin(), given.pins.end());
      }
      for (const auto& [line, on_line] : pins) {
        if (on_line.size() != 1 || *on_line.begin() == kNoPin || result.count(*on_line.begin()) != 0)
          continue;
        const WordList& words = is_title ? remarks.title(line) : remarks.beside(line);
        if (!words.empty()) result.emplace(*on_line.begin(), words);
      }
    }
  }
  return result;
}

}  // namespace robosim::wiring
