# shellcheck shell=bash disable=SC2154 # variables of the sourcing script
# How a stack's services are: what supervisor knows of their processes, joined with what they say of themselves on the
# bus. To be sourced after bus.sh and supervision.sh; works on scripts/stack's variables.

listen_s=1.6 # every service speaks once a second, later on a busy host
settle_s=2   # for services that wait for others, where that is no failure

# note_bus: sets bus_url, census (the executable; empty when there is none, or no bus that others can hear) and
# stack_profile, all as the whole stack was started.
note_bus() {
  local -A options=()
  stack_options options
  bus_url=${options[lcm_url]:-$default_lcm_url}
  stack_profile=${options[profile]}
  census=${options[build_dir]}/bin/bus-census
  if [[ ! -x $census ]] || ! is_multicast "$bus_url"; then census=''; fi
}

# process_of SERVICE: RUNNING, STARTING, BACKOFF, STOPPED, EXITED, FATAL, or nothing when the stack does not have it.
process_of() { supervise states "$1" | jq -r .state; }

# await_ready start|restart SERVICE...: does it, waits until they are ready, and says how it went; returns 1 if one does
# not run or is not ready.
await_ready() {
  local action=$1 settle=$patience command=() service process ready heard text failed=no
  shift
  note_bus
  if [[ $action == start && -n $(told_by "$bus_url") ]]; then say "on $bus_url$(told_by "$bus_url")"; fi
  # A part of the stack cannot help what the others do not send.
  if [[ $may_wait == yes ]]; then
    settle=0
  elif [[ $services_named == yes || $stack_profile == replay ]]; then
    settle=$settle_s
  fi
  if [[ -n $census ]]; then
    command=(-- "$census" ${bus_url:+--lcm-url "$bus_url"} --for $((${patience%.*} + 5)) --follow)
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

# last_complaints: for each log its service, a tab and the newest warning or error of its last process, where there is one.
last_complaints() {
  local file
  for file in "$log_dir"/*.log; do
    tail -n 500 -- "$file" 2>/dev/null | tr -d '\t' | LC_ALL=C awk '/^-- started / { line = "" }
      /^[0-9:.]+ [a-z0-9-]+ (warning|error|critical) / { line = $2 "\t" $0 } END { if (line != "") print line }' || true
  done
}

# hear_bus FILE: writes what was heard on the stack's bus: by what watches over it, else by listening now; nothing where
# nobody can be heard.
hear_bus() {
  if [[ -S $runtime_dir/watch.sock ]] && "$repository/scripts/lib/read-socket" "$runtime_dir/watch.sock" >"$1"; then
    return
  fi
  : >"$1"
  if [[ -n $census ]]; then "$census" ${bus_url:+--lcm-url "$bus_url"} --for "$listen_s" --json >"$1" || true; fi
}

# status: see scripts/stack's usage.
status() {
  local work verdict=0
  work=$(mktemp -d)
  report_status "$work" || verdict=$?
  rm -rf -- "$work"
  return "$verdict"
}

# report_status FOLDER: the same, with a folder for what is heard, which may be more than a command line takes.
report_status() {
  local work=$1 supervisor=alive verdict listening
  : >"$work/processes"
  if [[ -O $runtime_dir && -d $runtime_dir/services ]]; then
    log_dir=$(readlink -- "$runtime_dir/logs") || true
    supervise states "${services[@]}" >"$work/processes" 2>/dev/null || {
      orphans >"$work/processes"
      supervisor=dead
    }
  fi
  if [[ ! -s $work/processes ]]; then
    if [[ $json == yes ]]; then say '{"stack":null}'; else say "no stack runs in $runtime_dir"; fi
    return 3
  fi
  note_bus
  hear_bus "$work/heard" &
  listening=$!
  last_complaints >"$work/complaints"
  wait "$listening"
  jq -rs --slurpfile heard "$work/heard" --rawfile complaints "$work/complaints" --arg json "$json" \
    --arg supervisor "$supervisor" -f "$repository/scripts/lib/stack-status.jq" "$work/processes" >"$work/report"
  { read -r verdict && if [[ $json == yes ]]; then cat; else columns; fi; } <"$work/report"
  if [[ $json == no ]]; then tell_of_watch "$work/heard"; fi
  case $supervisor:$verdict in
    dead:*)
      warn "the supervisor is dead: services still run, pids $(jq -r .pid "$work/processes" | paste -sd ' '); nobody" \
        "starts them again; scripts/stack start replaces them, scripts/stack stop ends them"
      return 4
      ;;
    *:well) ;;
    *) return 1 ;;
  esac
}

# columns: lays out the table, of cells between tabs.
columns() {
  awk -F '\t' '{ line = sprintf("%-18s %-9s %8s %9s  %-12s %6s %7s %5s %7s %7s %7s  %s",
    $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12); sub(/ +$/, "", line); print line }'
}

# tell_of_watch FILE: who listened, and whom it killed; FILE is what hear_bus wrote.
tell_of_watch() {
  if [[ ! -s $1 ]]; then
    say "nobody was listened to: supervisor's words only"
  elif jq -e 'has("watch")' "$1" >/dev/null; then
    jq -r '.watch | "stack-watch (pid \(.pid)) listens; one that says nothing for " +
      "\(.silence_limit_s | round) s is killed" +
      (if .kills == [] then "" else "; killed: " + ([.kills[-3:][] | "\(.name) (\(.utime / 1e6 | floor |
        strflocaltime("%H:%M:%S")), silent for \(.silent_s | floor) s)"] | join(", ")) end) +
      (if .bus then "; " + .bus else "" end) +
      (if .crafted_fragments > 0 then "; \(.crafted_fragments) crafted fragments came" else "" end)' "$1"
  elif [[ -e $runtime_dir/no-watch ]]; then
    say "nobody watches (--no-watch): a service that hangs stays so"
  else
    say "stack-watch does not run: a service that hangs stays so"
  fi
}

# show_logs logs|tail: see scripts/stack's usage.
show_logs() {
  local folder service files=()
  folder=${log_dir:-$(readlink -- "$runtime_dir/logs" || printf '%s\n' "$logs_dir/stack")}
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
