# shellcheck shell=bash disable=SC2034,SC2154 # variables of the sourcing script, and for it
# A recording's folder and the logger that fills it. To be sourced after project.sh and bus.sh.

# new_dated_folder: makes logs/TIME and leaves its path in `folder`; waits while somebody else has taken the second.
new_dated_folder() {
  local errors
  if ! errors=$(mkdir -p -- "$logs_dir" 2>&1); then fail_with 2 "$logs_dir: cannot be made: ${errors##*: }"; fi
  folder=$logs_dir/$(date +%Y-%m-%d_%H-%M-%S)
  while ! errors=$(mkdir -- "$folder" 2>&1); do
    [[ -e $folder ]] || fail_with 2 "$folder: cannot be made: ${errors##*: }"
    sleep 0.2
    folder=$logs_dir/$(date +%Y-%m-%d_%H-%M-%S)
  done
}

# point_latest_to FOLDER: logs/latest, for a folder in logs/.
point_latest_to() { ln -sfn -- "${1##*/}" "$logs_dir/latest"; }

# with_receive_buffer URL: the URL as lcm-logger needs it: the kernel's default buffer loses raw frames.
with_receive_buffer() {
  case $1 in
    udpm://*recv_buf_size=*) printf '%s\n' "$1" ;;
    udpm://*\?*) printf '%s&recv_buf_size=4194304\n' "$1" ;;
    udpm://*) printf '%s?recv_buf_size=4194304\n' "$1" ;;
    *) printf '%s\n' "$1" ;;
  esac
}

# receive_buffer URL: how many bytes the kernel will grant a listener on URL; nothing where it does not say.
receive_buffer() {
  local asked granted
  [[ $1 =~ recv_buf_size=([0-9]+) ]] || return 0
  asked=${BASH_REMATCH[1]}
  granted=$(cat /proc/sys/net/core/rmem_max 2>/dev/null) || return 0
  printf '%d\n' $((asked < granted ? asked : granted))
}

# channels_regex FRAMES ROBOT: what lcm-logger shall take. Frames that no one asked for are not even put together.
channels_regex() {
  local prefix='(.*/)?'
  if [[ -n $2 ]]; then prefix=$2/; fi
  case $1:$2 in
    yes:) printf '.*\n' ;;
    yes:*) printf '%s.*\n' "$prefix" ;;
    *) printf '(?!%sSTEREO_FRAME$)%s.*\n' "$prefix" "${2:+$prefix}" ;;
  esac
}

# parts FOLDER: the names of the recording's files, in the order in which they were written, one a line.
parts() { find "$1" -maxdepth 1 -type f -regextype posix-extended -regex '.*/log\.lcm(\.[0-9]+)?' -printf '%f\n' | sort -V; }

# megabytes BYTES
megabytes() { printf '%d\n' $(($1 / 1000000)); }

# free_megabytes FOLDER: what an ordinary user can still write there.
free_megabytes() { df --output=avail -B1000000 -- "$1" | tail -n 1 | tr -d ' '; }

# unwritten_megabytes: how much lcm-logger may keep in memory while the disk is slow: a quarter of what is free, and no
# more than 1000.
unwritten_megabytes() {
  awk '/^MemAvailable:/ { mb = int($2 / 4096); print (mb < 100 ? 100 : (mb > 1000 ? 1000 : mb)) }' /proc/meminfo
}
