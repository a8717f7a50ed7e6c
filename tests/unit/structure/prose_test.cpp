// Checks the English of documents, comments, messages, file names and commits with the rules of
// prose_rules.h.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdio>
#include <filesystem>
#include <set>
#include <sstream>

#include "sim/base/file.h"
#include "sim/base/shell_word.h"
#include "tests/unit/structure/documents.h"
#include "tests/unit/structure/prose_rules.h"

namespace robosim::structure::prose_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::string kRoot = ROBOSIM_SOURCE_DIR;
/// The last commit to which the rules do not apply.
const std::string kFirstRevision = "883c866f";

/// Reads build files, scripts and TOML files.
Files read_scripts() {
  static const std::set<std::string> extensions = {".cmake", ".sh", ".py", ".toml"};
  Files files;
  const auto add = [&](const fs::path& file) {
    files[file.lexically_relative(kRoot).string()] = read_file(file);
  };
  for (const char* folder : {".ci", "firmware", "hal", "maps", "sim", "tests", "toolchain"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(kRoot) / folder)) {
      const fs::path& file = entry.path();
      if (!entry.is_regular_file() || file.string().find("/fuzz/corpus/") != std::string::npos) continue;
      if (extensions.count(file.extension().string()) || file.filename() == "CMakeLists.txt") add(file);
    }
  }
  for (const char* file : {"CMakeLists.txt", "robosim", ".ci/run", ".ci/check_format"})
    add(fs::path(kRoot) / file);
  return files;
}

struct History {
  std::vector<std::string> subjects;
  std::string missing;  ///< the reason if subjects are missing
};

/// Reads the subjects of commits since kFirstRevision.
History read_history() {
  const std::string command = fmt::format("git -C {} log --no-merges --format=%s {}..HEAD 2>/dev/null",
                                          shell_word(kRoot), kFirstRevision);
  History history;
  FILE* const output = popen(command.c_str(), "r");
  std::string text;
  for (int c = 0; output && (c = std::fgetc(output)) != EOF;) text += static_cast<char>(c);
  if (!output || pclose(output) != 0)
    history.missing = "git does not list the commits since " + kFirstRevision + ": expected a complete clone";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) history.subjects.push_back(line);
  return history;
}

void add(std::vector<std::string>& findings, const std::vector<std::string>& more) {
  findings.insert(findings.end(), more.begin(), more.end());
}

void check(const std::vector<Passage>& passages, std::vector<std::string>& findings) {
  for (const Passage& passage : passages)
    for (const auto rule : {odd_words, long_sentences, odd_messages, bare_openings})
      add(findings, rule(passage));
}

TEST(Prose, HasNoFindings) {
  std::vector<std::string> findings;
  for (const auto& [file, content] : read_documents(kRoot)) {
    check(passages_of_document(file, content), findings);
    add(findings, long_lines(file, content));
  }
  for (const auto& [file, content] : read_sources(kRoot)) {
    check(passages_of_source(file, content, !file.starts_with("tests/")), findings);
    add(findings, odd_name(file));
  }
  for (const auto& [file, content] : read_scripts()) check(passages_of_script(file, content), findings);
  for (const std::string& finding : findings) ADD_FAILURE() << finding;
}

TEST(Prose, SubjectsOfCommitsHaveAnAreaAndAnImperative) {
  const History history = read_history();
  if (!history.missing.empty()) GTEST_SKIP() << history.missing;
  for (const std::string& subject : history.subjects)
    for (const std::string& finding : odd_subject(subject)) ADD_FAILURE() << finding;
}

/// Returns the passages as texts: the number of the kind, the line, and the text of the passage.
std::vector<std::string> texts(const std::vector<Passage>& passages) {
  std::vector<std::string> all;
  for (const Passage& passage : passages)
    all.push_back(fmt::format("{} {} {}", static_cast<int>(passage.kind), passage.line, passage.text));
  return all;
}

/// Returns a passage that consists of a paragraph of a document.
Passage paragraph(const std::string& text) { return {"a.md", 1, Passage::Kind::document, true, text}; }

Passage comment(const std::string& text) { return {"a.h", 1, Passage::Kind::comment, true, text}; }

Passage message(const std::string& text) { return {"a.cpp", 1, Passage::Kind::message, true, text}; }

TEST(Passages, OfDocumentsAreParagraphsItemsAndCells) {
  EXPECT_THAT(texts(passages_of_document("a.md",
                                         "# Title\n"
                                         "One [link](x.md#y) and\n`code here`.\n"
                                         "\n"
                                         "- An item\n"
                                         "  goes on.\n"
                                         "- Another.\n"
                                         "```\nnot this\n```\n"
                                         "| a | b c |\n")),
              ElementsAre("1 1  Title", "0 2 One [link and\n_.", "0 5 An item\ngoes on.", "0 7 Another.",
                          "1 11 a", "1 11 b c"));
}

TEST(Passages, HaveNoTagsAndAddresses) {
  EXPECT_THAT(texts(passages_of_document("a.md", "A <b>tag</b>, <th class=\"left\">i < 3 and 4 > 3.\n")),
              ElementsAre("0 1 A  tag ,  i < 3 and 4 > 3."));
  EXPECT_THAT(texts(passages_of_document("a.md", "See (https://a.org/b?c=1). Next\n")),
              ElementsAre("0 1 See (https). Next"));
}

TEST(Passages, OfSourcesAreCommentsRowsRemarksAndLiterals) {
  EXPECT_THAT(texts(passages_of_source(
                  "a.cpp",
                  "// One\n// paragraph.\n//\n//   a row   of a table\n"
                  "int i = 1'000;  // a remark\n"
                  "                // goes on\n"
                  "f(\"three \\\"words\\\" \"\n  \"here\\nand three more\", 'x', \"two words\");\n"
                  "}  // namespace a\n"
                  "int j;  // NOLINT\n"
                  "auto r = R\"(// no comment \" here)\";\n"
                  "/// Last.\n",
                  true)),
              ElementsAre("2 1 One\nparagraph.", "3 4 a row   of a table", "4 5 a remark", "4 6 goes on",
                          "5 7 three \"words\" here", "5 7 and three more", "2 12 Last."));
  EXPECT_THAT(passages_of_source("a.cpp", "f(\"three plain words\");\n", false), IsEmpty());
}

TEST(Passages, OpenAComment) {
  std::vector<bool> opens;
  for (const Passage& passage :
       passages_of_source("a.cpp", "/// A.\n///\n/// B.\nint i;\n/// C.\n\n/// D.\n", false))
    opens.push_back(passage.opens);
  EXPECT_THAT(opens, ElementsAre(true, false, true, true));
}

TEST(Passages, OfScriptsAreComments) {
  EXPECT_THAT(texts(passages_of_script("a.sh", "#!/bin/sh\n# One\n# two.\nx=1\n# Three.\n")),
              ElementsAre("2 2 One\ntwo.", "2 5 Three."));
}

TEST(Sentences, EndAtFullStopsButNotWithinNumbersNamesAndAbbreviations) {
  EXPECT_THAT(sentences("At 0.5 V, e.g. in main.cpp. Is it? \"Yes.\" Last"), SizeIs(4));
  EXPECT_THAT(sentences("Runs (as here). At 5 V. The J. smith rule. It has x. Then"), SizeIs(5));
  EXPECT_THAT(sentences(" \n "), IsEmpty());
  const auto found = sentences("“Robot's” cross-track → x");
  ASSERT_THAT(found, SizeIs(1));
  ASSERT_THAT(found[0], SizeIs(3));
  EXPECT_EQ(found[0][0].text, "robot's");
  EXPECT_EQ(found[0][1].text, "cross-track");
}

TEST(OddWords, AreFoundAcrossLinesWithTheirPlace) {
  EXPECT_THAT(odd_words(comment("Compiles it.\nIt is told\nanew.")),
              ElementsAre("a.h:2: 'is told': write reports, notifies, prints, returns",
                          "a.h:3: 'anew': write again"));
}

TEST(OddWords, OfTheTableAreFound) {
  for (const char* text : {"Nobody presses it.",
                           "It waits in vain.",
                           "By turns left and right.",
                           "Moves now and then.",
                           "Runs so many steps.",
                           "Takes that many.",
                           "For so long it waits.",
                           "It tells of a crash.",
                           "The file is none.",
                           "This is no folder.",
                           "A sketch of ours.",
                           "Takes apart the text.",
                           "Makes a code of it.",
                           "The plain world runs.",
                           "Each deed is drawn.",
                           "It is mended.",
                           "All but for one.",
                           "Told is the place.",
                           "The one who asks.",
                           "Scans, for then it is lost.",
                           "Up to 2 ms behind its call.",
                           "Prints behind each step.",
                           "Sleeps behind power-on."})
    EXPECT_THAT(odd_words(paragraph(text)), SizeIs(1)) << text;
}

TEST(OddWords, AreNotGoodEnglish) {
  for (const char* text :
       {"There is none.", "It is none of these.", "There is no such file.", "It is no longer there.",
        "It is no more than 5.", "It is no higher than that.", "Options that many commands have.",
        "So many that it fails.", "Code that takes so long.", "A program of yours.", "Not as long as that.",
        "The linker is told to drop it.", "An obstacle behind the robot.", "5 cm behind the axle.", "Indeed.",
        "The clock lags behind.", "It searches, for example, here.", "Code such as `anew` is not prose.",
        "Takes a part of it."})
    EXPECT_THAT(odd_words(passages_of_document("a.md", text).at(0)), IsEmpty()) << text;
}

TEST(LongSentences, AreCountedInWordsBetweenStopsAndColons) {
  std::string words;
  for (std::size_t i = 0; i < kLongestSentence; ++i) words += "word ";
  EXPECT_THAT(long_sentences(paragraph(words + "12 0.5 (or more: here).")), IsEmpty());
  EXPECT_THAT(long_sentences(paragraph(words + ": " + words + "; " + words + " · " + words + ".")),
              IsEmpty());
  EXPECT_THAT(long_sentences(paragraph("Short.\n" + words + "more.")),
              ElementsAre(fmt::format("a.md:2: a sentence has {} words: expected at most {}",
                                      kLongestSentence + 1, kLongestSentence)));
  Passage row = paragraph(words + "more.");
  row.kind = Passage::Kind::row;
  EXPECT_THAT(long_sentences(row), IsEmpty());
}

TEST(BareOpenings, AreFragmentsAtTheBeginningOfAComment) {
  for (const char* text : {"Whether it runs.", "What it reads.", "How many there are.", "The same.",
                           "The same for a map.", "Likewise.", "Of a script.", "One more."})
    EXPECT_THAT(bare_openings(comment(text)), SizeIs(1)) << text;
  for (const char* text : {"Returns whether it runs.", "The same result every time.", "How fast is it?",
                           "Runs. Whether it is fast.", "When set, it runs.", "One of two."})
    EXPECT_THAT(bare_openings(comment(text)), IsEmpty()) << text;
  Passage second = comment("Whether it runs.");
  second.opens = false;
  EXPECT_THAT(bare_openings(second), IsEmpty());
}

TEST(OddMessages, HaveAnotherFormThanExpectedAndGot) {
  EXPECT_THAT(odd_messages(message("expected a map, but found a robot")), SizeIs(1));
  EXPECT_THAT(odd_messages(message("each { wants its }")), SizeIs(1));
  EXPECT_THAT(odd_messages(message("--pitch is of a maze with walls")), SizeIs(1));
  EXPECT_THAT(odd_messages(message("expected a map, got a robot")), IsEmpty());
  EXPECT_THAT(odd_messages(comment("It wants a map.")), IsEmpty());
}

TEST(LongLines, AreOfProse) {
  const std::string text = std::string(60, 'a') + " " + std::string(kLongestLine, 'b') + "\n";
  EXPECT_THAT(long_lines("a.md", "# A\n" + text),
              ElementsAre(fmt::format("a.md:2: a line has {} characters: expected at most {}",
                                      kLongestLine + 61, kLongestLine)));
  EXPECT_THAT(long_lines("a.md", "| " + text + "```\n" + text + "```\n- " + std::string(kLongestLine, 'b')),
              IsEmpty());
  std::string accents = "é ";
  for (std::size_t i = 2; i < kLongestLine; ++i) accents += "é";
  EXPECT_THAT(long_lines("a.md", accents), IsEmpty()) << "characters, not bytes";
}

TEST(OddNames, AreBareWordsOfCppFiles) {
  EXPECT_THAT(odd_name("sim/view/serve/patience.h"), SizeIs(1));
  EXPECT_THAT(odd_name("sim/base/whole.cpp"), SizeIs(1));
  EXPECT_THAT(odd_name("sim/world/walls.h"), IsEmpty());
  EXPECT_THAT(odd_name("sim/view/serve/request_deadline.h"), IsEmpty());
  EXPECT_THAT(odd_name("docs/whole.md"), IsEmpty());
}

TEST(OddSubjects, AreNotAnAreaAndAnImperative) {
  for (const char* subject : {"exec/host: Clear MSTR when SS goes low", "tests, docs: Format",
                              ".ci: Pass more files", "robot: Embed the catalogue"})
    EXPECT_THAT(odd_subject(subject), IsEmpty()) << subject;
  for (const char* subject : {"Fix it", "cli: fix it", "cli: Fixes it", "cli: Fixed it", "cli: Fixing it",
                              "cli: Fix it.", "Say of how many bugs the hunt was short"})
    EXPECT_THAT(odd_subject(subject), SizeIs(1)) << subject;
  EXPECT_THAT(odd_subject("cli: Fix " + std::string(kLongestSubject, 'a')),
              ElementsAre(HasSubstr("81 characters: expected at most 72")));
}

}  // namespace robosim::structure::prose_test
