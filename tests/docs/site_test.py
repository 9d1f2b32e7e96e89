#!/usr/bin/env python3
"""The built site: every link, anchor and picture is there, every page is in the navigation, and nothing is loaded from elsewhere.

`site_test.py PROGRAM SITE`. Needs only Python's standard library, and node for the search.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import unittest
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", ".."))
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(ROOT, "tools"))

from docs_site import repository  # noqa: E402  (the path first)

LOADING = {"script": "src", "img": "src", "iframe": "src", "source": "src", "video": "src", "embed": "src", "object": "data"}
LOADING_LINKS = {"stylesheet", "preload", "prefetch", "preconnect", "dns-prefetch", "icon", "modulepreload", "manifest"}


class Page(HTMLParser):
    """The links, anchors and pictures of a page, and what it loads."""

    def __init__(self, text):
        super().__init__()
        self.links, self.loads, self.pictures, self.anchors, self.twice = [], [], [], set(), []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        if values.get("id"):
            if values["id"] in self.anchors:
                self.twice.append(values["id"])
            self.anchors.add(values["id"])
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])
        if tag == "img":
            self.pictures.append((values.get("src", ""), values.get("alt", "")))
        if tag in LOADING and values.get(LOADING[tag]):
            self.loads.append(values[LOADING[tag]])
        if tag == "link" and set(values.get("rel", "").split()) & LOADING_LINKS:
            self.loads.append(values["href"])
        if values.get("style"):
            self.loads += re.findall(r"url\(['\"]?([^'\")]+)", values["style"])


class Site(unittest.TestCase):
    site = ""

    @classmethod
    def setUpClass(cls):
        cls.pages, cls.files = {}, set()
        for base, _, names in os.walk(cls.site):
            for name in names:
                path = os.path.relpath(os.path.join(base, name), cls.site)
                cls.files.add(path)
                if name.endswith(".html"):
                    with open(os.path.join(base, name), encoding="utf-8") as file:
                        cls.pages[path] = Page(file.read())

    def local(self, page, target):
        """The file and the anchor that a link leads to; none for other sites and data."""
        parts = urlsplit(target)
        if parts.scheme or parts.netloc:
            return None
        path = unquote(parts.path)
        file = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
        return file, unquote(parts.fragment)

    def test_links_and_anchors_lead_somewhere(self):
        count = 0
        for name, page in self.pages.items():
            for link in page.links:
                target = self.local(name, link)
                if target is None:
                    continue
                count += 1
                file, anchor = target
                with self.subTest(page=name, link=link):
                    self.assertTrue(file in self.files, file)
                    if anchor and file.endswith(".html"):
                        self.assertIn(anchor, self.pages[file].anchors)
        print("site: %d pages, %d links" % (len(self.pages), count))
        self.assertGreater(count, 500)

    def test_nothing_needs_the_sites_address(self):
        self.assertEqual({"404.html", "sitemap.xml", "sitemap.xml.gz"} & self.files, set())

    def test_cells_of_wide_tables_have_their_columns_heads(self):
        for page in ("reference/light.html", "reference/events.html", "how-to/pictures.html"):
            with open(os.path.join(self.site, page), encoding="utf-8") as file:
                text = file.read()
            for table in re.findall(r"<table>.*?</table>", text, re.DOTALL):
                heads = [re.sub("<[^>]+>", "", head) for head in re.findall(r"<th[^>]*>(.*?)</th>", table, re.DOTALL)]
                if len(heads) > 2 or "<img" in table:
                    with self.subTest(page=page, heads=heads):
                        self.assertLessEqual(set(filter(None, heads[1:])), set(re.findall(r'data-label="([^"]*)"', table)))

    def found(self, *queries):
        """The pages that the site's own search worker finds for each, the best first."""
        [worker] = [name for name in self.files if re.fullmatch(r"assets/javascripts/workers/search\..*\.min\.js", name)]
        done = subprocess.run(["node", os.path.join(HERE, "search.mjs"), os.path.join(self.site, worker),
                               os.path.join(self.site, "search", "search_index.json")], input=json.dumps(queries),
                              stdout=subprocess.PIPE, text=True, check=True, timeout=120)
        return dict(zip(queries, json.loads(done.stdout), strict=True))

    def test_the_search_finds_names_and_their_parts(self):
        if not shutil.which("node"):
            self.skipTest("there is no node to run the search")
        with open(os.path.join(HERE, "search_queries.json"), encoding="utf-8") as file:
            expected = json.load(file)
        found = self.found(*expected)
        for query, page in expected.items():
            with self.subTest(query=query):
                self.assertIn(page, found[query][:4])
        print("site: %d searches" % len(expected))

    def test_what_is_copied_of_a_session_is_what_is_typed(self):
        prompts = set()
        for page in self.pages:
            with open(os.path.join(self.site, page), encoding="utf-8") as file:
                prompts.update(re.findall(r'<span class="gp">(.*?)</span>', file.read()))
        self.assertEqual({prompt.strip() for prompt in prompts}, {"$"})

    def test_files_of_the_repository_are_linked_where_it_is_published(self):
        text = "See `SECURITY.md`, `config/walks/expectations` and [`tools`](x); `no/file`.\n```sh\ncat `SECURITY.md`\n```\n"
        self.assertEqual(repository.with_links(text, None, ROOT), text)
        self.assertEqual(repository.with_links(text, "https://h/", ROOT), text.replace(
            "See `SECURITY.md`", "See [`SECURITY.md`](https://h/SECURITY.md)").replace(
            "`config/walks/expectations`", "[`config/walks/expectations`](https://h/config/walks/expectations)"))

        class Published:
            def initial(self, _):
                return "uses: actions/checkout@%s # v4\nuses: owner/name@%s # v1\n" % ("1" * 40, "2" * 40)
        self.assertEqual(repository.address(Published()), "https://github.com/owner/name/blob/%s/" % ("2" * 40))

    def test_pictures_are_there_and_described(self):
        count = 0
        for name, page in self.pages.items():
            for source, words in page.pictures:
                with self.subTest(page=name, picture=source):
                    file, _ = self.local(name, source)
                    self.assertIn(file, self.files)
                    self.assertGreater(os.path.getsize(os.path.join(self.site, file)), 200)
                    if not file.startswith("assets/"):
                        self.assertGreater(len(words), 20, "its words")
                        count += 1
        print("site: %d pictures" % count)
        self.assertGreater(count, 5)

    def test_ids_are_unique(self):
        for name, page in self.pages.items():
            with self.subTest(page=name):
                self.assertEqual([each for each in page.twice if not each.startswith("__")], [])

    def test_nothing_is_loaded_from_elsewhere(self):
        for name, page in self.pages.items():
            for target in page.loads:
                with self.subTest(page=name, target=target):
                    self.assertFalse(urlsplit(target).netloc or urlsplit(target).scheme not in ("", "data"))
        for path in self.files:
            if path.endswith(".css"):
                with open(os.path.join(self.site, path), encoding="utf-8") as file:
                    text = file.read()
                for target in re.findall(r"url\(['\"]?([^'\")]+)|@import ['\"]([^'\"]+)", text):
                    target = "".join(target)
                    with self.subTest(file=path, target=target[:60]):
                        self.assertTrue(target.startswith("data:") or not urlsplit(target).netloc)

    def test_the_themes_script_asks_others_for_nothing_that_a_page_uses(self):
        # It would load mermaid for diagrams, and ask GitHub about a repository.
        for name, page in self.pages.items():
            with open(os.path.join(self.site, name), encoding="utf-8") as file:
                text = file.read()
            with self.subTest(page=name):
                self.assertNotIn('class="mermaid"', text)
                self.assertNotIn('data-md-component="source"', text)

    def test_no_mark_of_a_generator_or_a_test_is_left(self):
        for name in self.pages:
            with open(os.path.join(self.site, name), encoding="utf-8") as file:
                text = file.read()
            with self.subTest(page=name):
                self.assertNotRegex(text, r"<!-- (?:generated|test|keys|in the)")

    def test_every_page_is_in_the_navigation(self):
        linked = {self.local("index.html", link)[0] for link in self.pages["index.html"].links if self.local("index.html", link)}
        self.assertEqual(set(self.pages) - linked - {"index.html"}, set())


if __name__ == "__main__":
    Site.site = os.path.abspath(sys.argv[2])
    unittest.main(argv=[sys.argv[0]])
