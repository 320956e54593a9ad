# shellcheck shell=bash disable=SC2154 # variables of the sourcing script
# What scripts/doctor --cameras asks of the cameras: a moment of their pictures goes through mark-detector and
# target-locator, by logs, and camera-check says what it finds. To be sourced by scripts/doctor after doctor-host.sh.

listen_to_frames_s=1 # 30 pairs of most cameras; raw ones of 640 x 480 take 55 MB
pairs_from_cameras=10 # the first ones, before a camera has settled its exposure, are not looked at
patience_for_cameras_s=15

# frame_channel: the channel on which somebody shows pictures, as far as was heard; nothing where nobody does.
frame_channel() {
  jq -r 'first(.channels[] | select(.events > 0).channel | select(test("^(.*/)?STEREO_FRAME$"))) // ""' "$heard_file" 2>/dev/null
}

# settings_of SERVICE: the options by which it runs as a stack would run it, one a line.
settings_of() {
  printf '%s\n' --robot-file "$robot_file"
  if [[ -f $config_dir/$1.conf ]]; then printf '%s\n' --config "$config_dir/$1.conf"; fi
}

# names_a_camera: whether stereo-camera's settings say where pictures come from.
names_a_camera() {
  grep -qsE '^[[:space:]]*(left-device|device|left|input)[[:space:]]*=' "$config_dir/stereo-camera.conf"
}

# frames_into FOLDER CHANNEL: FOLDER/frames.lcm with a moment of pictures; says why where there are none, and fails.
frames_into() {
  local words settings status=0
  if [[ -n $2 ]]; then
    # What ends it is expected.
    timeout "$listen_to_frames_s" lcm-logger --lcm-url="$(url_with recv_buf_size 4194304)" --channel="$2" \
      "$1/frames.lcm" >/dev/null 2>&1 || true
    if [[ -s $1/frames.lcm ]]; then return; fi
    wrong cameras "$2 was on the bus, and then no more" "scripts/stack status"
    return 1
  fi
  if ! names_a_camera; then
    wrong cameras "nobody shows pictures on the bus, and $config_dir/stereo-camera.conf names no camera" \
      "scripts/stack start, or write left-device and right-device into it"
    return 1
  fi
  mapfile -t settings < <(settings_of stereo-camera)
  # From the project's folder: settings may name files in it.
  words=$(cd -- "$repository" && timeout "$patience_for_cameras_s" "$build_dir/bin/stereo-camera" "${settings[@]}" \
    --count "$pairs_from_cameras" --encoding raw --lcm-out "file://$1/frames.lcm?mode=w" 2>&1 >/dev/null) || status=$?
  # 124: files that are fewer end by themselves, a camera that is waited for does not.
  if [[ -s $1/frames.lcm ]] && ((status == 0 || status == 124)); then return; fi
  if ((status == 124)); then
    words="no picture within $patience_for_cameras_s s"
  else
    words=$(tail -n 1 <<<"$words" | sed 's/^stereo-camera: //')
  fi
  wrong cameras "stereo-camera: ${words:-fails without a word}" "edit ${config_dir@Q}/stereo-camera.conf, or plug the cameras in"
  return 1
}

# through SERVICE FROM TO [OPTION...]: the log TO is what SERVICE makes of the log FROM; says why where it does not.
through() {
  local settings words
  mapfile -t settings < <(settings_of "$1")
  if words=$(cd -- "$repository" && "$build_dir/bin/$1" "${settings[@]}" --lcm-in "file://$2?speed=0" \
    --lcm-out "file://$3?mode=w" "${@:4}" 2>&1 >/dev/null); then return; fi
  wrong cameras "$1: $(tail -n 1 <<<"$words" | sed "s/^$1: //")" "edit ${robot_file@Q}"
  return 1
}

check_cameras() {
  local folder=$heard_file.cameras channel prefix ok what mend service robot=()
  for service in stereo-camera mark-detector target-locator camera-check; do
    if [[ ! -x $build_dir/bin/$service ]]; then
      wrong cameras "nobody can look at them: $build_dir/bin/$service is not there" "$get_programs"
      return
    fi
  done
  mkdir -- "$folder"
  channel=$(frame_channel)
  prefix=${channel%STEREO_FRAME}
  if [[ -n $prefix ]]; then robot=(--robot "${prefix%/}"); fi
  frames_into "$folder" "$channel" || return 0
  through mark-detector "$folder/frames.lcm" "$folder/detections.lcm" "${robot[@]}" || return 0
  through target-locator "$folder/detections.lcm" "$folder/poses.lcm" "${robot[@]}" || return 0
  "$build_dir/bin/camera-check" --json "${robot[@]}" "$folder"/{frames,detections,poses}.lcm >"$folder/report" \
    2>"$folder/errors" || true
  if [[ ! -s $folder/report ]]; then
    wrong cameras "camera-check: $(head -n 1 "$folder/errors")" "$get_programs"
    return
  fi
  while IFS=$'\t' read -r ok what mend; do
    if [[ $ok == true ]]; then well cameras "$what"; else wrong cameras "$what" "$mend"; fi
  done < <(jq -r '.findings[] | [.ok, .what, .mend // ""] | @tsv' "$folder/report")
}
