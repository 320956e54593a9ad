# shellcheck shell=bash disable=SC2154 # variables of the sourcing script
# Whether services may be started on a bus: a second simulator would move the arm that another holds. To be sourced after
# bus.sh and, for require_room, launch.sh.

# who_is_in_the_way CENSUS URL OPTION...: one line for each who writes already what one of the services alone may write;
# nothing where there is room, or where there is no bus (the services say why). OPTION as of bus-census: --room-for
# SERVICE,... [--robot NAME] [--own PID,... [--own-sessions SESSION,...]].
who_is_in_the_way() {
  local status=0 lines
  lines=$("$1" ${2:+--lcm-url "$2"} --for 1.2 "${@:3}" 2>/dev/null) || status=$?
  case $status in
    1) printf '%s\n' "${lines:-$1 failed}" ;;
    0 | 3) ;;
    2) printf '%s\n' "$1 is not of this version: run $get_programs" ;;
    *) printf '%s\n' "nobody can tell who writes there: $1 ended with $status" ;;
  esac
}

# require_room SERVICE...: ends, with the plan forgotten, when somebody outside of this stack writes already what these
# services, as planned, would write. What the stack itself has started, and a restart replaces, is no obstacle, nor is a
# bus-bridge.
require_room() {
  local service where own sessions='' lines tool url robot
  local -A options=() services_there=()
  for service; do
    options=()
    load_options "$runtime_dir/options.new/$service" options
    where=${options[build_dir]}/bin/bus-census$'\n'${options[lcm_url]:-$default_lcm_url}$'\n'${options[robot]}
    services_there[$where]+=${services_there[$where]:+,}$service
  done
  own=$(processes | paste -sd ,) || true
  # What watches over the stack has heard for longer than is listened now.
  if [[ -n $own && -S $runtime_dir/watch.sock ]]; then
    sessions=$("$repository/scripts/lib/read-socket" "$runtime_dir/watch.sock" | jq -r --argjson own "[$own]" \
      '.host as $host | [.services[] | select(.host == $host and (.pid | IN($own[]))).session] | unique | join(",")') || sessions=''
  fi
  for where in "${!services_there[@]}"; do
    { read -r tool && read -r url && read -r robot; } <<<"$where" || true
    if [[ ! -x $tool ]] || ! is_multicast "$url"; then continue; fi
    lines=$(who_is_in_the_way "$tool" "$url" --robot "$robot" --room-for "${services_there[$where]}" ${own:+--own "$own"} \
      ${sessions:+--own-sessions "$sessions"})
    if [[ -n $lines ]]; then
      forget_plan
      fail "on $url ${lines//$'\n'/; }: nothing was started (its own scripts/stack stop ends another stack; --robot NAME" \
        "keeps two robots apart)"
    fi
  done
}
