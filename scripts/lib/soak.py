#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What scripts/soak does once there is a drive: see there."""

from __future__ import annotations

import argparse
import os
import random
import shutil
import signal
import socket
import struct
import subprocess
import sys
import threading
import time
from collections import Counter
from pathlib import Path
from typing import Any, Callable, Dict, List, Optional

import numpy
import rosbag
import rosgraph
import rospy
from diagnostic_msgs.msg import DiagnosticArray
from dynamic_reconfigure.msg import Config, DoubleParameter
from dynamic_reconfigure.srv import Reconfigure
from sensor_msgs.msg import PointCloud2
from std_msgs.msg import String
from std_srvs.srv import Trigger

SCANS_IN_AN_HOUR = 36000
PHASES = ("sessions", "laps", "rest")  # of the life of a process, which ends with a kill
SCANS_OF_RECOVERY = 20  # in two seconds
PATIENCE = 120.0  # s, for what was sent to be accounted for


class ProcessEnded(RuntimeError):
    """Without having been killed."""


class SentCloud(PointCloud2):
    """A cloud that is sent as the bytes that it is."""

    def __init__(self, raw: bytes) -> None:
        super().__init__()
        self.raw = raw

    def serialize(self, buff: Any) -> None:
        buff.write(self.raw)


class Drive:
    """The scans of a bag, there and back again without end."""

    def __init__(self, path: Path) -> None:
        with rosbag.Bag(str(path)) as bag:
            topics = bag.get_type_and_topic_info()[1]
            topic = next(t for t, info in topics.items() if info.msg_type == "sensor_msgs/PointCloud2")
            self.scans = [raw[1] for _, raw, _ in bag.read_messages([topic], raw=True)]
        self.next = 0
        self.is_at_rest = False
        self.passed = 0  # scans, at rest or not
        self.nanoseconds = 1_700_000_000 * 10**9

    @property
    def hours(self) -> float:
        return self.passed / SCANS_IN_AN_HOUR

    def skip(self, scans: int = 1) -> bytes:
        """The scan that comes next, with its stamp."""
        turn = 2 * len(self.scans) - 2
        place = self.next % turn
        scan = self.scans[place if place < len(self.scans) else turn - place]
        self.next += 0 if self.is_at_rest else scans
        self.passed += scans
        self.nanoseconds += scans * 100_000_000
        return scan[:4] + struct.pack("<II", *divmod(self.nanoseconds, 10**9)) + scan[12:]


def data_begins(scan: bytes) -> int:
    """Where the length of the data is, in a cloud as it is sent."""
    at = 16 + struct.unpack_from("<I", scan, 12)[0] + 8
    fields = struct.unpack_from("<I", scan, at)[0]
    at += 4
    for _ in range(fields):
        at += 4 + struct.unpack_from("<I", scan, at)[0] + 9
    return at + 1 + 8


class Odometry:
    """What the diagnostics tell of the odometry."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.values: Dict[str, str] = {}
        self.errors: Counter = Counter()
        rospy.Subscriber("/diagnostics", DiagnosticArray, self.take, queue_size=100)

    def take(self, array: DiagnosticArray) -> None:
        with self.lock:
            for status in array.status:
                if status.level == 2:
                    self.errors[status.message] += 1
                if status.name.endswith(": odometry"):
                    self.values = {value.key: value.value for value in status.values}

    def forget(self) -> None:
        with self.lock:
            self.values = {}

    def number(self, key: str) -> int:
        with self.lock:
            return int(self.values.get(key, "0"))

    def unaccounted(self, sent: int) -> int:
        """Scans of which nothing is known."""
        with self.lock:
            values = dict(self.values)
        known = sum(
            int(value)
            for key, value in values.items()
            if key.startswith("scans dropped, ")
            or key in ("scans processed", "messages joined to sweeps", "scans held until the next")
        )
        received = int(values.get("scans received", "0"))
        return abs(sent - received) + abs(received - known)

    def p99(self) -> Optional[float]:
        with self.lock:
            text = self.values.get("time of a scan: median, p99, largest (ms)", "")
        return float(text.split(", ")[1]) if ", " in text else None


class Soak:
    def __init__(self, arguments: argparse.Namespace) -> None:
        self.arguments = arguments
        self.random = random.Random(arguments.seed)
        self.drive = Drive(arguments.bag)
        self.work = arguments.work / "run"
        shutil.rmtree(self.work, ignore_errors=True)
        self.folder = self.work / "maps"
        self.folder.mkdir(parents=True)
        self.counts: Counter = Counter()
        self.lost_scans = 0
        self.verdict = ""
        self.sent = 0  # since the account began
        self.memory: List[List[float]] = []  # hours of the drive, MB; since the phase began
        self.slopes: Dict[str, List[float]] = {phase: [] for phase in PHASES}  # MB an hour
        self.peak = 0.0  # MB
        self.p99s: List[float] = []
        self.log = open(self.work / "slam.log", "wb")
        self.slam: Optional[subprocess.Popen] = None
        self.master: Optional[subprocess.Popen] = None

    # The processes.

    def start_master(self) -> None:
        with socket.socket() as free:
            free.bind(("localhost", 0))
            port = free.getsockname()[1]
        os.environ["ROS_MASTER_URI"] = f"http://localhost:{port}"
        self.master = subprocess.Popen(
            ["roscore", "-p", str(port)], stdout=self.log, stderr=self.log, start_new_session=True
        )
        while not rosgraph.is_master_online():
            time.sleep(0.1)
        parameters = self.work / "soak.yaml"
        parameters.write_text(
            "input: {time_field: none}\nlive: {diagnostics_period: 0.2}\n"
            "mapping: {submap: {displacement: 20.0}}\n"
        )
        self.command = ["roslaunch", "revisit_slam", "slam.launch", "points:=/points"]
        self.command += ["base_frame:=none", f"folder:={self.folder}", f"params:={parameters}"]

    def start(self) -> None:
        self.odometry.forget()
        self.sent = 0
        self.memory = []
        self.slam = subprocess.Popen(
            self.command, stdout=self.log, stderr=self.log, start_new_session=True
        )
        self.wait(lambda: self.publisher.get_num_connections() > 0, "the odometry")
        for service in ("/odometry/reset", "/back_end/save", "/back_end/finish"):
            rospy.wait_for_service(service, PATIENCE)
        self.wait(lambda: bool(self.odometry.values), "diagnostics")

    def take_verdict(self, verdict: String) -> None:
        self.verdict = verdict.data

    def manager(self) -> int:
        node = rosgraph.Master("/soak").lookupNode("/revisit_slam_manager")
        import xmlrpc.client

        return int(xmlrpc.client.ServerProxy(node).getPid("/soak")[2])

    def wait(self, condition: Callable[[], bool], what: str) -> bool:
        end = time.time() + PATIENCE
        while time.time() < end:
            if condition():
                return True
            if self.slam.poll() is not None and what != "the end":
                raise ProcessEnded(f"the process has ended, see {self.work}/slam.log")
            time.sleep(0.05)
        return False

    # What is sent.

    def send(self, scan: bytes, at_once: bool = False) -> None:
        self.publisher.publish(SentCloud(scan))
        self.sent += 1
        self.counts["scans sent"] += 1
        if not at_once:
            time.sleep(1.0 / self.arguments.rate)

    def send_block(self) -> None:
        for _ in range(self.arguments.block):
            self.send(self.drive.skip())

    def settle(self) -> None:
        """Waits until every scan is accounted for, and takes note. An odometry that does not catch
        up is no scan lost, but worth a look: it is ended, and another one started."""
        is_settled = self.wait(
            lambda: self.odometry.number("scans waiting") == 0
            and self.odometry.unaccounted(self.sent) == 0,
            "the account",
        )
        if not is_settled and self.odometry.number("scans waiting") > 0:
            self.counts["times behind"] += 1
            print(f"behind for {PATIENCE:.0f} s, and ended: {self.odometry.values}", flush=True)
            return self.kill()
        if not is_settled:
            missing = self.odometry.unaccounted(self.sent)
            self.lost_scans += missing
            print(f"unaccounted: {missing} of {self.sent}: {self.odometry.values}", flush=True)
        resident = 0.0
        for line in Path(f"/proc/{self.manager()}/status").read_text().splitlines():
            if line.startswith("VmRSS:"):
                resident = int(line.split()[1]) / 1e3
        self.memory.append([self.drive.hours, resident])
        self.peak = max(self.peak, resident)
        if self.odometry.p99() is not None:
            self.p99s.append(self.odometry.p99())

    # What happens.

    def loss(self) -> None:
        self.drive.skip(self.random.randint(2, 30))

    def repeats(self) -> None:
        scan = self.drive.skip()
        for _ in range(self.random.randint(2, 5)):
            self.send(scan)

    def nan(self) -> None:
        for _ in range(self.random.randint(1, 20)):
            scan = self.drive.skip()
            begin = data_begins(scan) + 4
            self.send(scan[:begin] + b"\xff" * (len(scan) - begin - 1) + b"\0")

    def garbage(self) -> None:
        scan = self.drive.skip()
        begin = data_begins(scan)
        self.send(scan[:begin] + struct.pack("<I", 4_000_000_000) + scan[begin + 4 :])
        self.send(scan[: self.random.randrange(16, len(scan))])

    def overload(self) -> None:
        """Two seconds of driving later the poses are good again."""
        for _ in range(300):
            self.send(self.drive.skip(), at_once=True)
        self.settle()
        for _ in range(SCANS_OF_RECOVERY):
            self.send(self.drive.skip())
        self.settle()
        self.send(self.drive.skip())
        self.settle()
        if self.verdict not in ("good", "weak"):
            self.counts["times not recovered"] += 1
            print(f"{self.verdict} 2 s after an overload", flush=True)

    def outage(self) -> None:
        self.drive.nanoseconds += self.random.randint(1, 60) * 10**9

    def clock(self) -> None:
        self.drive.nanoseconds -= self.random.randint(10, 1000) * 10**9

    def reset(self) -> None:
        rospy.ServiceProxy("/odometry/reset", Trigger)()
        self.send(self.drive.skip())
        self.wait(lambda: self.odometry.number("scans received") == 1, "the reset")
        self.sent = 1

    def finish(self) -> None:
        rospy.ServiceProxy("/back_end/finish", Trigger)()

    def save(self) -> None:
        from revisit_slam.srv import DisableLoop, SaveMap

        name = self.random.choice(["saved", "../saved", "/proc/saved", "a/b", str(self.folder), "x" * 5000])
        rospy.ServiceProxy("/back_end/save", SaveMap)(folder=name)
        rospy.ServiceProxy("/back_end/disable_loop", DisableLoop)(loop=self.random.randint(0, 50))

    def parameters(self) -> None:
        reconfigure = rospy.ServiceProxy("/odometry/odometry/set_parameters", Reconfigure)
        for value in (self.random.choice([-1.0, 1e9, float("nan")]), 100.0):
            reconfigure(Config(doubles=[DoubleParameter("max_range", value)]))

    def remove(self) -> None:
        """The folder of the session that runs is removed; what is in memory is written anew."""
        sessions = sorted(self.folder.glob("*/session.yaml"), key=lambda path: path.stat().st_mtime)
        if sessions:
            shutil.rmtree(sessions[-1].parent, ignore_errors=True)

    def kill(self) -> None:
        os.kill(self.manager(), signal.SIGKILL)
        self.wait(lambda: self.slam.poll() is not None, "the end")
        self.counts["kill"] += 1
        self.check_sessions()
        self.start()

    def kill_on_the_way(self) -> None:
        self.drive.is_at_rest = False
        for _ in range(self.random.randint(1, 5 * self.arguments.block)):
            self.send(self.drive.skip())
        self.kill()

    # What is left.

    def note_slope(self, phase: str) -> None:
        """Of the last two thirds of a phase: the first one fills what is reused afterwards."""
        tail = numpy.array(self.memory[len(self.memory) // 3 :])
        if len(tail) >= 10:
            self.slopes[phase].append(float(numpy.polyfit(tail[:, 0], tail[:, 1], 1)[0]))
        self.memory = []

    def check_sessions(self) -> None:
        """Every session can be exported; then it has done its duty."""
        for session in sorted(self.folder.rglob("session.yaml")):
            out = self.work / "export"
            shutil.rmtree(out, ignore_errors=True)
            done = subprocess.run(
                [self.arguments.programs / "export", session.parent, "--out", out, "--quiet"],
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
            )
            self.counts["sessions checked"] += 1
            if done.returncode != 0 or b"damaged" in done.stdout:
                self.counts["sessions broken"] += 1
                print(f"broken: {session.parent}: {done.stdout.decode()}", flush=True)
            else:
                shutil.rmtree(session.parent)

    def run_phase(self, phase: str, hours: float) -> None:
        events: List[Callable[[], None]] = [self.loss, self.repeats, self.nan, self.garbage]
        events += [self.overload, self.outage, self.finish, self.save, self.parameters, self.remove]
        if phase == "sessions":  # these two begin another one
            events += [self.clock, self.reset]
        self.drive.is_at_rest = phase == "rest"
        queue: List[Callable[[], None]] = []
        end = self.drive.hours + hours
        while self.drive.hours < end:
            self.send_block()
            self.settle()
            if not queue:  # each of them in turn, in another order each time
                queue = self.random.sample(events, len(events))
            event = queue.pop()
            self.counts[event.__name__] += 1
            event()
        self.note_slope(phase)

    def begin(self) -> None:
        self.start_master()
        rospy.init_node("soak", anonymous=True, disable_signals=True, log_level=rospy.FATAL)
        self.odometry = Odometry()
        self.publisher = rospy.Publisher("/points", PointCloud2, queue_size=10000)
        rospy.Subscriber("/pose_verdict", String, self.take_verdict)
        self.start()

    def run(self) -> int:
        lives = max(1, round(self.arguments.hours / self.arguments.life))
        for life in range(lives):
            if life > 0:
                self.kill_on_the_way()
            for phase in PHASES:
                self.run_phase(phase, self.arguments.hours / lives / len(PHASES))
                print(f"life {life + 1}, {phase}: {self.drive.hours:.2f} h, {self.state()}", flush=True)
        self.send_block()
        self.settle()
        os.kill(self.slam.pid, signal.SIGINT)
        self.wait(lambda: self.slam.poll() is not None, "the end")
        self.check_sessions()
        return self.report()

    def state(self) -> str:
        memory = ", ".join(
            f"{phase} " + " ".join(f"{slope:.1f}" for slope in slopes)
            for phase, slopes in self.slopes.items()
            if slopes
        )
        return f"{self.lost_scans} unaccounted, MB/h: {memory or 'too short to tell'}"

    def report(self) -> int:
        quarter = max(1, len(self.p99s) // 4)
        first, last = (numpy.median(p99s or [0.0]) for p99s in (self.p99s[:quarter], self.p99s[-quarter:]))
        broken = self.counts["sessions broken"]
        print(f"hours of the drive    {self.drive.hours:.2f}")
        print(f"scans                 {self.counts['scans sent']} sent, {self.state()}")
        print(f"memory                {self.peak:.0f} MB at most")
        print(f"p99 of a scan         {first:.1f} -> {last:.1f} ms")
        print(f"never caught up       {self.counts['times behind']} times")
        print(f"not good after 2 s    {self.counts['times not recovered']} of {self.counts['overload']} overloads")
        print(f"sessions              {self.counts['sessions checked']} checked, {broken} broken")
        happened = {k: v for k, v in self.counts.items() if " " not in k}
        print("events                " + ", ".join(f"{k} {v}" for k, v in sorted(happened.items())))
        for message, count in self.odometry.errors.most_common(5):
            print(f"diagnosed {count} times   {message}")
        return 1 if self.lost_scans or broken or self.counts["times not recovered"] else 0

    def stop(self) -> None:
        for process in (self.slam, self.master):
            if process and process.poll() is None:
                os.killpg(process.pid, signal.SIGTERM)
                try:
                    process.wait(20.0)
                except subprocess.TimeoutExpired:
                    os.killpg(process.pid, signal.SIGKILL)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    add = parser.add_argument
    add("--bag", type=Path, required=True)
    add("--programs", type=Path, required=True)
    add("--work", type=Path, required=True)
    add("--hours", type=float, default=10.0, help="of the drive, at 10 scans a second")
    add("--minutes", type=float, help="likewise")
    add("--life", type=float, help="of a process, in hours; a kill ends it (default: half of all)")
    add("--rate", type=float, default=40.0, help="scans a second")
    add("--block", type=int, default=100, help="scans between two events")
    add("--seed", type=int, default=1, help="of what happens")
    arguments = parser.parse_args()
    if arguments.minutes is not None:
        arguments.hours = arguments.minutes / 60.0
    arguments.life = arguments.life or arguments.hours / 2
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))  # leaves nothing behind
    soak = Soak(arguments)
    try:
        soak.begin()
        try:
            status = soak.run()
        except (KeyboardInterrupt, SystemExit):
            print("interrupted:", flush=True)
            soak.report()
            status = 128 + signal.SIGINT
    except ProcessEnded as error:
        print(f"error: {error}", flush=True)
        status = 1
    finally:
        soak.stop()
    sys.exit(status)


if __name__ == "__main__":
    main()
