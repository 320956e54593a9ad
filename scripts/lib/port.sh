# shellcheck shell=bash
# A port of this host, 127.0.0.1 alone, by which a browser reaches the page: also where the page's socket is a stack's on a
# private network, into which nothing else leads. To be sourced after project.sh.

first_port=8080
last_port=8179

# answers SOCKET: whether somebody listens at this path.
answers() { socat -u OPEN:/dev/null "UNIX-CONNECT:$(socat_path "$1")" 2>/dev/null; }

# socat_path PATH: as socat reads it, to which commas, colons and quotes have a meaning.
# shellcheck disable=SC2001 # a pattern in the shell puts the same in every match's place
socat_path() { sed 's,[^A-Za-z0-9_./ -],\\&,g' <<<"$1"; }

# is_taken PORT: whether somebody, whoever, listens at it.
is_taken() { [[ -n $(ss -Hltn "sport = :$1") ]]; }

# has_port PROCESS PORT: whether it is this process that listens there.
has_port() { ss -Hltnp "sport = :$2" | grep -q "pid=$1,"; }

# begin_listening COMMAND [ARGUMENT...]: runs COMMAND ARGUMENT... PORT in the background, with the first free port, and
# returns when it listens there: then `listener` is its process, `page_address` the page's. Fails when it ends before that;
# it has said why. It ends with the script that has called this, in whatever way that ends.
begin_listening() {
  local port
  for ((port = first_port; port <= last_port; ++port)); do
    if is_taken "$port"; then continue; fi
    set -m # a process group of its own: its children end with it, and Ctrl-C is for the script alone
    "$@" "$port" </dev/null &
    listener=$!
    set +m
    while kill -0 "$listener" 2>/dev/null; do
      if has_port "$listener" "$port"; then
        page_address=http://127.0.0.1:$port
        return 0
      fi
      sleep 0.05
    done
    end_listening
    # Somebody else may have been quicker.
    if ! is_taken "$port"; then return 1; fi
  done
  warn "no port from $first_port to $last_port is free"
  return 1
}

# end_listening: ends what begin_listening has started, and the connections that it carries.
listener=''
end_listening() {
  if [[ -z $listener ]]; then return 0; fi
  kill -TERM -- "-$listener" 2>/dev/null || true
  wait "$listener" 2>/dev/null || true
  listener=''
}

# forward SOCKET PORT: becomes what carries each connection to PORT on to SOCKET, which may come later; of more browsers
# than the page's server takes, the last ones wait.
forward() {
  exec setpriv --pdeathsig TERM -- socat "TCP-LISTEN:$2,bind=127.0.0.1,reuseaddr,fork,backlog=128,max-children=80" \
    "UNIX-CONNECT:$(socat_path "$1")" 2>/dev/null
}

# open_page: in the browser of who is here, where there is a display.
open_page() {
  if [[ -n ${DISPLAY-}${WAYLAND_DISPLAY-} ]] && command -v xdg-open >/dev/null; then
    setsid --fork xdg-open "$page_address" >/dev/null 2>&1 </dev/null
  fi
}
