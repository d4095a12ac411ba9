# SPDX-License-Identifier: MIT
"""Of the output of perf and valgrind, as they print it."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts/lib"))
import profile_tools as tools  # noqa: E402

PERF = """# Samples: 12K of event 'cpu-clock'
# Overhead  Symbol
    11.51%  [.] revisit_slam::PointMap::insert
     1.15%  [k] _copy_to_iter              -      -
"""

CALLGRIND = """--------------------------------------------------------------------------------
Ir
--------------------------------------------------------------------------------
2,000,000 (100.0%)  PROGRAM TOTALS

--------------------------------------------------------------------------------
Ir                    file:function
--------------------------------------------------------------------------------
900,000 (45.00%)  ???:revisit_slam::Odometry::commit() [/opt/offline]
800,000 (40.00%)  ???:revisit_slam::Odometry::commit()'2 [/opt/offline]
100,000 ( 5.00%)  ./src/a.cpp:revisit_slam::DetailMap::insert(std::vector<int, A<int> > const&) [/opt/offline]
 50,000 ( 2.50%)  ???:revisit_slam::Odometry::commitment() [/opt/offline]
"""


class ProfileToolsTest(unittest.TestCase):
    def test_perf(self):
        self.assertEqual(tools.functions_of_perf(PERF), [("revisit_slam::PointMap::insert", 11.51), ("_copy_to_iter", 1.15)])

    def test_callgrind(self):
        self.assertEqual(tools.total_of_callgrind(CALLGRIND), 2e6)
        stages = tools.stages_of_callgrind(CALLGRIND)
        self.assertEqual((stages["update map"], stages["detail"], stages["loops"]), (9e5, 1e5, 0.0))
        self.assertEqual(len(tools.functions_of_callgrind(CALLGRIND)), 4)
        with self.assertRaises(ValueError):
            tools.total_of_callgrind("nothing")

    def test_dhat(self):
        self.assertEqual(tools.allocations_of_dhat("==1== Total:     1,234 bytes in 56 blocks\n"), (1234, 56))
        self.assertIsNone(tools.allocations_of_dhat("==1== error"))

    def test_short_names(self):
        self.assertEqual(tools.short_name("revisit_slam::PointMap::insert(std::vector<int> const&) [/opt/offline]"), "PointMap::insert")
        self.assertEqual(tools.short_name("std::sort<revisit_slam::f(int)::{lambda(A<B>)#1}>::operator()"), "std::sort::operator")
        self.assertEqual(tools.short_name("tbb::body<revisit_slam::Chunks::forEach<revisit_slam::gatherProblem(A<B>)::{lambda()#1}>>"),
                         "gatherProblem")

    def test_stages_are_functions_of_the_sources(self):
        sources = "\n".join(path.read_text() for path in (ROOT / "src").rglob("*.cpp"))
        for names in tools.STAGES.values():
            for name in names:
                if name.startswith("revisit_slam::"):
                    own = name.split("(")[0].replace("revisit_slam::", "") + "("
                    self.assertTrue(own in sources, own)


if __name__ == "__main__":
    unittest.main()
