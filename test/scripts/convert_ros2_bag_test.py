# SPDX-License-Identifier: MIT
"""Recordings of ROS 2 become bags that hold the same."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np
import rosbag

ROOT = Path(__file__).resolve().parents[2]
CONVERT = ROOT / "scripts/convert_ros2_bag"
CACHE = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache"))
PYTHON = CACHE / "revisit_slam/rosbags/bin/python"


def run(*arguments):
    return subprocess.run([str(a) for a in arguments], capture_output=True, text=True, check=False)


class ConvertRos2Bag(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def record(self, storage):
        if not PYTHON.exists():
            self.skipTest(f"rosbags is not installed: {CONVERT} installs it")
        recording = self.folder / f"recording_{storage}"
        written = run(PYTHON, ROOT / "test/scripts/write_ros2_bag.py", recording, storage)
        self.assertEqual(written.returncode, 0, written.stderr)
        return recording

    def check(self, recording, topics):
        bag = self.folder / "drive.bag"
        converted = run(CONVERT, recording, bag)
        self.assertEqual(converted.returncode, 0, converted.stderr)
        self.assertIn(f"doctor --bag {bag}", converted.stdout)
        with rosbag.Bag(str(bag)) as read:
            messages = list(read.read_messages())
        self.assertEqual({m.topic for m in messages}, topics)
        clouds = [m.message for m in messages if m.topic == "/points"]
        self.assertEqual([round(c.header.stamp.to_sec(), 3) for c in clouds],
                         [1700000000.0, 1700000000.1, 1700000000.2, 1700000000.3, 1700000000.4])
        sent = np.random.default_rng(1_700_000_000_000_000_000).random((500, 3)) * 20 - 10
        self.assertEqual(clouds[0].data, sent.astype("<f4").tobytes())
        self.assertEqual(clouds[0]._type, "sensor_msgs/PointCloud2")
        self.assertEqual(next(m.message for m in messages if m.topic == "/imu").angular_velocity.z, 0.5)
        return messages

    def test_a_folder_of_mcap(self):
        messages = self.check(self.record("mcap"), {"/points", "/livox", "/imu"})
        livox = next(m.message for m in messages if m.topic == "/livox")
        self.assertEqual(livox._type, "livox_ros_driver2/CustomMsg")
        self.assertEqual((livox.points[19].x, livox.points[19].offset_time), (20.0, 19))

    def test_a_single_file(self):
        recording = self.record("mcap")
        self.check(next(recording.glob("*.mcap")), {"/points", "/livox", "/imu"})

    def test_a_folder_of_db3(self):
        self.check(self.record("sqlite3"), {"/points", "/livox", "/imu"})

    def test_says_what_is_wrong_with_its_arguments(self):
        (self.folder / "there.bag").touch()
        for arguments, message in [(("none", "a.bag"), "there is no 'none'"),
                                   ((self.folder, "a.mcap"), "has to end in .bag"),
                                   ((self.folder, self.folder / "there.bag"), "exists")]:
            refused = run(CONVERT, *arguments)
            self.assertEqual(refused.returncode, 1)
            self.assertIn(message, refused.stderr)


if __name__ == "__main__":
    unittest.main()
