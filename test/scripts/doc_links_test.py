# SPDX-License-Identifier: MIT
"""The links of README.md, CONTRIBUTING.md and docs/, and what judges them."""

import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts/lib"))
import doc_links  # noqa: E402


class DocLinks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        (self.root / "docs").mkdir()
        self.write("README.md", "# It\n")
        self.write("CONTRIBUTING.md", "# Changes\n")

    def write(self, name, text):
        (self.root / name).write_text(text)

    def test_every_link_of_the_documentation_leads_somewhere(self):
        self.assertGreater(sum(len(doc_links.links_of(p)) for p in doc_links.pages(ROOT)), 100)
        self.assertEqual(list(doc_links.dead_links(ROOT)), [])

    def test_a_missing_file_and_a_missing_heading_are_named(self):
        self.write("docs/a.md", "# A\n[x](b.md) [y](../README.md#its) [z](#a) [w](../README.md#it)\n")
        self.assertEqual(
            list(doc_links.dead_links(self.root)),
            ["docs/a.md: b.md: there is no such file",
             "docs/a.md: ../README.md#its: there is no such heading"])

    def test_code_holds_no_links_and_no_headings(self):
        self.write("docs/a.md", "`[x](y.md)`\n```\n# not a heading\n[x](z.md)\n```\n[w](#not-a-heading)\n")
        self.assertEqual(list(doc_links.dead_links(self.root)),
                         ["docs/a.md: #not-a-heading: there is no such heading"])

    def test_anchors_are_those_of_github(self):
        self.assertEqual(doc_links.anchor_of("Why `live` equals offline, and a — b"),
                         "why-live-equals-offline-and-a--b")
        self.write("docs/a.md", "# Two\n# Two\n")
        self.assertEqual(doc_links.anchors_of(self.root / "docs/a.md"), {"two", "two-1"})

    def test_a_site_is_judged_by_its_ids(self):
        self.write("index.html", '<h1 id="it">It</h1><a href="docs/#a">a</a><a href="#it">it</a>')
        self.write("docs/index.html", '<a href="../#gone">x</a><img src="none.png">')
        self.assertEqual(
            list(doc_links.dead_links_of_site(self.root)),
            ["docs/index.html: ../#gone: there is no such heading",
             "docs/index.html: none.png: there is no such file",
             "index.html: docs/#a: there is no such heading"])


if __name__ == "__main__":
    unittest.main()
