#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""MapClosures on local maps of benchmark_loops. Run by compare_places in a virtual environment.

Maps are handed over in the order of the drive and as its own pipeline does it: the points alone.
Then it levels nothing, and its poses are planar. Its best closure of each map is kept however few
its inliers are.
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path

import numpy as np
from map_closures.config import MapClosuresConfig
from map_closures.map_closures import MapClosures

from point_cloud_file import read_pcd


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--maps", type=Path, required=True, help="folder of NNNNNN.pcd")
    parser.add_argument("--out", type=Path, required=True, help="JSON file")
    arguments = parser.parse_args()

    config = MapClosuresConfig()
    peer = MapClosures(config)
    closures = []
    for path in sorted(arguments.maps.glob("*.pcd")):
        number = int(path.stem)
        points = read_pcd(path, 10**9).astype(np.float64)
        wall, cpu = time.perf_counter(), time.process_time()
        closure = peer.get_best_closure(number, points)
        wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
        closures.append(
            {
                "map": number,
                "source": closure.source_id,
                "target": closure.target_id,
                "inliers": closure.number_of_inliers,
                "pose": np.asarray(closure.pose).tolist(),
                "wall_ms": 1e3 * wall,
                "cpu_ms": 1e3 * cpu,
            }
        )
    result = {"config": config.model_dump(), "closures": closures}
    arguments.out.write_text(json.dumps(result, indent=1) + "\n")


if __name__ == "__main__":
    main()
