# SPDX-License-Identifier: MIT
"""Programs of a benchmark that is interrupted."""

import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = """
import sys
sys.path.insert(0, sys.argv[1])
from pathlib import Path
from benchmark_process import run
run(["sleep", sys.argv[2]], Path(sys.argv[3]), 1000.0)
"""


def is_running(command):
    found = subprocess.run(["pgrep", "-f", f"^{command}$"], stdout=subprocess.DEVNULL, check=False)
    return found.returncode == 0


def becomes(condition):
    end = time.monotonic() + 20.0
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.05)
    return False


class BenchmarkProcess(unittest.TestCase):
    def test_an_interruption_ends_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            log = str(Path(folder) / "log.txt")
            command = "sleep 1234.5"
            words = [sys.executable, "-c", SCRIPT, str(ROOT / "scripts/lib"), "1234.5", log]
            benchmark = subprocess.Popen(words, stderr=subprocess.DEVNULL)
            self.assertTrue(becomes(lambda: is_running(command)))
            benchmark.send_signal(signal.SIGINT)
            self.assertNotEqual(benchmark.wait(20.0), 0)
            self.assertTrue(becomes(lambda: not is_running(command)))


if __name__ == "__main__":
    unittest.main()
