// Tests that snapshots contain all members that change during a run. Each class stores such members in one
// `State`, which snapshots copy as a whole. snapshot_members.txt lists the exceptions.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "sim/base/file.h"
#include "tests/unit/structure/include_table.h"

namespace robosim::structure::snapshot_members_test {

using testing::ElementsAre;
using testing::IsEmpty;

struct MembersTable {
  std::vector<std::string> rooms;
  std::set<std::string> files;    ///< files of which all members are exceptions
  std::set<std::string> members;  ///< other exceptions, as "FILE MEMBER"
};

/// Reads a table of lines `KIND: FILE MEMBERS` or `KIND: FILES`.
MembersTable read_members_table(const std::string& text) {
  MembersTable table;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string kind, word, file;
    words >> kind;
    std::vector<std::string> files, members;
    while (words >> word) (word.find('/') != word.npos ? files : members).push_back(word);
    if (kind == "rooms:") {
      table.rooms = files;
    } else if (members.empty()) {
      table.files.insert(files.begin(), files.end());
    } else {
      for (const std::string& member : members) table.members.insert(files.front() + ' ' + member);
    }
  }
  return table;
}

/// Returns whether a member of this type never changes. Such a type is const, a reference, or the id of a
/// chip's event.
bool never_changes(const std::string& type) {
  return (type.starts_with("const ") && !type.ends_with("*")) || type.ends_with("&") ||
         type.ends_with("* const") || type.ends_with("Events::Id");
}

/// Returns the members that a line declares, except those that never change.
std::vector<std::string> members_of(const std::string& line) {
  static const std::regex kDeclaration(
      R"(\s+(?:mutable |alignas\(\S+\) )?([\w:][\w:<>,*& ()]*[>*&\w])\s+([a-z]\w*_(?:[^()]|\(\))*);\s*)");
  static const std::regex kName(R"((?:^|, )([a-z]\w*_)(?=[,\[{]|$| =))");
  if (line.find("_;") == line.npos && line.find("_ =") == line.npos && line.find("_{") == line.npos &&
      line.find("_[") == line.npos)
    return {};
  std::smatch parts;
  if (!std::regex_match(line, parts, kDeclaration)) return {};
  const std::string type = parts[1], names = parts[2];
  if (never_changes(type) || type.find("return") != type.npos) return {};
  std::vector<std::string> members;
  for (std::sregex_iterator name(names.begin(), names.end(), kName), end; name != end; ++name)
    members.push_back((*name)[1]);
  return members;
}

bool is_within(const std::string& file, const std::vector<std::string>& rooms) {
  for (const std::string& room : rooms)
    if (file.starts_with(room + "/")) return true;
  return false;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++found;
  return found;
}

/// Returns a message for each member that a snapshot may miss.
std::vector<std::string> forgotten(const MembersTable& table, const Files& files) {
  std::vector<std::string> sentences;
  for (const auto& [file, text] : files) {
    if (!is_within(file, table.rooms) || table.files.contains(file)) continue;
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      for (const std::string& member : members_of(line.substr(0, line.find("//"))))
        if (member != "state_" && !table.members.contains(file + ' ' + member))
          sentences.push_back(fmt::format("{}:{}: {} is neither const nor in State", file, number, member));
    }
    const auto source = files.find(file.substr(0, file.rfind('.')) + ".cpp");
    const std::string both = text + (file.ends_with(".h") && source != files.end() ? source->second : "");
    std::size_t saved = 0;
    for (const char* way : {"keep(state_)", "add(state_)", "return state_;", "{state_,"})
      saved += count(both, way);
    if (file.ends_with(".h") && count(text, "State state_;") > saved)
      sentences.push_back(fmt::format("{}: a state_ that is not saved", file));
  }
  return sentences;
}

TEST(Snapshots, ForgetNoMember) {
  const std::string root = ROBOSIM_SOURCE_DIR, file = "tests/unit/structure/snapshot_members.txt";
  const Files sources = read_sources(root);
  const MembersTable table = read_members_table(read_file(root + "/" + file));
  for (const std::string& sentence : forgotten(table, sources))
    ADD_FAILURE() << sentence << " (" << file << ")";
  for (const std::string& listed : table.files)
    EXPECT_TRUE(sources.contains(listed)) << listed << " in " << file;
  for (const std::string& listed : table.members) {
    const std::string where = listed.substr(0, listed.find(' '));
    ASSERT_TRUE(sources.contains(where)) << listed << " in " << file;
    EXPECT_NE(sources.at(where).find(listed.substr(where.size() + 1)), std::string::npos)
        << listed << " in " << file;
  }
}

TEST(SnapshotMembers, AreConstOrInStateOrInTheTable) {
  const MembersTable table =
      read_members_table("rooms: sim/world sim/run\nwhole: sim/world/body.h\nmade: sim/run/a.h p_");
  EXPECT_THAT(
      forgotten(table,
                {{"sim/world/body.h", "  double v_ = 0.0;\n"},
                 {"sim/map/map.h", "  int x_;\n"},
                 {"sim/run/a.h",
                  "  const Body& body_;\n  Part* p_ = nullptr;\n  const int n_;\n  Events::Id due_ = 0;\n"
                  "  State state_;\n"},
                 {"sim/run/a.cpp", "  kept.add(state_);\n  x_ = 3;\n  return x_;\n"}}),
      IsEmpty());
  EXPECT_THAT(
      forgotten(table, {{"sim/run/a.h",
                         "  mutable int n_ = 0, m_[2];\n  std::vector<bool> b_;\n  State state_;\n"}}),
      ElementsAre("sim/run/a.h:1: n_ is neither const nor in State",
                  "sim/run/a.h:1: m_ is neither const nor in State",
                  "sim/run/a.h:2: b_ is neither const nor in State",
                  "sim/run/a.h: a state_ that is not saved"));
}

}  // namespace robosim::structure::snapshot_members_test
