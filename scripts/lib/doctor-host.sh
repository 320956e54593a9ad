# shellcheck shell=bash disable=SC2154 # variables of the sourcing script
# What scripts/doctor asks of the host: network, clock, disk, devices. Each check_ function says what it finds by `well`
# and `wrong`. To be sourced by scripts/doctor.

recording_needs_mb=2000 # a demo that drives, or a good minute of raw frames

# url_part NAME: a parameter of the bus's address; nothing when it is not given.
url_part() { sed -nE "s/^[^?]*\\?(.*&)?$1=([^&]*).*/\\2/p" <<<"$lcm_url"; }

# url_with NAME VALUE: the address with that parameter.
url_with() {
  local plain
  plain=$(sed -E "s/([?&])$1=[^&]*&?/\\1/; s/[?&]\$//" <<<"$lcm_url")
  if [[ $plain == *\?* ]]; then printf '%s&%s=%s\n' "$plain" "$1" "$2"; else printf '%s?%s=%s\n' "$plain" "$1" "$2"; fi
}

# bus_group: where the address leaves it out, as udpm:// and udpm://?ttl=1 do, LCM's own.
bus_group() {
  local group=${lcm_url#udpm://}
  group=${group%%[:?]*}
  printf '%s\n' "${group:-239.255.76.67}"
}

# check_names: the environment has two words for a bus; LCM's own programs know one of them.
check_names() {
  local ours=${MARKSERVO_LCM_URL-} of_lcm=${LCM_DEFAULT_URL-}
  if [[ -n $ours && -n $of_lcm && $lcm_url == "$ours" && ${ours%%\?*} != "${of_lcm%%\?*}" ]]; then
    wrong bus "MARKSERVO_LCM_URL and LCM_DEFAULT_URL name two: LCM's own programs, lcm-logger for instance, are on $of_lcm" \
      "export LCM_DEFAULT_URL=\$MARKSERVO_LCM_URL"
  fi
}

check_address() {
  local ttl variable=MARKSERVO_LCM_URL
  check_names
  if [[ -z $lcm_url ]]; then
    wrong bus "nobody can tell which bus the services take by default before they are built" "$get_programs"
    return
  fi
  if ! [[ $lcm_url =~ ^udpm://([0-9.]+(:[0-9]+)?)?([?].*)?$ ]]; then
    if [[ -n $(told_by "$lcm_url") ]]; then variable=LCM_DEFAULT_URL; fi
    wrong bus "the address $lcm_url$(told_by "$lcm_url") is none that others can be on; allowed: udpm://GROUP:PORT?..." \
      "unset $variable, or --lcm-url '$default_lcm_url'"
    return
  fi
  ttl=$(url_part ttl)
  ttl=${ttl:-0} # liblcm's own default
  if ! [[ $ttl =~ ^[0-9]{1,3}$ ]]; then
    wrong bus "ttl=$ttl in the address; allowed: 0 to 255" "use --lcm-url '$(url_with ttl 0)'"
  elif ((10#$ttl > 0)) && [[ $leaves_host == no ]]; then
    wrong bus "ttl=$ttl: the bus leaves this host, and LCM lets anyone in the network command the robot" \
      "use --lcm-url '$(url_with ttl 0)', or say --leaves-host where the network is the robot's own"
  elif ((10#$ttl == 0)) && [[ $leaves_host == yes ]]; then
    wrong bus "ttl=0: the bus does not leave this host, other hosts hear nothing" "use --lcm-url '$(url_with ttl 1)'"
  else
    well bus "ttl=$ttl: $(if ((10#$ttl > 0)); then echo "the bus leaves this host, as asked"; else echo "the bus stays on this host"; fi)$(told_by "$lcm_url")"
  fi
}

check_route() {
  local group route device mend='ip link set lo multicast on; ip route add 224.0.0.0/4 dev lo'
  if [[ -z $lcm_url ]]; then return; fi
  group=$(bus_group)
  if ! command -v ip >/dev/null; then
    wrong bus "the program ip is not there to ask for routes" "$(get_packages iproute2)"
  elif ! route=$(ip -4 route get "$group" 2>&1); then
    wrong bus "no multicast route to $group ($(head -n 1 <<<"$route"))" "$mend"
  else
    device=$(sed -nE '1 s/.* dev ([^ ]+).*/\1/p' <<<"$route")
    if [[ -n $device && $(ip -o link show dev "$device") != *MULTICAST* ]]; then
      wrong bus "the route to $group goes by $device, which has multicast off" "ip link set $device multicast on"
    elif [[ $device == lo && $leaves_host == yes ]]; then
      wrong bus "the route to $group goes by lo: other hosts hear nothing" \
        "ip route replace 224.0.0.0/4 dev NAME (of the interface to the other hosts)"
    else
      well bus "multicast to $group goes by $device"
    fi
  fi
}

# check_listener: whether the bus could be listened to.
check_listener() {
  if [[ -s $heard_file ]]; then return; fi
  if [[ -z $listener ]]; then
    wrong bus "nobody was listened to: $build_dir/bin/bus-census is not there, or the address is none" \
      "$get_programs"
  else
    wrong bus "cannot be joined (exit code $listener_status): $(head -n 1 "$heard_file.errors")" \
      "mend what is said of the bus above"
  fi
}

check_receive_buffer() {
  local asked granted file=${MARKSERVO_PROC_ROOT:-/proc}/sys/net/core/rmem_max
  if [[ -z $raw_frames_need ]]; then return; fi # not built, which is told
  asked=$(url_part recv_buf_size)
  # Inside a network namespace the kernel hides the setting, but obeys it.
  if ! granted=$(cat -- "$file" 2>/dev/null); then
    granted=$(jq '.receive_buffer.granted // empty' "$heard_file" 2>/dev/null) || granted=''
  fi
  if ! [[ $granted =~ ^[0-9]+$ ]]; then
    wrong bus "cannot tell net.core.rmem_max ($file)" "sysctl net.core.rmem_max"
  elif ((granted < raw_frames_need)); then
    wrong bus "net.core.rmem_max is $granted bytes: raw frames need $raw_frames_need; below it frames go as JPEG" \
      "sysctl -w net.core.rmem_max=4194304; echo net.core.rmem_max=4194304 >/etc/sysctl.d/60-markservo.conf"
  elif ! [[ $asked =~ ^[0-9]{1,12}$ ]] || ((10#$asked < raw_frames_need)); then
    wrong bus "recv_buf_size=${asked:-none} in the address: raw frames need $raw_frames_need bytes" \
      "use --lcm-url '$(url_with recv_buf_size 4194304)'"
  else
    well bus "receive buffer of $((granted < asked ? granted : asked)) bytes: raw frames fit"
  fi
}

check_clock() {
  local line wrong_before=$faults others text
  line=$(jq -r '.clock.jump_s | select(fabs > 0.001) * 1000 | round' "$heard_file")
  if [[ -n $line ]]; then
    wrong clock "this host's clock jumped by $line ms while it was listened to" \
      "let chrony slew it: apt-get install chrony; chronyc makestep (with the robot stopped)"
  fi
  others=$(jq -r '.host as $host | [.services[].host | select(. != $host)] | unique | join(" ")' "$heard_file")
  # Of each other host the service that came quickest: the rest is delay.
  while IFS= read -r line; do
    wrong clock "$line" "on both hosts: apt-get install chrony; chronyc makestep (with the robot stopped)"
  done < <([[ -z $clock_tolerance_s ]] || jq -r --argjson limit "$clock_tolerance_s" '.host as $host | [.services[] | select(.host != $host)]
    | group_by(.host)[] | min_by(.clock_behind_s | fabs) | select(.clock_behind_s | fabs > $limit)
    | "the clock of \(.host) is \(.clock_behind_s * 1000 | fabs | round) ms " +
      (if .clock_behind_s > 0 then "behind" else "ahead of" end) + " ours"' "$heard_file")
  if [[ $(jq .clock.synchronised "$heard_file") == true ]]; then
    text=synchronised
  elif [[ -n $others || $leaves_host == yes ]]; then
    wrong clock "not synchronised, and there are other hosts" "apt-get install chrony"
  else
    text="not synchronised: no matter while one host is the whole robot"
  fi
  if ((faults == wrong_before)); then well clock "$text${others:+; agrees with $others}"; fi
}

check_disk() {
  local folder=$log_dir free_mb
  while [[ ! -e $folder ]]; do folder=$(dirname -- "$folder"); done
  free_mb=$(($(df -P -B 1000000 -- "$folder" | awk 'NR == 2 { print $4 }')))
  if [[ ! -d $folder || ! -w $folder ]]; then
    wrong disk "$folder: no folder that $(id -un) may write in" "chown $(id -un) ${folder@Q}"
  elif ((free_mb < recording_needs_mb)); then
    wrong disk "$folder has $free_mb MB left; recordings need $recording_needs_mb MB" \
      "du -s ${log_dir@Q}/* | sort -n | tail (then remove old recordings)"
  else
    well disk "$folder has $free_mb MB left"
  fi
}

# named_devices: the devices in the settings of the profile's services, one a line: /dev/... values of any option.
named_devices() {
  local service arguments
  for service in "${services[@]}"; do
    arguments=()
    if [[ -f $config_dir/$service.conf ]]; then arguments=(--config "$config_dir/$service.conf"); fi
    "$build_dir/bin/$service" "${arguments[@]}" --print-config 2>/dev/null || true
  done | sed -nE 's,^[a-z0-9-]+="?(/dev/[^"]+)"?$,\1,p' | sort -u
}

# check_device FILE
check_device() {
  local group
  if [[ ! -e $1 ]]; then
    wrong devices "$1 is not there" "plug it in, then: ls -l /dev/video* /dev/ttyUSB* /dev/ttyACM*; or change the .conf that names it"
  elif [[ ! -c $1 ]]; then
    wrong devices "$1 is no device" "ls -l /dev/video* /dev/ttyUSB* /dev/ttyACM*; then change the .conf that names it"
  elif [[ ! -r $1 || ! -w $1 ]]; then
    group=$(stat -L -c %G -- "$1")
    # The usual group, which the rule of the system's udev gives it.
    if [[ $group == root || $group == UNKNOWN ]]; then if [[ $1 == */video* ]]; then group=video; else group=dialout; fi; fi
    wrong devices "$1: $(id -un) may not read and write it ($(stat -L -c '%A %U %G' -- "$1"))" \
      "sudo usermod -a -G $group $(id -un), then log in again"
  else
    well devices "$1 may be used"
  fi
}

check_devices() {
  local device named cameras own_config=$config_dir calibration=stereo.yml copy=''
  mapfile -t named < <(named_devices)
  for device in "${named[@]}" "${devices[@]}"; do check_device "$device"; done
  if [[ $profile == robot ]] && ! names_a_camera; then
    cameras=$(find /dev -maxdepth 1 -name 'video*' | sort | xargs)
    if [[ $installed == yes ]]; then
      # What the package brought is not to be changed: a copy of it is.
      if [[ $config_dir == "$repository/config" ]]; then
        own_config=$user_config_dir
        copy="mkdir -p ${own_config@Q}; cp -r ${config_dir@Q}/. ${own_config@Q}; "
      fi
      calibration=$own_config/stereo.yml
    fi
    wrong devices "no camera is named (config/stereo-camera.conf); there: ${cameras:-none}" \
      "${copy}printf 'left-device=/dev/video0\\nright-device=/dev/video2\\ncalibration=$calibration\\n' >${own_config@Q}/stereo-camera.conf"
  elif ((${#named[@]} + ${#devices[@]} == 0)); then
    well devices "the settings name none"
  fi
}
