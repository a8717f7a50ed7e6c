"""Turns Doxygen's XML into pages of Markdown, one for each header, so that all pages share one search and one design."""

import re
from collections import defaultdict
from pathlib import Path
from xml.etree import ElementTree

# Groups of headers: the name, the folder that an #include is relative to, and the purpose.
GROUPS = [
    ("Tests", "sim/testing/", "tests of firmware in C++: [how to write them](docs/howto/testing.md)"),
    ("Cells", "sim/map/cells/include/", "algorithms for [the robot on cells](docs/reference/algorithms.md)"),
    ("LineKit", "firmware/src/", "sketches: the parts of a line follower, and navigation on a network of lines"),
    ("Board", "", "the interface between firmware and robot: [design](docs/explanation/design.md)"),
]
CLASSES = ("class", "struct", "union")


class Header:
    def __init__(self, file, about):
        self.group, prefix, _ = next(group for group in GROUPS if file.startswith(group[1]))
        self.include = file[len(prefix) :]
        self.page = f"api/{self.include[:-2]}.md"
        self.about = about
        self.classes, self.members = [], []


def write_pages(xml, pages):
    """Writes the pages, and api.md, which lists them. Returns their part of the navigation."""
    compounds = [ElementTree.parse(file).getroot().find("compounddef") for file in sorted(xml.glob("*.xml"))]
    compounds = [c for c in compounds if c is not None]
    headers, places = {}, {}  # places: the page of each header and class
    for compound in compounds:
        if compound.get("kind") == "file":
            file = compound.find("location").get("file")
            headers[file] = Header(file, compound)
            places[compound.get("id")] = headers[file].page
    namespaces = [c.findtext("compoundname") for c in compounds if c.get("kind") == "namespace"]
    seen = set()
    for compound in compounds:
        name = compound.findtext("compoundname")
        if "detail" in name.split("::") or compound.get("prot") == "private":
            continue
        if compound.get("kind") in CLASSES:
            header = headers[compound.find("location").get("file")]
            class_name = short(name, namespaces)
            title = f"{compound.get('kind')} {class_name}"
            header.classes.append((title, compound))
            places[class_name] = header.page + "#" + re.sub(r"[^\w-]", "", title.lower().replace(" ", "-"))
            continue
        for member in compound.iter("memberdef"):
            if member.get("id") not in seen:
                seen.add(member.get("id"))
                headers[member.find("location").get("file")].members.append(member)
    for header in headers.values():
        path = pages / header.page
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(Writer(header, places).page())

    index = ["# API reference\n", "For everyone who writes C++ against Robosim: the public headers.\n"]
    nav = [{"Headers": "api.md"}]
    for group, _, purpose in GROUPS:
        index += [f"## {group}\n", f"For {purpose}.\n", "| header | contents |\n|---|---|"]
        members = sorted((h for h in headers.values() if h.group == group), key=lambda h: h.include.lower())
        for header in members:
            brief = Writer(header, places, "api.md").text(header.about.find("briefdescription"))
            index.append(f"| [{header.include}]({header.page}) | {brief} |")
        index.append("")
        nav.append({group: [{Path(h.include).name: h.page} for h in members]})
    index.append("Next: [documents](docs/README.md)\n")
    (pages / "api.md").write_text("\n".join(index))
    return nav


def short(name, namespaces):
    """Returns the name without its namespaces."""
    longest = max((n for n in namespaces if name.startswith(n + "::")), key=len, default="")
    return name[len(longest) :].lstrip(":")


class Writer:
    def __init__(self, header, places, page=None):
        self.header, self.places = header, places
        self.page_of_links = page or header.page

    def page(self):
        header = self.header
        out = [f"# {header.include}\n", self.description(header.about)]
        out.append(f"```cpp\n#include <{header.include}>\n```\n")
        included = filter(None, (self.places.get(i.get("refid")) for i in header.about.findall("includes")))
        links = [f"[{page[4:-3]}.h]({self.relative(page)})" for page in included]
        out.append(f"Includes {', '.join(links)}.\n" if links else "")
        for title, compound in sorted(header.classes, key=lambda c: line_of(c[1])):
            out += [f"## {title}\n", self.class_line(compound), self.description(compound)]
            members = [m for m in compound.iter("memberdef") if m.get("prot") == "public"]
            out.append(self.members(members))
        if header.members:
            out += ["## Others\n" if header.classes else "## Contents\n", self.members(header.members)]
        out.append(f"Next: [all headers]({self.relative('api.md')})\n")
        return "\n".join(part for part in out if part)

    def class_line(self, compound):
        bases = [f"public {plain(base)}" for base in compound.findall("basecompoundref")]
        line = template_of(compound)
        if not line and not bases:
            return ""
        name = compound.findtext("compoundname").split("::")[-1]
        return f"```cpp\n{line}{compound.get('kind')} {name}{' : ' if bases else ''}{', '.join(bases)};\n```\n"

    def members(self, members):
        """Returns documented functions with a heading each, other functions as code, and variables as tables."""
        out, code, rows, last = [], [], [], ""

        def flush():
            if code:
                out.append("```cpp\n" + "\n".join(code) + "\n```\n")
                code.clear()
            if rows:
                out.append("| member | meaning |\n|---|---|\n" + "\n".join(rows) + "\n")
                rows.clear()

        for member in sorted(members, key=line_of):
            name, kind, about = member.findtext("name"), member.get("kind"), self.description(member)
            if kind == "friend" or "=delete" in (member.findtext("argsstring") or "").replace(" ", ""):
                continue
            if kind == "variable" and (rows or about) and "\n\n" not in about.strip():
                if code:
                    flush()
                rows.append(f"| {in_cell(declaration(member))} | {about.strip().replace(chr(10), ' ')} |")
                continue
            if about and not about[0].isupper() and "\n" not in about.strip():
                if rows:
                    flush()
                code.append(f"{declaration(member)}  // {plain(member.find('briefdescription')).strip()}")
                continue
            if rows or about:
                flush()
            if about and name != last:
                out.append(f"### `{name}`\n")
            code.append(declaration(member))
            values = member.findall("enumvalue")
            if any(self.description(value) for value in values):
                flush()
                rows += [f"| {in_cell(v.findtext('name'))} | {self.description(v).strip()} |" for v in values]
            if about:
                flush()
                out.append(about)
            last = name
        flush()
        return "\n".join(out)

    def description(self, node):
        parts = (self.text(node.find(tag)) for tag in ("briefdescription", "detaileddescription"))
        text = "\n\n".join(part for part in parts if part)
        return text + "\n" if text else ""

    def text(self, node):
        return re.sub(r"\n{3,}", "\n\n", self.inner(node)).strip() if node is not None else ""

    def inner(self, node):
        out = self.words(node.text)
        for child in node:
            out += self.element(child) + self.words(child.tail)
        return out

    def element(self, node):
        if node.tag in ("verbatim", "programlisting", "preformatted"):
            return f"\n\n```cpp\n{plain(node).strip(chr(10))}\n```\n\n"
        if node.tag == "computeroutput":
            code = plain(node)
            return f"[`{code}`]({self.relative(self.places[code])})" if code in self.places else f"`{code}`"
        if node.tag == "listitem":
            return "- " + self.inner(node).strip().replace("\n", "\n  ") + "\n"
        if node.tag in ("para", "itemizedlist", "orderedlist"):
            return "\n\n" + self.inner(node) + "\n\n"
        if node.tag in ("ndash", "mdash"):
            return {"ndash": "–", "mdash": "—"}[node.tag]
        return self.inner(node)

    def words(self, text):
        """Returns escaped text, in which the names of documents are links."""
        text = escape(re.sub(r"\s+", " ", text or ""))
        return re.sub(r"docs/[\w/-]+\.md", lambda name: f"[{name[0]}]({self.relative(name[0])})", text)

    def relative(self, page):
        return "../" * self.page_of_links.count("/") + page


def escape(text):
    text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return re.sub(r"([\\`*\[\]|]|\b_|_\b)", r"\\\1", text)


def in_cell(code):
    return "`" + re.sub(r"\s+", " ", code).rstrip(";").replace("|", "\\|") + "`"


def plain(node):
    return "".join(node.itertext()) if node is not None else ""


def line_of(node):
    return int(node.find("location").get("line"))


def template_of(node):
    parameters = node.find("templateparamlist")
    if parameters is None:
        return ""
    names = (" ".join(filter(None, (plain(p.find("type")), p.findtext("declname")))) for p in parameters)
    return f"template <{', '.join(names)}>\n"


def declaration(member):
    kind, name, type_ = member.get("kind"), member.findtext("name"), plain(member.find("type"))
    if kind == "define":
        parameters = [plain(p.find("defname")) for p in member.findall("param")]
        return f"#define {name}" + (f"({', '.join(parameters)})" if parameters else "")
    if kind == "enum":
        names = ", ".join(v.findtext("name") for v in member.findall("enumvalue"))
        return f"enum {'class ' if member.get('strong') == 'yes' else ''}{name} {{ {names} }};"
    if kind == "typedef":
        return tidy(f"{template_of(member)}using {name} = {type_};")
    words = "static " if member.get("static") == "yes" else ""
    words += "explicit " if member.get("explicit") == "yes" else ""
    words += "virtual " if member.get("virt", "non-virtual") != "non-virtual" and "virtual" not in type_ else ""
    type_ = re.sub(r"\s*([&*])$", r"\1", type_)
    type_ = re.sub(r"^enum (\w+::)+", "", type_)
    text = f"{template_of(member)}{words}{type_}{' ' if type_ else ''}{name}{member.findtext('argsstring') or ''}"
    if kind == "variable":
        initial = plain(member.find("initializer")).strip()
        text += f" {initial}" if initial and "\n" not in initial and len(initial) < 40 else ""
    return tidy(text) + ";"


def tidy(text):
    """Removes Doxygen's blanks and parameters that only the compiler fills in, and adds .clang-format's blanks."""
    text = re.sub(r"(, )?const char \*file=__builtin_FILE\(\), int line=__builtin_LINE\(\)", "", text)
    text = re.sub(r"(?<=\w)< | (?=>)", lambda blank: blank[0].strip(), text)
    text = re.sub(r" ([&*]+)(?=\w)", r"\1 ", text)
    text = re.sub(r" ([&*]+)(?=[,)])", r"\1", text)
    return re.sub(r"(?<=[\w)]) ?=(?=[\w\"{-])", " = ", text)
