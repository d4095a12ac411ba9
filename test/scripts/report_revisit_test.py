# SPDX-License-Identifier: MIT
"""The cut of the report, through a street with a wall on the left that is driven through twice."""

import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts/lib"))
from report_revisit import most_corrected_cut  # noqa: E402
from trajectories import Trajectory  # noqa: E402

COUNT = 21  # scans of a pass, a metre apart, one a second
DRIFT = np.array([0.0, 0.5, 1.0])  # m, of the second pass by odometry


def track(drift):
    """Along x and, 100 s later, along x once more; headings as they are."""
    way = np.column_stack([np.arange(COUNT), np.zeros((COUNT, 2))]).astype(float)
    stamps = np.concatenate([np.arange(COUNT), 100 + np.arange(COUNT)]).astype(float)
    return Trajectory(stamps, np.vstack([way, way + drift]), np.tile([0.0, 0, 0, 1], (2 * COUNT, 1)))


def wall():
    """In the frame of either submap, 5 m to the left and 3 m high."""
    x, z = np.meshgrid(np.arange(0.0, 20.0, 0.05), np.arange(0.0, 3.0, 0.1))
    return np.column_stack([x.ravel(), np.full(x.size, 5.0), z.ravel()])


class ReportRevisit(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "submaps").mkdir()
        self.write_session(0)
        for submap in (0, 1):
            self.write_wall(submap, wall())
        self.write("loop_closures.csv", "state,target_submap,source_submap\nrejected,0,0\nactive,0,1\n")
        self.tracks = {"odometry": track(DRIFT), "trajectory": track(np.zeros(3))}

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def write_session(self, session):
        self.write("submaps/submaps.csv", f"submap,stamp,session\n0,0.0,0\n1,100.0,{session}\n")

    def write_wall(self, submap, points):
        lines = "\n".join(" ".join(f"{value:.3f}" for value in point) for point in points)
        self.write(f"submaps/{submap:06d}.pcd",
                   f"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nPOINTS {len(points)}\nDATA ascii\n{lines}\n")

    def test_the_passes_agree_in_the_map_and_not_by_odometry(self):
        cut = most_corrected_cut(self.folder, self.tracks)
        self.assertEqual(cut.submaps, (0, 1))
        self.assertAlmostEqual(cut.moved, np.linalg.norm(DRIFT), places=6)
        for points in (cut.first, cut.second):
            np.testing.assert_allclose(points[:, 0], 5.0, atol=1e-6)
            self.assertAlmostEqual(points[:, 1].min(), 0.0, places=6)
        np.testing.assert_allclose(cut.second_by_odometry[:, 0], 5.5, atol=1e-6)
        self.assertAlmostEqual(cut.second_by_odometry[:, 1].min(), 1.0, places=6)

    def test_a_live_session_has_no_odometry_to_compare_with(self):
        cut = most_corrected_cut(self.folder, {"trajectory": self.tracks["trajectory"]})
        self.assertIsNone(cut.second_by_odometry)
        self.assertEqual(len(cut.first), len(cut.second))

    def test_no_cut_where_little_was_seen_or_sessions_are_several(self):
        self.write_wall(1, wall()[:10])
        self.assertIsNone(most_corrected_cut(self.folder, self.tracks))
        self.write_wall(1, wall())
        self.write_session(1)
        self.assertIsNone(most_corrected_cut(self.folder, self.tracks))
        (self.folder / "loop_closures.csv").unlink()
        self.assertIsNone(most_corrected_cut(self.folder, self.tracks))


if __name__ == "__main__":
    unittest.main()
