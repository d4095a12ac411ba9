# SPDX-License-Identifier: MIT
"""What the key of a recording depends on, and where its bags are copied to."""

import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts/lib"))
from fleet_tasks import Context, Recording, options_key  # noqa: E402


class FleetTasks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_a_file_that_the_options_name_counts_with_its_content(self):
        file = self.folder / "car.yaml"
        recording = Recording("a", ("a.bag",), ("--params", str(file)))
        keys = []
        for text in ("x: 1", "x: 2", "x: 1"):
            file.write_text(text)
            keys.append(options_key(recording))
        self.assertNotEqual(keys[0], keys[1])
        self.assertEqual(keys[0], keys[2])

    def test_bags_of_one_name_in_two_places_are_two_files(self):
        try:
            import fsspec
        except ImportError:
            self.skipTest("needs fsspec")
        memory = fsspec.filesystem("memory")
        for day in ("monday", "tuesday"):
            memory.pipe_file(f"/{day}/0.bag", day.encode())
        context = Context(None, self.folder)
        local = [
            context.local_bag(number, f"memory://{day}/0.bag")
            for number, day in enumerate(("monday", "tuesday"))
        ]
        self.assertEqual([file.read_text() for file in local], ["monday", "tuesday"])


if __name__ == "__main__":
    unittest.main()
