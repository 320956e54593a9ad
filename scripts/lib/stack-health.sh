# shellcheck shell=bash disable=SC2154 # variables of the sourcing script
# How a stack's services are: what supervisor knows of their processes, joined with what they say of themselves on the
# bus. To be sourced after bus.sh and supervision.sh; works on scripts/stack's variables.

listen_s=1.6 # every service speaks once a second, later on a busy host
settle_s=2   # for services that wait for others, where that is no failure

# remember_bus: notes for later calls where the services of this stack can be heard, from this call's options.
remember_bus() { printf '%s\n' "${lcm_url:-$default_lcm_url}" "$build_dir" "$profile" >"$runtime_dir/bus"; }

# note_bus: sets bus_url, census (the executable; empty when there is none, or no bus that others can hear) and
# stack_profile. Options that restart the whole stack move it.
note_bus() {
  local build
  if [[ $options_given == yes && $action == restart && ${#services[@]} == 0 ]]; then
    local profile
    profile=$(sed -n 3p "$runtime_dir/bus")
    remember_bus
  fi
  { read -r bus_url && read -r build && read -r stack_profile; } <"$runtime_dir/bus" || true
  census=$build/bin/bus-census
  [[ $bus_url == udpm://* && -x $census ]] || census=''
}

# process_of SERVICE: RUNNING, STARTING, BACKOFF, STOPPED, EXITED, FATAL, or nothing when the stack does not have it.
process_of() { supervise states "$1" | jq -r .state; }

# await_ready start|restart SERVICE...: does it, waits until they are ready, and says how it went; returns 1 if one does
# not run or is not ready.
await_ready() {
  local action=$1 settle=$patience command=() service process ready heard text failed=no
  shift
  note_bus
  # A part of the stack cannot help what the others do not send.
  if [[ $may_wait == yes ]]; then
    settle=0
  elif [[ $services_named == yes || $stack_profile == replay ]]; then
    settle=$settle_s
  fi
  if [[ -n $census ]]; then
    command=(-- "$census" --lcm-url "$bus_url" --for $((${patience%.*} + 5)) --follow)
  fi
  local ready_ones=() waiting=() lines line
  # All that this call changes is written: who stops the stack must not wait until it is ready.
  flock -u 9
  lines=$(supervise "$action" "$patience" "$settle" "$@" "${command[@]}" 9>&-) || return 1
  while IFS=$'\t' read -r service process ready heard text; do
    if [[ $ready == true ]]; then
      ready_ones+=("$service")
    elif [[ $process != RUNNING && $process != STARTING ]]; then
      failed=yes
      warn "$service does not run ($process); the end of $log_dir/$service.log:"
      tail -n 3 -- "$log_dir/$service.log" >&2 || true
    elif [[ $heard == false ]]; then
      failed=yes
      warn "$service runs but says nothing on the bus $bus_url: not ready after $patience s; see scripts/stack logs $service"
    elif [[ $settle == "$patience" || $text == starting* ]]; then
      failed=yes
      warn "$service runs but is not ready: $text"
    else
      waiting+=("$service ($text)")
    fi
  done < <(jq -r '[.name, .state, .ready, .heard,
    (.says // "") + (if (.reason // "") == "" then "" else ": " + .reason end)] | @tsv' <<<"$lines")
  if ((${#ready_ones[@]} > 0)); then
    if ((${#command[@]} > 0)); then say "ready: ${ready_ones[*]}"; else say "running: ${ready_ones[*]}"; fi
  fi
  for line in "${waiting[@]}"; do say "runs, and waits for others: $line"; done
  [[ $failed == no ]]
}

# last_complaints: for each log its service, a tab and the newest warning or error in it, where there is one.
last_complaints() {
  local file
  for file in "$log_dir"/*.log; do
    tail -n 500 -- "$file" 2>/dev/null | tr -d '\t' | grep -aE '^[0-9:.]+ [a-z0-9-]+ (warning|error|critical) ' |
      tail -n 1 | awk '{ print $2 "\t" $0 }' || true
  done
}

# status: see scripts/stack's usage.
status() {
  local heard='' processes='' complaints report verdict listener=''
  if [[ -S $runtime_dir/supervisor.sock ]]; then
    log_dir=$(readlink -- "$runtime_dir/logs")
    note_bus
    # Only descriptors wait for it: what it prints is read once the rest is known.
    if [[ -n $census ]]; then
      exec {listener}< <("$census" --lcm-url "$bus_url" --for "$listen_s" --json)
    fi
    complaints=$(last_complaints)
    if [[ -n $listener ]]; then heard=$(cat <&"$listener"); fi
    processes=$(supervise states "${services[@]}" 2>/dev/null) || processes=''
  fi
  if [[ -z $processes ]]; then
    if [[ $json == yes ]]; then say '{"stack":null}'; else say "no stack runs in $runtime_dir"; fi
    return 3
  fi
  report=$(jq -rs --argjson heard "${heard:-null}" --arg complaints "$complaints" --arg json "$json" \
    -f "$repository/scripts/lib/stack-status.jq" <<<"$processes")
  verdict=${report%%$'\n'*}
  report=${report#*$'\n'}
  if [[ $json == yes ]]; then
    say "$report"
  else
    awk -F '\t' '{ line = sprintf("%-18s %-9s %8s %9s  %-12s %6s %7s %5s %7s %7s %7s  %s",
      $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12); sub(/ +$/, "", line); print line }' <<<"$report"
    if [[ -z $heard ]]; then say "nobody was listened to: supervisor's words only"; fi
  fi
  [[ $verdict == well ]]
}

# show_logs logs|tail: see scripts/stack's usage.
show_logs() {
  local folder service files=()
  folder=${log_dir:-$(readlink -- "$runtime_dir/logs" || printf '%s\n' "$repository/logs/stack")}
  if ((${#services[@]} == 0)); then
    mapfile -t services < <(find "$folder" -maxdepth 1 -name '*.log' ! -name supervisord.log -printf '%f\n' 2>/dev/null |
      sed 's/\.log$//' | sort)
    ((${#services[@]} > 0)) || fail "no logs in $folder"
  fi
  for service in "${services[@]}"; do
    [[ -f $folder/$service.log ]] || fail "$folder/$service.log: no such file; scripts/stack start writes it"
    files+=("$folder/$service.log")
  done
  if [[ $1 == tail ]]; then exec tail -n "$lines" -F -- "${files[@]}"; fi
  tail -n "$lines" -- "${files[@]}"
}
