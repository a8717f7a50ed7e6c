#include "tests/unit/structure/prose_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <unordered_map>

namespace robosim::structure {
namespace {

/// A phrase, and its replacement. A phrase is a list of elements, which match words or punctuation marks:
/// `a|b` matches `a` or `b`; `!a|b` matches anything else; `^` matches the beginning of the sentence; `$`
/// matches the end of the sentence or a punctuation mark.
struct Phrase {
  const char* phrase;
  const char* instead;
};

// Contains only phrases that are never good English here. If a phrase also matches good English, narrow or
// remove it.
constexpr Phrase kWords[] = {
    {"anew", "again"},
    {"nobody|somebody|whoever", "the caller, the user, no listener: name the actor"},
    {"in vain", "without effect"},
    {"by turns", "alternately"},
    {"now and then", "occasionally"},
    {"so many !that|people|of", "the number of"},
    {"that many $|or|for", "the number of"},
    {"for so long !as|that", "the duration of"},
    {", so long !as|that", "the duration of"},
    {"^ so long !as|that", "the duration of"},
    {"tells|tell|told of", "reports"},
    {"is|are|was|were|be told !to", "reports, notifies, prints, returns"},
    {"!there is|are none $", "is not, is missing"},
    {"!there|longer is|are no "
     "!longer|more|less|better|worse|higher|lower|larger|smaller|greater|faster|slower|shorter|later|nearer|"
     "doubt|use|need|problem|matter|good|different",
     "is not"},
    {"of ours", "a specific noun"},
    {"takes|take|took|taken apart", "decodes"},
    {"makes|make a code of", "converts to a code"},
    {"plain world|worlds", "baseline run"},
    {"deed|deeds", "stimulus"},
    {"mended|mends", "fixed"},
    {"but for", "except"},
    {"^ told|asked|counted|kept|meant|said is|are", "subject, verb, object"},
    {"one who|that asks", "the caller"},
    {", for then", "because, since"},
    {", for there|they|it|this is|are|has|have|does", "because, since"},
    {"ms|us|ns|milliseconds|seconds|ticks|cycles|instructions behind it|its|that|the|this|them|power-on",
     "after"},
    {"behind a|an|the|each|every|its|that|this|any "
     "reset|change|sleep|wait|delay|call|read|write|instruction|step|"
     "tick|event|run|loop|test|return|update|interrupt",
     "after"},
    {"behind word|power-on|setup|loop|begin|that ,|$", "after"},
};

constexpr Phrase kMessages[] = {
    {"wants|want a|an|the|its|one|two|no", "requires"},
    {"is|are of a|an|the maze|picture|map|robot|sketch|board|chip", "requires"},
    {"but got|found", "\", got …\""},
};

// Words that file names must not contain.
const std::set<std::string> kBareNames = {
    "instead", "late",    "whole", "counted", "apart", "anew",     "glance", "deed",
    "deeds",   "shelf",   "told",  "kept",    "lacks", "inside",   "ours",   "rest",
    "looks",   "ways",    "twin",  "plain",   "again", "standing", "spent",  "drawn",
    "wanted",  "resting", "bites", "outside", "shown", "patience", "die",    "surroundings"};

std::vector<std::string> split(const std::string& text, char mark) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == mark)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

struct Element {
  bool negated = false;
  std::vector<std::string> words;

  bool matches(const std::vector<Token>& sentence, std::ptrdiff_t at) const {
    const bool inside = at >= 0 && at < static_cast<std::ptrdiff_t>(sentence.size());
    if (words.front() == "^") return at == -1;
    const bool found = std::any_of(words.begin(), words.end(), [&](const std::string& word) {
      if (word == "$") return !inside || !sentence[static_cast<std::size_t>(at)].is_word;
      return inside && sentence[static_cast<std::size_t>(at)].text == word;
    });
    return found != negated;
  }
  bool is_anchor() const { return !negated && words.front() != "^" && words.front() != "$"; }
};

/// A list of phrases with an index by word. The keys of a phrase are the words of its anchor. The anchor is
/// its first element other than `!a|b`, `^` and `$`.
class PhraseList {
 public:
  template <std::size_t kCount>
  explicit PhraseList(const Phrase (&phrases)[kCount]) {
    for (const Phrase& phrase : phrases) {
      Compiled compiled{{}, 0, phrase.instead};
      for (const std::string& element : split(phrase.phrase, ' ')) {
        const bool negated = element.front() == '!';
        compiled.elements.push_back({negated, split(element.substr(negated ? 1 : 0), '|')});
      }
      while (!compiled.elements[compiled.anchor].is_anchor()) ++compiled.anchor;
      for (const std::string& word : compiled.elements[compiled.anchor].words)
        by_word_[word].push_back(compiled);
    }
  }

  std::vector<std::string> hits(const Passage& passage) const {
    std::vector<std::string> found;
    for (const std::vector<Token>& sentence : sentences(passage.text)) {
      std::ptrdiff_t reported = 0;  // the previous finding ends before this token
      for (std::size_t i = 0; i < sentence.size(); ++i) {
        const auto list = by_word_.find(sentence[i].text);
        if (list == by_word_.end()) continue;
        for (const Compiled& phrase : list->second) {
          const auto first = static_cast<std::ptrdiff_t>(i) - static_cast<std::ptrdiff_t>(phrase.anchor);
          std::string words;
          std::ptrdiff_t last = first;  // the last token of the phrase
          bool matches = true;
          for (std::size_t k = 0; matches && k < phrase.elements.size(); ++k) {
            const std::ptrdiff_t at = first + static_cast<std::ptrdiff_t>(k);
            matches = phrase.elements[k].matches(sentence, at);
            if (phrase.elements[k].negated || at < 0 || at >= static_cast<std::ptrdiff_t>(sentence.size()))
              continue;
            words += (words.empty() ? "" : " ") + sentence[static_cast<std::size_t>(at)].text;
            last = at;
          }
          if (!matches || static_cast<std::ptrdiff_t>(i) < reported) continue;
          reported = last + 1;
          found.push_back(
              fmt::format("{}: '{}': write {}", passage.place(sentence[i].at), words, phrase.instead));
        }
      }
    }
    return found;
  }

 private:
  struct Compiled {
    std::vector<Element> elements;
    std::size_t anchor;
    std::string instead;
  };
  std::unordered_map<std::string, std::vector<Compiled>> by_word_;
};

std::size_t count_characters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

bool ends_with(const std::string& text, std::string_view end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

std::vector<std::string> odd_words(const Passage& passage) {
  static const PhraseList list(kWords);
  return list.hits(passage);
}

std::vector<std::string> odd_messages(const Passage& passage) {
  static const PhraseList list(kMessages);
  if (passage.kind != Passage::Kind::message) return {};
  return list.hits(passage);
}

std::vector<std::string> long_sentences(const Passage& passage) {
  std::vector<std::string> found;
  if (passage.kind == Passage::Kind::row || passage.kind == Passage::Kind::cell) return found;
  for (const std::vector<Token>& sentence : sentences(passage.text)) {
    std::size_t words = 0, first = 0, depth = 0;  // depth of parentheses
    const auto end_part = [&](std::size_t next) {
      if (words > kLongestSentence)
        found.push_back(fmt::format("{}: a sentence has {} words: expected at most {}",
                                    passage.place(sentence[first].at), words, kLongestSentence));
      words = 0;
      first = next;
    };
    for (std::size_t i = 0; i < sentence.size(); ++i) {
      const Token& token = sentence[i];
      const bool is_break = depth == 0 && (token.text == ":" || token.text == ";");
      if (token.text == "(") ++depth;
      if (token.text == ")" && depth > 0) --depth;
      if (depth == 0 && token.is_word && std::isdigit(static_cast<unsigned char>(token.text.front())) == 0)
        ++words;
      if (is_break || i + 1 == sentence.size()) end_part(i + 1);
    }
  }
  return found;
}

std::vector<std::string> bare_openings(const Passage& passage) {
  if (passage.kind != Passage::Kind::comment || !passage.opens) return {};
  const std::vector<std::vector<Token>> all = sentences(passage.text);
  if (all.empty() || all.front().size() < 2 || all.front().back().text == "?") return {};
  static const PhraseList list(
      {Phrase{"^ whether|likewise|what|who|whom|whose", "a verb and its object"},
       Phrase{"^ how many|much|long|often|far", "Returns the number of …, or another verb and its object"},
       Phrase{"^ the same $|for|as|with|from|of|in|by|but|once|again|at|on|is|are|here|there",
              "what it does"},
       Phrase{"^ one|two more $", "what it does"},
       Phrase{"^ of a|an|the|it|its|one|that|this", "a verb and its object"}});
  Passage opening = passage;
  opening.text.resize(std::min(opening.text.size(), all.front().back().at + 1));
  return list.hits(opening);
}

std::vector<std::string> long_lines(const std::string& file, std::string_view markdown) {
  std::vector<std::string> found;
  bool in_code = false;
  for (int number = 1; !markdown.empty(); ++number) {
    const std::size_t end = std::min(markdown.find('\n'), markdown.size());
    const std::string_view line = markdown.substr(0, end);
    markdown.remove_prefix(std::min(end + 1, markdown.size()));
    if (line.substr(0, 3) == "```") in_code = !in_code;
    const std::size_t text = line.find_first_not_of(" -*>");
    if (in_code || text == line.npos || line[text] == '|' || line[text] == '#' || line[text] == '<') continue;
    const std::size_t columns = count_characters(line);
    if (columns > kLongestLine && line.find(' ', text) != line.npos)
      found.push_back(fmt::format("{}:{}: a line has {} characters: expected at most {}", file, number,
                                  columns, kLongestLine));
  }
  return found;
}

std::vector<std::string> odd_name(const std::string& path) {
  const std::filesystem::path file(path);
  const std::string stem = file.stem().string();
  if (file.extension() != ".h" && file.extension() != ".cpp") return {};
  if (kBareNames.count(stem) == 0) return {};
  return {fmt::format("{}: '{}' does not describe its content: expected the field's term, or two words", path,
                      stem)};
}

std::vector<std::string> odd_subject(const std::string& subject) {
  std::vector<std::string> found;
  const auto report = [&](const std::string& what) {
    found.push_back(fmt::format("'{}': {}", subject, what));
  };
  if (count_characters(subject) > kLongestSubject)
    report(fmt::format("{} characters: expected at most {}", count_characters(subject), kLongestSubject));
  const std::size_t colon = subject.find(": ");
  const std::string area = subject.substr(0, std::min(colon, subject.size()));
  const bool is_area = colon != subject.npos && !area.empty() &&
                       area.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_-/., *") == area.npos;
  if (!is_area) {
    report("expected \"area: Imperative summary\"");
    return found;
  }
  const std::string summary = subject.substr(colon + 2);
  std::string verb = summary.substr(0, summary.find_first_of(" ,"));
  if (verb.empty() || std::isupper(static_cast<unsigned char>(verb.front())) == 0)
    report("expected a capital letter after the area");
  static const std::set<std::string> imperatives = {"Embed", "Feed",  "Need",   "Seed", "Speed",   "Shed",
                                                    "Bring", "Focus", "Exceed", "Ring", "Proceed", "Spring"};
  const bool is_other_form =
      (ends_with(verb, "s") && !ends_with(verb, "ss")) || ends_with(verb, "ed") || ends_with(verb, "ing");
  if (is_other_form && imperatives.count(verb) == 0)
    report(fmt::format("expected an imperative, got '{}'", verb));
  if (ends_with(summary, ".")) report("expected no full stop at the end");
  return found;
}

}  // namespace robosim::structure
