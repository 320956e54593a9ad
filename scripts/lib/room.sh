# shellcheck shell=bash disable=SC2154 # variables of the sourcing script
# Whether services may be started on a bus: a second simulator would move the arm that another holds. To be sourced after
# project.sh.

# who_is_in_the_way CENSUS URL OPTION...: one line for each who writes already what one of the services alone may write;
# nothing where there is room, or where nobody can listen (the services say why). OPTION as of bus-census: --room-for
# SERVICE,... [--robot NAME] [--own PID,...].
who_is_in_the_way() {
  local status=0 lines
  lines=$("$1" --lcm-url "$2" --for 1.2 "${@:3}" 2>/dev/null) || status=$?
  case $status in
    1) printf '%s\n' "${lines:-$1 failed}" ;;
    2) printf '%s\n' "$1 is not of this version: scripts/build makes it" ;;
  esac
}

# require_room SERVICE...: ends when somebody outside of this stack writes already what these services would write. What
# the stack itself has started, and a restart replaces, is no obstacle, nor is a bus-bridge. Works on scripts/stack's
# variables; note_bus or this call's options say which bus.
require_room() {
  local url=${lcm_url:-$default_lcm_url} tool=$build_dir/bin/bus-census prefix=$robot lines own options
  if is_running; then
    url=$bus_url tool=$census
    if [[ -z $prefix ]]; then prefix=$(robot_of_stack); fi
  fi
  [[ $url == udpm://* && -x $tool ]] || return 0
  own=$(processes | paste -sd ,) || true
  options=(--robot "$prefix" --room-for "$(IFS=,; printf '%s' "$*")")
  if [[ -n $own ]]; then options+=(--own "$own"); fi
  lines=$(who_is_in_the_way "$tool" "$url" "${options[@]}")
  [[ -z $lines ]] || fail "on $url ${lines//$'\n'/; }: nothing was started (its own scripts/stack stop ends another \
stack; --robot NAME keeps two robots apart)"
}

# robot_of_stack: the --robot that the stack's services were started with; nothing for none.
robot_of_stack() { { grep -ohE "'--robot' '[^']*'" "$runtime_dir"/launch/* 2>/dev/null || true; } | sed -n "1s/.* '\(.*\)'/\1/p"; }
