# shellcheck shell=bash
# What the scripts share: where the project is, how they speak, and which packages are missing. To be sourced.

# The folder that holds CMakeLists.txt, whatever the current folder is.
# shellcheck disable=SC2034 # used by the scripts that source this file
repository=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
script_name=${0##*/}

# Where things are: programs in $programs, and in bin of what --build-dir names; settings; recordings and logs. And how
# to get what is missing. An installed tree, which has no sources, says otherwise (installed.sh, which CMake writes).
# shellcheck disable=SC2034 # as above
{
  installed=no
  default_build_dir=$repository/build/release
  default_config_dir=$repository/config
  logs_dir=$repository/logs
  get_programs='scripts/build release'
  get_this_version='git pull && scripts/build release && scripts/stack restart'
}
# get_packages NAME...: the command that installs these.
get_packages() { printf 'scripts/install\n'; }
# as_called_here TEXT: the text, with the names of commands and folders as they are here.
as_called_here() { printf '%s\n' "$1"; }
if [[ -f $repository/scripts/lib/installed.sh ]]; then
  # shellcheck source=/dev/null
  source "$repository/scripts/lib/installed.sh"
fi
# shellcheck disable=SC2034 # as above
programs=$default_build_dir/bin default_scene=$default_config_dir/scenes/shelf.yaml
if [[ ! -f $default_scene ]]; then default_scene=$repository/config/scenes/shelf.yaml; fi

# Numbers and times are read by programs: 1.5, never 1,5, whatever the language of who is here.
if [[ -n ${LC_ALL-} ]]; then
  export LANG=$LC_ALL
  unset LC_ALL
fi
export LC_NUMERIC=C LC_TIME=C LC_COLLATE=C

# say TEXT...: one line of progress on standard output.
say() { printf '%s\n' "$*"; }

# warn TEXT...: one line on standard error.
warn() { printf '%s: %s\n' "$script_name" "$(as_called_here "$*")" >&2; }

# explain: prints what is on standard input, a usage.
explain() { as_called_here "$(cat)"; }

# fail TEXT...: one line on standard error, then exit 1.
fail() {
  warn "$@"
  exit 1
}

# fail_with CODE TEXT...: as fail, with an exit code of its own.
fail_with() {
  local code=$1
  shift
  warn "$@"
  exit "$code"
}

# usage_error TEXT...: as fail, but with exit code 2 and a pointer to --help.
usage_error() {
  warn "$*; see scripts/$script_name --help"
  exit 2
}

# package_groups: the groups that the lists of packages have, one a line.
package_lists=("$repository/scripts/packages.txt")
package_groups() { sed -n 's/^\[\([a-z]*\)\].*/\1/p' "${package_lists[@]}"; }

# required_packages [GROUP...]: the names in the lists of packages, one a line: those of all groups where none is named, and
# those of no group. In an installed tree those that it cannot run without.
required_packages() {
  awk -v installed="$installed" -v groups=" $* " 'FNR == 1 { group = "" }
    { sub(/#.*/, "") }
    /^\[/ { group = substr($1, 2, length($1) - 2); next }
    NF && (groups == "  " || group == "" || index(groups, " " group " ")) && (installed == "no" || $2 == "Depends") {
      print $1 }' "${package_lists[@]}"
}

# missing_packages [GROUP...]: those of them that are not installed, one a line; nothing where dpkg does not exist. What
# another package provides is there: the nodejs of its makers brings npm, and Debian's npm cannot be installed beside it.
missing_packages() {
  command -v dpkg-query >/dev/null || return 0
  # shellcheck disable=SC2016 # dpkg's and awk's variables, not the shell's
  comm -23 <(required_packages "$@" | sort -u) \
    <(dpkg-query -W -f='${db:Status-Status}\t${Package}\t${Provides}\n' |
      awk -F '\t' '$1 == "installed" {
        print $2
        count = split($3, provided, /, */)
        for (i = 1; i <= count; ++i) { sub(/ .*/, "", provided[i]); print provided[i] }
      }' | sort -u)
}

# warn_of_missing_packages [GROUP...]: one line that names them and the command that mends it.
warn_of_missing_packages() {
  local missing
  missing=$(missing_packages "$@" | paste -sd ' ')
  if [[ -n $missing ]]; then
    warn "missing packages: $missing (${install_command:-scripts/install} installs them)"
  fi
}

# parallel_jobs: as many as there are cores, but no more than memory allows: a C++ job here takes up to 1.5 GiB.
parallel_jobs() {
  local cores available_kib by_memory
  cores=$(nproc)
  available_kib=$(awk '/^MemAvailable:/ { print $2 }' /proc/meminfo)
  by_memory=$((available_kib / (1536 * 1024)))
  if ((by_memory < 1)); then by_memory=1; fi
  printf '%d\n' $((cores < by_memory ? cores : by_memory))
}

# project_files [REGEX]: the project's own files, relative to $repository, whose path matches: what git tracks, and what is
# new and not ignored; in a copy without git all that is not built or recorded.
project_files() {
  local list
  list=$(git -C "$repository" ls-files --cached --others --exclude-standard 2>/dev/null) ||
    list=$(cd -- "$repository" &&
      find . -type d \( -name .git -o -path ./build -o -path ./logs \) -prune -o -type f -printf '%P\n')
  # A file that is tracked but was just deleted is not there to be read.
  grep -E -e "${1:-.}" <<<"$list" | while IFS= read -r file; do
    if [[ -f $repository/$file ]]; then printf '%s\n' "$file"; fi
  done
}
