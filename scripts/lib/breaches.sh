# shellcheck shell=bash
# What the checks of the project's text share: its files, and how a breach is told. To be sourced after project.sh, by a
# script whose first argument, where there is one, is another copy of the project.

cd -- "${1:-$repository}" || exit
repository=$PWD
mapfile -t files < <(project_files .)
breaches=0

# matching REGEX: the project's files, on standard output, whose path matches.
matching() { printf '%s\n' "${files[@]}" | grep -E "$1" || true; }

# breach RULE: prints each line of standard input as a breach of RULE.
breach() {
  local line
  while IFS= read -r line; do
    printf '%s: %s\n' "$1" "$line"
    breaches=$((breaches + 1))
  done
}

# lines_with REGEX: file:line:text of every match in the files named on standard input.
lines_with() { xargs -r -d '\n' grep -HnIE -e "$1" -- || true; }

# end_of_check: exits 1 when there was a breach.
end_of_check() {
  ((breaches == 0)) || exit 1
  say "${#files[@]} files"
}
