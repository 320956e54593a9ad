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
  words_before=$(stat -L -c %s -- "$words_file")
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
  local tries
  logger=''
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
  is_alive && ! tail -c +$((words_before + 1)) -- "$words_file" | grep -q 'self test failed' && note_interface
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

# how_it_ended STATUS: in words, who and how; STATUS as keep-logger exits.
how_it_ended() {
  local signal
  if (($1 <= 128)); then
    printf 'lcm-logger ended with exit code %d\n' "$1"
    return
  fi
  signal=$(($1 > 192 ? $1 - 192 : $1 - 128))
  printf '%s was killed by signal %d (SIG%s)\n' "$( (($1 > 192)) && echo lcm-logger || echo 'keep-logger, which runs lcm-logger,')" \
    "$signal" "$(kill -l "$signal" 2>/dev/null || echo '?')"
}

# exit_code_of STATUS: of whoever ended so, as a shell gives it.
exit_code_of() { printf '%d\n' $(($1 > 192 ? $1 - 64 : $1)); }

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

# group_of URL: a bus's multicast group; nothing for another bus.
group_of() {
  [[ $1 == udpm://* ]] || return 0
  sed -E 's|^udpm://([0-9.]*).*|\1|; s|^$|239.255.76.67|' <<<"$1"
}

# interface_of GROUP: the number of the interface on which who joins the group now hears it; nothing where none is.
interface_of() {
  local name
  name=$(ip -o route get "$1" 2>/dev/null | sed -nE 's/.* dev ([^ ]+).*/\1/p') || true
  if [[ -n $name ]]; then ip -o link show dev "$name" 2>/dev/null | cut -d : -f 1 || true; fi
}

# note_interface: where lcm-logger, which has just begun to listen, may hear.
note_interface() {
  group=$(group_of "$lcm_url")
  interface=''
  if [[ -n $group ]]; then interface=$(interface_of "$group"); fi
  heard_until=$EPOCHREALTIME
}

# can_hear: false when the interface that the group was joined on is gone: whoever joined it there hears nothing any more,
# and is not told. One that came back has another number.
can_hear() {
  local links
  if [[ -n ${interface-} ]] && links=$(ip -o link 2>/dev/null) && ! grep -q "^$interface:" <<<"$links"; then return 1; fi
  heard_until=$EPOCHREALTIME
}

# rejoin: lcm-logger is deaf: ends it, and begins the next part when there is a bus again; else as resume.
rejoin() {
  local reason='its network interface went away'
  end_logger || true
  keeper=''
  note_gap "$heard_until" 0 "$reason"
}

# note_gap FROM STATUS REASON: nothing is recorded since FROM; goes on in the next part. False as resume.
note_gap() {
  local last
  last=$(parts "$folder" | tail -n 1)
  if [[ -n $last && ! -s $folder/$last ]]; then rm -f -- "$folder/$last"; fi
  gaps=$((gaps + 1))
  begin_gap "$1" "$2" "$3" || true
  if [[ ! -t 1 ]]; then warn "$3: the recording goes on in the next part"; fi
  begin_again || return 1
  end_gap "$listens_since" || true
}

# resume: lcm-logger died: begins the next part, and notes in the manifest what was missed. False when the recording ends
# instead, for a reason that it leaves in `ended_by`.
resume() {
  local status=0
  wait "$keeper" || status=$?
  keeper=''
  # What it says by itself is no accident: a disk that is full, a file that cannot be written.
  if ((status > 0 && status < 128)); then
    ended_by="logger failed"
    exit_code=$status
    return 1
  fi
  await_end_of_logger
  note_gap "$(missed_since)" "$status" "$(how_it_ended "$status")"
}

# await_end_of_logger: when only what runs it was killed it still writes what it holds; 3 s at most.
await_end_of_logger() {
  local tries
  for ((tries = 0; tries < 60; ++tries)); do
    [[ -n ${logger-} && $(cat "/proc/$logger/comm" 2>/dev/null) == lcm-logger ]] || return 0
    sleep 0.05
  done
}

# begin_again: until there is a logger that listens; false when the recording ends instead.
begin_again() {
  local pause
  while true; do
    # One that lived for 10 s begins anew.
    crashes=$(($(hundredths) - started > 1000 ? 0 : crashes + 1))
    pause=$((crashes < 2 ? 0 : crashes > 3 ? 200 : 50 << (crashes - 2)))
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

# missed_since: from when on nothing was recorded (s.us since the epoch): the time of the last event that is on disk, or
# when lcm-logger began to listen. The file's own time says only when something was written.
missed_since() {
  local names i utime
  mapfile -t names < <(parts "$folder")
  for ((i = ${#names[@]} - 1; i >= 0 && i >= ${#names[@]} - 2; --i)); do
    utime=$(last_utime "$folder/${names[i]}")
    if [[ -n $utime ]] && ((utime > ${listens_since/[.,]/})); then
      printf '%s.%s\n' "${utime%??????}" "${utime: -6}"
      return
    fi
  done
  printf '%s\n' "$listens_since"
}

# last_utime FILE: when the last event that begins in FILE's last 4 MB was heard, us since the epoch; nothing where there
# is none. What looks like an event within a picture has an impossible time.
last_utime() {
  local size from places place utime now=${EPOCHREALTIME/[.,]/}
  size=$(stat -c %s -- "$1")
  from=$((size > 4000000 ? size - 4000000 : 0))
  mapfile -t places < <(tail -c +$((from + 1)) -- "$1" | LC_ALL=C grep -obUaP '\xed\xa1\xda\x01' | tail -n 100 | cut -d : -f 1 | tac)
  for place in "${places[@]}"; do
    # Behind the magic word are the event's number and time, 8 bytes each, the largest first.
    utime=$(od -An -v -tu8 --endian=big -j $((from + place + 12)) -N 8 -- "$1" 2>/dev/null | tr -d ' ')
    if [[ $utime =~ ^[0-9]{1,18}$ ]] && ((utime > now - 86400000000 && utime <= now)); then
      printf '%s\n' "$utime"
      return
    fi
  done
}
