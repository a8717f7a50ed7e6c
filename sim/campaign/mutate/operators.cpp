#include "sim/campaign/mutate/operators.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <map>
#include <set>

namespace robosim::mutate {
using nlohmann::json;

namespace {

std::string kind_of(const json& node) { return node.is_object() ? node.value("kind", "") : ""; }

const json& inner(const json& node) {
  static const json none = json::array();
  const auto found = node.find("inner");
  return found == node.end() ? none : *found;
}

std::string type_of(const json& node) {
  const auto type = node.find("type");
  if (type == node.end()) return "";
  return type->contains("desugaredQualType") ? (*type)["desugaredQualType"].get<std::string>()
                                             : type->value("qualType", "");
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Returns the position of the first occurrence of `word` as a whole word.
std::size_t find_word(const std::string& text, const std::string& word) {
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; ++at)
    if ((at == 0 || !is_word(text[at - 1])) &&
        (at + word.size() == text.size() || !is_word(text[at + word.size()])))
      return at;
  return std::string::npos;
}

const std::map<std::string, std::vector<const char*>> kRelational = {{"<", {"<=", ">"}}, {"<=", {"<", ">="}},
                                                                     {">", {">=", "<"}}, {">=", {">", "<="}},
                                                                     {"==", {"!="}},     {"!=", {"=="}}};
const std::map<std::string, std::vector<const char*>> kArithmetic = {
    {"+", {"-"}},   {"-", {"+"}},   {"*", {"/"}},   {"/", {"*"}},     {"%", {"*"}},    {"&", {"|"}},
    {"|", {"&"}},   {"<<", {">>"}}, {">>", {"<<"}}, {"+=", {"-="}},   {"-=", {"+="}},  {"*=", {"/="}},
    {"/=", {"*="}}, {"|=", {"&="}}, {"&=", {"|="}}, {"<<=", {">>="}}, {">>=", {"<<="}}};
const std::map<std::string, std::vector<const char*>> kLogic = {{"&&", {"||"}}, {"||", {"&&"}}};
const std::array<std::pair<const char*, const char*>, 10> kNarrower = {{{"unsigned long", "unsigned int"},
                                                                        {"uint32_t", "uint16_t"},
                                                                        {"int32_t", "int16_t"},
                                                                        {"long", "int"},
                                                                        {"uint16_t", "uint8_t"},
                                                                        {"int16_t", "int8_t"},
                                                                        {"unsigned int", "uint8_t"},
                                                                        {"int", "int8_t"},
                                                                        {"float", "int"},
                                                                        {"double", "int"}}};

/// Walks down the tree and collects the possible changes.
class Finder {
 public:
  explicit Finder(const Tree& tree) : tree_(tree) {}

  void look(const json& node) {
    const std::string kind = kind_of(node);
    if (kind == "BinaryOperator" || kind == "CompoundAssignOperator") binary(node);
    if (kind == "UnaryOperator") unary(node);
    if (kind == "IntegerLiteral") integer(node);
    if (kind == "FloatingLiteral")
      whole(node, "constant", [](const std::string& was) { return "(2 * " + was + ")"; });
    if (kind == "CXXBoolLiteralExpr")
      whole(node, "logic", [](const std::string& was) { return was == "true" ? "false" : "true"; });
    if (kind == "StringLiteral") in_flash(node);
    if (kind == "CompoundStmt")
      for (const json& statement : inner(node)) left_out(statement);
    if (kind == "IfStmt" || kind == "WhileStmt" || kind == "ForStmt")
      if (!inner(node).empty()) left_out(inner(node).back());
    if (kind == "ReturnStmt") returned(node);
    if (kind == "CallExpr" || kind == "CXXMemberCallExpr") arguments(node);
    if (kind == "VarDecl" || kind == "FieldDecl" || kind == "ParmVarDecl") declared(node);
    for (const json& child : inner(node)) look(child);
  }

  std::vector<Mutation> found;

  void add(const char* kind, const Range& range, std::string now) {
    const File& file = tree_.files[range.file];
    const std::string was = text_of(tree_, range);
    if (was == now) return;
    const auto line =
        1 + std::count(file.text.begin(), file.text.begin() + static_cast<std::ptrdiff_t>(range.from), '\n');
    found.push_back({kind, {{file.name, range.from, range.to, now}}, static_cast<int>(line), was, now});
  }

 private:
  template <typename Change>
  void whole(const json& node, const char* kind, Change change) {
    if (const auto range = range_of(tree_, node)) add(kind, *range, change(text_of(tree_, *range)));
  }

  void binary(const json& node) {
    const auto range = range_of(tree_, node);
    if (!range || inner(node).size() != 2) return;
    const auto left = range_of(tree_, inner(node)[0]), right = range_of(tree_, inner(node)[1]);
    const std::string sign = node.value("opcode", "");
    if (!left || !right || left->to > right->from) return;
    const std::string between = text_of(tree_, {range->file, left->to, right->from});
    const std::size_t at = between.find(sign);
    if (at == std::string::npos || between.find("/*") != std::string::npos ||
        between.find("//") != std::string::npos)
      return;
    const Range place{range->file, left->to + at, left->to + at + sign.size()};
    const bool pointers = type_of(node).find('*') != std::string::npos;
    for (const auto& [kind, table] : {std::pair{"relational", &kRelational},
                                      std::pair{"arithmetic", &kArithmetic}, std::pair{"logic", &kLogic}})
      if (const auto row = table->find(sign); row != table->end() && !pointers)
        for (const char* now : row->second) add(kind, place, now);
  }

  void unary(const json& node) {
    const auto range = range_of(tree_, node);
    const std::string sign = node.value("opcode", "");
    if (!range || (sign != "!" && sign != "++" && sign != "--" && sign != "-")) return;
    const bool behind = node.value("isPostfix", false);
    const Range place{range->file, behind ? range->to - sign.size() : range->from,
                      behind ? range->to : range->from + sign.size()};
    if (text_of(tree_, place) != sign) return;
    if (sign == "!") add("logic", place, " ");
    if (sign == "-") add("arithmetic", place, " ");
    if (sign == "++") add("arithmetic", place, "--");
    if (sign == "--") add("arithmetic", place, "++");
  }

  void integer(const json& node) {
    const auto range = range_of(tree_, node);
    if (!range) return;
    const std::string was = text_of(tree_, *range), value = node.value("value", "");
    unsigned long long number = 0;
    if (std::from_chars(value.data(), value.data() + value.size(), number).ec != std::errc()) return;
    std::string suffix;
    for (std::size_t i = was.size(); i > 0 && std::string("uUlL").find(was[i - 1]) != std::string::npos; --i)
      suffix.insert(0, 1, was[i - 1]);
    add("constant", *range, std::to_string(number + 1) + suffix);
    if (number > 0) add("constant", *range, std::to_string(number - 1) + suffix);
    if (number > 9) add("constant", *range, std::to_string(2 * number) + suffix);
  }

  // Removes F() around text. The literal is the argument of the macro.
  void in_flash(const json& node) {
    const auto range = node.find("range");
    if (range == node.end() || !(*range)["begin"].contains("expansionLoc")) return;
    json as_written = {
        {"range", {{"begin", (*range)["begin"]["spellingLoc"]}, {"end", (*range)["end"]["spellingLoc"]}}}};
    json macro = {
        {"range",
         {{"begin", (*range)["begin"]["expansionLoc"]}, {"end", (*range)["begin"]["expansionLoc"]}}}};
    const auto text = range_of(tree_, as_written), name = range_of(tree_, macro);
    if (!text || !name || text->file != name->file || text_of(tree_, *name) != "F") return;
    const std::string& all = tree_.files[text->file].text;
    if (name->to >= text->from || text->to >= all.size() || all[text->to] != ')') return;
    add("storage", {text->file, name->from, text->to + 1}, text_of(tree_, *text));
  }

  void left_out(const json& statement) {
    static const std::set<std::string> kinds = {"CallExpr",
                                                "CXXMemberCallExpr",
                                                "CXXOperatorCallExpr",
                                                "BinaryOperator",
                                                "CompoundAssignOperator",
                                                "UnaryOperator",
                                                "ExprWithCleanups",
                                                "BreakStmt",
                                                "ContinueStmt"};
    const std::string kind = kind_of(statement);
    const bool plain_return = kind == "ReturnStmt" && inner(statement).empty();
    if (!kinds.count(kind) && !plain_return) return;
    if (const auto range = range_of(tree_, statement)) add("statement", *range, "");
  }

  void returned(const json& node) {
    if (inner(node).empty()) return;
    const auto range = range_of(tree_, inner(node)[0]);
    const std::string type = type_of(inner(node)[0]);
    if (!range || type.find('*') != std::string::npos || type.find("class ") == 0) return;
    const std::string was = text_of(tree_, *range);
    if (type == "bool" || type == "_Bool")
      add("returned", *range, "!(" + was + ")");
    else if (was != "0")
      add("returned", *range, "0");
  }

  void arguments(const json& call) {
    const json& parts = inner(call);
    for (std::size_t i = 1; i + 1 < parts.size(); ++i) {
      const auto first = range_of(tree_, parts[i]), second = range_of(tree_, parts[i + 1]);
      if (!first || !second || first->file != second->file || first->to > second->from) continue;
      if (type_of(parts[i]) != type_of(parts[i + 1])) continue;
      const std::string a = text_of(tree_, *first), b = text_of(tree_, *second);
      if (a == b) continue;
      add("arguments", {first->file, first->from, second->to},
          b + text_of(tree_, {first->file, first->to, second->from}) + a);
    }
  }

  void declared(const json& node) {
    const auto range = range_of(tree_, node);
    const std::string name = node.value("name", "");
    if (!range || name.empty()) return;
    const std::string text = text_of(tree_, *range);
    const std::size_t at = find_word(text, name);
    if (at == std::string::npos) return;
    const std::string before = text.substr(0, at);
    const auto place = [&](std::size_t from, std::size_t size) {
      return Range{range->file, range->from + from, range->from + from + size};
    };
    for (const char* lost : {"volatile", "const"})
      if (const std::size_t word = find_word(before, lost); word != std::string::npos)
        add("storage", place(word, std::string(lost).size()), "");
    if (const std::size_t word = find_word(text.substr(0, text.find('=')), "PROGMEM");
        word != std::string::npos)
      add("storage", place(word, 7), "");
    for (const auto& [wide, narrow] : kNarrower)
      if (const std::size_t word = find_word(before, wide); word != std::string::npos) {
        add("type", place(word, std::string(wide).size()), narrow);
        break;
      }
  }

  const Tree& tree_;
};

bool before(const Mutation& a, const Mutation& b) {
  const auto key = [](const Mutation& m) {
    return std::tie(m.edits[0].file, m.edits[0].from, m.kind, m.now);
  };
  return key(a) < key(b);
}

/// Returns the pin of the statement pinMode(PIN, …); empty for any other statement.
std::string pin_of(const Tree& tree, const json& statement) {
  if (kind_of(statement) != "CallExpr" || inner(statement).size() != 3) return "";
  const auto callee = range_of(tree, inner(statement)[0]), pin = range_of(tree, inner(statement)[1]);
  return callee && pin && text_of(tree, *callee) == "pinMode" ? text_of(tree, *pin) : "";
}

void find_functions(const json& node, std::vector<const json*>& found) {
  const std::string kind = kind_of(node);
  if (kind == "FunctionDecl" || kind == "CXXMethodDecl") found.push_back(&node);
  if (kind == "NamespaceDecl" || kind == "CXXRecordDecl")
    for (const json& child : inner(node)) find_functions(child, found);
}

/// Finds the variables declared in `node`. Stores all uses of each variable under the variable's id.
void find_names(const Tree& tree, const json& node, std::vector<const json*>& declared,
                std::map<std::string, std::vector<Range>>& uses) {
  if (kind_of(node) == "VarDecl") declared.push_back(&node);
  if (kind_of(node) == "DeclRefExpr" && node.contains("referencedDecl")) {
    const std::string id = node["referencedDecl"].value("id", "");
    // A variable that is used in a macro is not renamed. An empty range marks such a use.
    const auto range = range_of(tree, node);
    uses[id].push_back(range ? *range : Range{});
  }
  for (const json& child : inner(node)) find_names(tree, child, declared, uses);
}

}  // namespace

std::vector<Mutation> mutations(const Tree& tree) {
  Finder finder(tree);
  for (const json& declaration : tree.declarations) finder.look(declaration);
  std::vector<Mutation>& all = finder.found;
  std::sort(all.begin(), all.end(), before);
  // Removes duplicates, since a header is parsed with each source that includes it.
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<Mutation> controls(const Tree& tree) {
  std::vector<const json*> functions;
  for (const json& declaration : tree.declarations) find_functions(declaration, functions);
  Finder all(tree);
  for (const json* function : functions) {
    if (inner(*function).empty()) continue;
    const json& body = inner(*function).back();
    const auto range = range_of(tree, body);
    if (kind_of(body) != "CompoundStmt" || !range) continue;
    if (function->value("name", "") == "setup")
      for (const char* some : {"{ delay(1);", "{ delay(5);"})
        all.add("delay", {range->file, range->from, range->from + 1}, some);
    const json& statements = inner(body);
    for (std::size_t i = 0; i + 1 < statements.size(); ++i) {
      const std::string a = pin_of(tree, statements[i]), b = pin_of(tree, statements[i + 1]);
      const auto first = range_of(tree, statements[i]), second = range_of(tree, statements[i + 1]);
      if (a.empty() || b.empty() || a == b || !first || !second) continue;
      all.add("order", {first->file, first->from, second->to},
              text_of(tree, *second) + text_of(tree, {first->file, first->to, second->from}) +
                  text_of(tree, *first));
    }
    std::vector<const json*> declared;
    std::map<std::string, std::vector<Range>> uses;
    find_names(tree, body, declared, uses);
    for (const json* variable : declared) {
      const std::string name = variable->value("name", "");
      const auto place =
          range_of(tree, {{"range", {{"begin", (*variable)["loc"]}, {"end", (*variable)["loc"]}}}});
      if (!place || text_of(tree, *place) != name) continue;
      Mutation renamed{"name", {}, 0, name, "other_" + name};
      std::vector<Range> places = uses[variable->value("id", "")];
      places.push_back(*place);
      std::sort(places.begin(), places.end(), [](const Range& x, const Range& y) { return x.from < y.from; });
      bool plain = true;
      for (const Range& use : places) {
        plain &= use.file == place->file && use.to - use.from == name.size() && text_of(tree, use) == name;
        if (plain) renamed.edits.push_back({tree.files[use.file].name, use.from, use.to, renamed.now});
      }
      const std::string& text = tree.files[place->file].text;
      renamed.line = static_cast<int>(
          1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place->from), '\n'));
      if (plain) all.found.push_back(renamed);
    }
  }
  std::sort(all.found.begin(), all.found.end(), before);
  return all.found;
}

}  // namespace robosim::mutate
