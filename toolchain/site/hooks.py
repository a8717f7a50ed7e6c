"""Hooks of mkdocs: the pages, the navigation and the check of links. The documents are written for GitHub."""

import posixpath
import re
import shutil
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

from mkdocs.exceptions import PluginError

HERE = Path(__file__).parent
sys.path.append(str(HERE))
sys.dont_write_bytecode = True  # no __pycache__ among the sources
import api  # noqa: E402

FENCE = re.compile(r"(?ms)^( *```)(\w*)[^\n]*\n.*?^ *```$")
LINK = re.compile(r"\[((?:[^\[\]]|\[[^\]]*\])+)\]\(([^)\s#]+)(#[^)\s]*)?\)")
PAGES_AND_PICTURES = {".md", ".svg", ".png", ".html"}


def on_config(config):
    source, pages = Path(config["extra"]["robosim_source"]), Path(config["docs_dir"])
    documents = [source / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")]
    documents += sorted((source / "docs").rglob("*.md"))
    for document in documents:
        stage(document, document.relative_to(source).as_posix(), source, pages)
    shutil.copytree(source / "docs/pictures", pages / "docs/pictures")
    for name in ("site.css", "favicon.svg"):
        shutil.copy(HERE / name, pages)
    reference = api.write_pages(pages.parent / "xml", pages)
    config["nav"] = navigation((source / "docs/README.md").read_text(), pages, reference)
    config["mdx_configs"]["toc"]["slugify"] = anchor
    return config


def stage(document, name, source, pages):
    """Copies a document. Also copies each source file that it links as .txt, which every browser shows."""

    def link(match):
        text, path, fragment = match[1], match[2], match[3] or ""
        if ":" in path or Path(path).suffix in PAGES_AND_PICTURES:
            return match[0]
        target = posixpath.normpath(posixpath.join(posixpath.dirname(name), path))
        if not (source / target).is_file():
            return text if (source / target).is_dir() else match[0]  # strict mkdocs reports a missing target
        shown = target.lstrip(".") + ".txt"  # mkdocs skips hidden folders
        (pages / shown).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source / target, pages / shown)
        return f"[{text}]({posixpath.relpath(shown, posixpath.dirname(name))}{fragment})"

    # The first word after ``` is the language; tests use the other words.
    text, done, staged = document.read_text(), 0, []
    for fence in FENCE.finditer(text):
        staged += LINK.sub(link, text[done : fence.start()]), fence[1], fence[2], fence[0][fence[0].index("\n") :]
        done = fence.end()
    staged.append(LINK.sub(link, text[done:]))
    copy = pages / name
    copy.parent.mkdir(parents=True, exist_ok=True)
    copy.write_text("".join(staged))


def navigation(index, pages, reference):
    """Returns the sections of docs/README.md with the pages that they link, then the evidence."""
    home = {"Robosim": "README.md", "All documents": "docs/README.md", "FAQ": "docs/faq.md", "Changelog": "CHANGELOG.md"}
    nav, seen = [{"Home": [{title: page} for title, page in home.items()]}], set(home.values())
    sections = [part.split("\n", 1) for part in index.split("\n## ")[1:]]
    evidence = "\n".join(f"[{p.stem}](evidence/{p.name})" for p in sorted((pages / "docs/evidence").glob("*.md")))
    sections.append(["Evidence", evidence])
    for heading, text in sections:
        entries = []
        for match in LINK.finditer(text):
            path = posixpath.normpath(posixpath.join("docs", match[2]))
            if path.endswith(".md") and path not in seen:
                seen.add(path)
                entries.append({match[1][0].upper() + match[1][1:]: path})
        nav.append({heading.split(":")[0]: entries})
    nav.insert(4, {"API": reference})
    lost = sorted(p.relative_to(pages).as_posix() for p in (pages / "docs").rglob("*.md"))
    lost = [page for page in lost if page not in seen]
    if lost:
        raise PluginError(f"docs/README.md: no link to {', '.join(lost)}")
    return nav


def anchor(heading, _separator):
    """Returns GitHub's anchor of a heading."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def on_page_content(html, **_):
    # In a table's cell, GitHub's Markdown needs \| for | even within code.
    return re.sub(r"<code>[^<]*</code>", lambda code: code[0].replace("\\|", "|"), html)


class Page(HTMLParser):
    """Collects a page's anchors, links, and loaded files."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.links, self.loaded = {""}, [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors.update(filter(None, (values.get("id"), values.get("name"))))
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])
        elif tag in ("link", "script", "img", "iframe", "source"):
            self.loaded += filter(None, (values.get("href"), values.get("src")))


def on_post_build(config):
    """Fails if a link or an anchor leads nowhere, or if a page loads anything from the network."""
    root = Path(config["site_dir"])
    pages = {p.relative_to(root).as_posix(): Page(p.read_text()) for p in sorted(root.rglob("*.html"))}
    broken = []
    for name, page in pages.items():
        if name == "404.html":
            continue  # its links start with /
        for url in page.links + page.loaded:
            parts = urlsplit(url)
            if parts.scheme or parts.netloc:
                if url in page.loaded and parts.netloc:
                    broken.append(f"{name}: loads {url} from the network")
                continue
            path = unquote(parts.path)
            target = posixpath.normpath(posixpath.join(posixpath.dirname(name), path)) if path else name
            if (root / target).is_dir():
                target = posixpath.join(target, "index.html")
            if not (root / target).is_file():
                broken.append(f"{name}: no file {url}")
            elif target in pages and unquote(parts.fragment) not in pages[target].anchors:
                broken.append(f"{name}: no anchor {url}")
    if broken:
        raise PluginError("broken links:\n  " + "\n  ".join(dict.fromkeys(broken)))
