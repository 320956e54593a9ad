# shellcheck shell=bash disable=SC2034,SC2154 # variables of the sourcing script, and for it
# The lcm-logger behind a recording: begins, ends, and begins again when it died. To be sourced after recording.sh; works
# on scripts/record's variables.

# start_logger NAME: lets lcm-logger write to that file in the recording's folder, or, with --split-mb, to the next ones.
start_logger() {
  local arguments=(--lcm-url="$lcm_url" --channel="$(channels_regex "$frames" "$robot")"
    --max-unwritten-mb="$(unwritten_megabytes)" --flush-interval=250)
  # Not --quiet, which also hides that messages are dropped; not --increment or --rotate: the one swallows the next
  # argument, the other renames files while they are written.
  if [[ -n $split ]]; then arguments+=(-i --split-mb="$split"); fi
  # A session of its own: Ctrl-C is for this script, which then ends the logger with care.
  setsid setpriv --pdeathsig TERM -- "$repository/scripts/lib/keep-logger" $$ "$words" "${arguments[@]}" \
    "$folder/$1" </dev/null >/dev/null 2>&"$words" &
  keeper=$!
  started=$(hundredths)
  runs=$((runs + 1))
}

is_alive() { [[ -n $keeper ]] && kill -0 "$keeper" 2>/dev/null; }

# await_bus: until lcm-logger listens (three threads then; over TCP two), since `listens_since`; false when it ended
# instead.
await_bus() {
  local tries logger=''
  for ((tries = 0; tries < 200; ++tries)); do
    is_alive || return 1
    logger=$(pgrep -x -P "$keeper" lcm-logger) || true
    if [[ -n $logger ]]; then
      if (($(find "/proc/$logger/task" -mindepth 1 -maxdepth 1 2>/dev/null | wc -l) >= 3)); then break; fi
      if [[ $lcm_url == tcpq:* ]] && ((tries > 20)); then break; fi
    fi
    sleep 0.05
  done
  listens_since=$EPOCHREALTIME
  sleep 0.2 # for LCM's test of itself
  is_alive && ! grep -q 'self test failed' "$words_file"
}

# refuse_bus: says why there is none.
refuse_bus() {
  local said advice
  end_logger || true
  said=$(grep -vm1 '^$' "$words_file" || true)
  undo
  advice="lcm-logger says: ${said:-nothing}"
  if grep -qE 'multicast route|self test failed' "$words_file"; then
    advice="is there a multicast route? On a host without network run: ip link set lo multicast on; ip route add 224.0.0.0/4 dev lo"
  fi
  fail_with 3 "bus $lcm_url: cannot be joined; nothing was recorded; $advice"
}

# end_logger: returns its exit code.
end_logger() {
  local status=0 again=yes
  kill -TERM "$keeper" 2>/dev/null || true
  # A signal that comes meanwhile ends `wait` early.
  while [[ $again == yes ]]; do
    again=no
    status=0
    wait "$keeper" || status=$?
    if ((status > 128)) && is_alive; then again=yes; fi
  done
  return "$status"
}

# how_it_ended EXIT_CODE: of lcm-logger, in words.
how_it_ended() {
  if (($1 > 128)); then
    printf 'was killed by signal %d (SIG%s)\n' $(($1 - 128)) "$(kill -l "$1" 2>/dev/null || echo '?')"
  else
    printf 'ended with exit code %d\n' "$1"
  fi
}

# next_name: of the part that a logger which begins now shall write. It numbers parts by itself, from the first name that
# is free; those that --keep has removed are not free, or new parts would come before old ones: empty files hold their
# places until it has begun.
next_name() {
  local last number
  if [[ -z $split ]]; then
    printf 'log.lcm.%02d\n' "$runs"
    return
  fi
  last=$(parts "$folder" | tail -n 1)
  last=${last##*.}
  for ((number = 0; number <= 10#${last:-0}; ++number)); do
    name=$(printf 'log.lcm.%02d' "$number")
    if [[ ! -e $folder/$name ]]; then : >"$folder/$name"; fi
  done
  printf 'log.lcm\n'
}

# resume: lcm-logger died: begins the next part, and notes in the manifest what was missed. False when the recording ends
# instead, for a reason that it leaves in `ended_by`.
resume() {
  local status=0 died=$EPOCHREALTIME from last
  wait "$keeper" || status=$?
  keeper=''
  # What it says by itself is no accident: a disk that is full, a file that cannot be written.
  if ((status > 0 && status < 128)); then
    ended_by="logger failed"
    exit_code=$status
    return 1
  fi
  last=$(parts "$folder" | tail -n 1)
  from=$(missed_since "$died" "$folder/$last")
  if [[ -n $last && ! -s $folder/$last ]]; then rm -f -- "$folder/$last"; fi
  gaps=$((gaps + 1))
  begin_gap "$from" "$status" || true
  if [[ ! -t 1 ]]; then warn "lcm-logger $(how_it_ended "$status"): the recording goes on in the next part"; fi
  begin_again || return 1
  end_gap "$listens_since" || true
}

# begin_again: until there is a logger that listens; false when the recording ends instead.
begin_again() {
  local pause
  while true; do
    # One that lived for 10 s begins anew.
    crashes=$(($(hundredths) - started > 1000 ? 0 : crashes + 1))
    pause=$((crashes < 2 ? 0 : crashes > 5 ? 500 : 50 << (crashes - 2)))
    while ((pause > 0)); do
      may_go_on || return 1
      rest $((pause > 50 ? 50 : pause))
      pause=$((pause - 50))
    done
    may_go_on || return 1
    start_logger "$(next_name)"
    if await_bus; then
      # What only held a place.
      find "$folder" -maxdepth 1 -name 'log.lcm.*' -size 0 ! -name "$(parts "$folder" | tail -n 1)" -delete
      return 0
    fi
    end_logger || true
    keeper=''
  done
}

# missed_since DIED FILE: from when on nothing was recorded, when lcm-logger died then (s.us since the epoch): since it
# wrote last, or for a second at most, for it writes four times a second what it has heard.
missed_since() {
  local written=0
  if [[ -s $2 ]]; then written=$(stat -c %.6Y -- "$2"); fi
  written=${written/[.,]/}
  printf '%s\n' "$((written > ${1/[.,]/} - 1000000 ? written : ${1/[.,]/} - 1000000))" | sed 's/......$/.&/'
}
