# shellcheck shell=bash disable=SC2154 # variables of the sourcing script
# One stack of services under one supervisord, described by the files in its runtime folder. To be sourced after
# project.sh; works on the variables runtime_dir and log_dir (absolute paths).

# default_runtime_dir: the folder of the stack that nobody has named another for.
default_runtime_dir() {
  local folder=/tmp/markservo-$UID
  if [[ -n ${XDG_RUNTIME_DIR-} && -O $XDG_RUNTIME_DIR && -w $XDG_RUNTIME_DIR ]]; then folder=$XDG_RUNTIME_DIR/markservo; fi
  # A stack belongs to its network: another network's is neither seen nor stopped.
  case ${MARKSERVO_PRIVATE_NETWORK-} in
    '') ;;
    port) folder+=-$(cksum <<<"$MARKSERVO_LCM_URL" | cut -d ' ' -f 1) ;;
    *) folder+=-$(stat -L -c %i /proc/self/ns/net) ;;
  esac
  printf '%s\n' "$folder"
}

# supervise ACTION [ARGUMENT...]: asks its supervisord; scripts/lib/supervise explains the actions.
supervise() { "$repository/scripts/lib/supervise" "$runtime_dir/supervisor.sock" "$@"; }

# is_running: whether this stack's supervisord answers.
is_running() { [[ -S $runtime_dir/supervisor.sock ]] && supervise alive 2>/dev/null; }

# configured_services: the services this stack knows, one a line; what watches over them is none.
configured_services() {
  find "$runtime_dir/services" -name '*.conf' ! -name stack-watch.conf -printf '%f\n' | sed 's/\.conf$//' | sort
}

# processes: the process ids of everything this stack has started, supervisord too, one a line.
processes() {
  # All of them carry the mark that start_supervisor sets, even when their supervisor has died.
  grep -lszxF -- "MARKSERVO_STACK=$runtime_dir" /proc/[0-9]*/environ | cut -d/ -f3
}

# orphans: the services that this stack has started and that still run, as `supervise states` prints them, with state
# ORPHAN: for when there is no supervisor to ask.
orphans() {
  local pid name parent uptime all=" "
  local -a pids
  mapfile -t pids < <(processes)
  all+="${pids[*]} "
  all=${all/ $(cat -- "$runtime_dir/supervisord.pid" 2>/dev/null || echo none) / }
  for pid in "${pids[@]}"; do
    name=$(tr '\0' '\n' 2>/dev/null <"/proc/$pid/environ" | sed -n 's/^SUPERVISOR_PROCESS_NAME=//p') || continue
    read -r parent uptime < <(ps -o ppid=,etimes= -p "$pid") || continue
    # What watches over them is none, and neither is what one of them has started.
    if [[ ! $name =~ ^[a-z][a-z0-9-]*$ || $name == stack-watch || $all == *" $parent "* ]]; then continue; fi
    jq -cn --arg name "$name" --argjson pid "$pid" --argjson uptime "$uptime" '{$name, state: "ORPHAN", $pid,
      uptime_s: $uptime, spawn_error: "", exit_code: 0, crashes: 0, next_start_s: null}'
  done | jq -cs 'sort_by(.name)[]'
}

# end_processes: waits 2 s for what is left of the stack to end by itself, then sends SIGTERM and, 2 s later, SIGKILL.
end_processes() {
  local signal left tenths
  for signal in 0 TERM KILL; do
    for ((tenths = 0; tenths < 20; ++tenths)); do
      mapfile -t left < <(processes)
      if ((${#left[@]} == 0)); then return 0; fi
      if ((tenths == 0)) && [[ $signal != 0 ]]; then kill -s "$signal" "${left[@]}" 2>/dev/null || true; fi
      sleep 0.1
    done
  done
  fail "processes that cannot be ended: ${left[*]}"
}

# make_runtime_dir: creates the runtime folder for this user alone; refuses one that another user could reach into.
make_runtime_dir() {
  local socket=$runtime_dir/supervisor.sock
  # A socket's path holds 107 bytes, and supervisord appends ".<pid>" while it binds.
  ((${#socket} <= 96)) || fail "runtime folder $runtime_dir: too long for a socket's path; use a shorter --runtime-dir"
  # supervisor would expand or split these, wherever the path is used.
  if [[ $runtime_dir == *[%\"\;#]* ]]; then
    fail "runtime folder $runtime_dir: % \" ; # are not allowed in its path; use --runtime-dir"
  fi
  (umask 077 && mkdir -p -- "$runtime_dir")
  if [[ -L $runtime_dir || ! -d $runtime_dir || ! -O $runtime_dir ]]; then
    fail "runtime folder $runtime_dir: not a folder of yours; use --runtime-dir"
  fi
  chmod 0700 -- "$runtime_dir"
}

# render SERVICE: reads the template, writes it to standard output with @...@ filled in.
render() {
  local text user=''
  text=$(cat)
  # Without a user supervisord complains when root runs it.
  if ((EUID == 0)); then user='user=root'; fi
  text=${text//@runtime_dir@/"$runtime_dir"}
  text=${text//@service@/"$1"}
  text=${text//@user@/"$user"}
  printf '%s\n' "$text"
}

# start_supervisor SERVICE...: starts supervisord, which then knows these services but runs none. It answers when this
# returns.
start_supervisor() {
  local service
  rm -rf -- "${runtime_dir:?}"/{services,launch,options,starts}
  # A dead supervisor's socket would be told of by the next.
  rm -f -- "$runtime_dir/supervisor.sock"
  mkdir -- "$runtime_dir"/{services,launch,options,starts}
  ln -sfn -- "$log_dir" "$runtime_dir/logs"
  sed '/^\[program:/,$d' "$repository/config/supervisord.conf" | render '' >"$runtime_dir/supervisord.conf"
  for service; do render_service "$service"; done
  # In a session of its own: Ctrl-C is for this script.
  setsid --wait env MARKSERVO_STACK="$runtime_dir" supervisord -c "$runtime_dir/supervisord.conf" </dev/null
}

# render_service SERVICE: writes its [program] section.
render_service() {
  sed -n '/^\[program:/,$p' "$repository/config/supervisord.conf" | render "$1" >"$runtime_dir/services/$1.conf"
}

# add_service SERVICE: makes the running supervisord know a service, if it does not; it does not start it.
add_service() {
  if [[ -f $runtime_dir/services/$1.conf ]]; then return; fi
  render_service "$1"
  supervise add "$1"
}
