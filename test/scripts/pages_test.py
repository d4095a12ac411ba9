# SPDX-License-Identifier: MIT
"""What the pages of the documentation hold."""

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class Pages(unittest.TestCase):
    def test_every_page_is_in_the_menu_of_the_site(self):
        menu = set(re.findall(r": (\w+\.md)$", (ROOT / "mkdocs.yml").read_text(), re.MULTILINE))
        pages = {page.name for page in (ROOT / "docs").glob("*.md")}
        self.assertEqual(menu, pages | {"index.md", "contributing.md"})

    def test_the_page_of_the_api_shows_the_example_that_is_compiled(self):
        page = (ROOT / "docs/api.md").read_text()
        self.assertIn("```cpp\n" + (ROOT / "examples/map_scans.cpp").read_text() + "```\n", page)

    def test_every_header_that_the_page_of_the_api_names_exists(self):
        headers = re.findall(r"`((?:\w+/)+\w+\.h)`", (ROOT / "docs/api.md").read_text())
        self.assertGreaterEqual(len(headers), 6)
        for header in headers:
            self.assertTrue((ROOT / "include/revisit_slam" / header).exists(), header)

    def test_the_readme_is_short(self):
        self.assertLessEqual(len((ROOT / "README.md").read_text().splitlines()), 120)


if __name__ == "__main__":
    unittest.main()
