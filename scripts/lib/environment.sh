# shellcheck shell=bash
# SPDX-License-Identifier: MIT
# What setup, test and demo share. Sourced, never run.

ROOT="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)"
BUILD="$ROOT/build"
LOGS="$BUILD/logs"

# Another Python in front (pyenv and the like) has no catkin_pkg and breaks CMake and rostest.
export PATH="/usr/bin:/bin:/usr/sbin:/sbin:$PATH"
# Redirected INFO lines would otherwise appear only at exit.
export ROSCONSOLE_STDOUT_LINE_BUFFERED=1

fail() {
  echo "error: $*" >&2
  exit 1
}

# Workspace set-up files read variables that may be unset.
source_workspace() {
  [[ -f "$1" ]] || fail "$1 is missing: run scripts/setup"
  set +u
  # shellcheck disable=SC1090
  source "$1"
  set -u
}

as_root() {
  if [[ "$(id -u)" == 0 ]]; then
    "$@"
  else
    command -v sudo >/dev/null || fail "sudo is needed to install packages"
    sudo "$@"
  fi
}

missing_packages() {
  local package
  for package in "$@"; do
    [[ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" == installed ]] ||
      echo "$package"
  done
}

apt_get() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=600 \
    -o Acquire::Retries=3 "$@"
}

# Nodes of a test or a demo must find each other whatever this machine calls itself.
use_local_master() {
  export ROS_MASTER_URI=http://localhost:11311
  export ROS_HOSTNAME=localhost
  export ROS_LOG_DIR="$LOGS/ros"
  unset ROS_IP
  mkdir -p "$ROS_LOG_DIR"
}

seconds_since() {
  printf '%d.%01d s' "$((($(date +%s%N) - $1) / 1000000000))" \
    "$((($(date +%s%N) - $1) / 100000000 % 10))"
}

# Passes on a sign of life from a build's "[ 42%]" lines: long silence makes people and CI give up.
show_progress() {
  local line next=20
  while IFS= read -r line; do
    if [[ "$line" =~ ^\[\ *([0-9]+)%\] ]] && ((BASH_REMATCH[1] >= next)); then
      printf '%d%% ' "${BASH_REMATCH[1]}"
      next=$((BASH_REMATCH[1] / 20 * 20 + 20))
    fi
  done
}

# step NAME COMMAND...: runs into a log file, says how long it took, shows the log's end on failure.
step() {
  local name="$1" log="$LOGS/$1.log" start
  shift
  mkdir -p "$LOGS"
  start="$(date +%s%N)"
  printf '%-12s' "$name"
  if "$@" </dev/null 2>&1 | tee "$log" | show_progress; then
    echo "done in $(seconds_since "$start")"
  else
    echo "FAILED after $(seconds_since "$start"); the end of $log:"
    tail -n 40 "$log"
    exit 1
  fi
}
