# shellcheck shell=bash
# SPDX-License-Identifier: MIT
# Copies of the repository. Sourced, never run.

# Of the work tree, without what was built: what git knows, or everything where there is no git.
source_files() {
  local file
  if git -C "$ROOT" rev-parse --git-dir >/dev/null 2>&1; then
    git -C "$ROOT" ls-files --cached --others --exclude-standard --deduplicate |
      while IFS= read -r file; do
        [[ ! -e "$ROOT/$file" ]] || echo "$file"
      done
  else
    (cd "$ROOT" && find . \( -path ./build -o -path ./devel -o -path ./demo -o -path ./.git \) -prune -o -type f -print)
  fi
}

# copy_sources FOLDER: what was built in FOLDER stays.
copy_sources() {
  mkdir -p "$1"
  find "$1" -mindepth 1 -maxdepth 1 ! -name build ! -name devel ! -name demo -exec rm -rf {} +
  source_files | tar -C "$ROOT" -cf - -T - | tar -C "$1" -xf -
}
