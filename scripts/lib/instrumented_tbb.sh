# shellcheck shell=bash
# SPDX-License-Identifier: MIT
# oneTBB under the thread sanitizer. Sourced, never run.

# Package lists of the distribution's sources, which may be configured for programs alone.
source_lists() {
  local list
  for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [[ ! -f "$list" ]] || sed -E 's/^deb /deb-src /' "$list" >"$1/$(basename "$list")"
  done
  for list in /etc/apt/sources.list.d/*.sources; do
    [[ ! -f "$list" ]] || sed -E 's/^Types:.*/Types: deb-src/' "$list" >"$1/$(basename "$list")"
  done
}

# instrumented_tbb FOLDER: builds the installed version there, from the distribution's source, into
# FOLDER/build/tbb_release. As it is installed, the sanitizer does not see how it hands over tasks, and
# takes what they do for races.
instrumented_tbb() {
  local folder="$1" package
  [[ ! -e "$folder/build/tbb_release/libtbb.so" ]] || return 0
  rm -rf "$folder"
  mkdir -p "$folder"/{lists,indices/partial,source,build}
  source_lists "$folder/lists"
  local apt=(apt-get -q -o Dir::Etc::SourceList=/dev/null -o "Dir::Etc::SourceParts=$folder/lists"
    -o "Dir::State::Lists=$folder/indices")
  package="$(dpkg-query -W -f '${source:Package}=${source:Version}' libtbb-dev)"
  "${apt[@]}" update
  (cd "$folder" && "${apt[@]}" source --download-only "$package")
  tar -xf "$folder"/*.orig.tar.* -C "$folder/source" --strip-components=1
  grep -q TBB_SANITIZE "$folder/source/cmake/sanitize.cmake" ||
    fail "the thread sanitizer needs oneTBB, from 2021 on: $package is older"
  cmake -S "$folder/source" -B "$folder/build" -DCMAKE_BUILD_TYPE=Release -DTBB_SANITIZE=thread \
    -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBB_OUTPUT_DIR_BASE=tbb
  cmake --build "$folder/build" --target tbb -- "-j${JOBS:-2}"
}
