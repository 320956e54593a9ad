# shellcheck shell=bash disable=SC2154 # variables of the sourcing script
# manifest.json: what a recording is, how it was made and how it ended. To be sourced after recording.sh.

log_tool=$programs/log-tool

# instant SECONDS.MICROSECONDS: {"utc", "utime"}.
instant() {
  jq -cn --arg utc "$(date -u -d "@${1%.*}" +%Y-%m-%dT%H:%M:%SZ)" --argjson utime "${1/./}" '{$utc, $utime}'
}

# source_version: the commit, and whether files differ from it; null in a copy without git, and where it is installed.
source_version() {
  local commit dirty=false
  if [[ $installed == yes ]]; then echo null; return; fi
  commit=$(git -C "$repository" rev-parse HEAD 2>/dev/null) || { echo null; return; }
  if [[ -n $(git -C "$repository" status --porcelain 2>/dev/null) ]]; then dirty=true; fi
  jq -cn --arg commit "$commit" --argjson dirty "$dirty" '{$commit, $dirty}'
}

# message_types: name -> hash of every type that this build knows; null before the first build.
message_types() { "$log_tool" types --json 2>/dev/null || echo null; }

# configuration FOLDER ROBOT_FILE: the text and hash of each file, and one hash over all.
configuration() {
  local files=() file path all folder
  folder=$(realpath -- "$1")
  mapfile -t files < <({ find "$1" -type f -size -1024k; printf '%s\n' "$2"; } | xargs -d '\n' realpath -- | sort -u)
  all=$(for file in "${files[@]}"; do
    # Only a path inside the project can be written back by whoever has the recording.
    if [[ $file == "$folder"/* ]]; then path=config/${file#"$folder"/}; else path=${file#"$repository"/}; fi
    if [[ $path == /* ]]; then path=outside/${path##*/}; fi
    jq -cn --arg path "$path" --arg sha256 "$(sha256sum -- "$file" | cut -c1-64)" --rawfile text "$file" \
      '{$path, $sha256, $text}'
  done | jq -cs .)
  jq -cn --arg sha256 "$(jq -r '.[] | "\(.sha256)  \(.path)"' <<<"$all" | sha256sum | cut -c1-64)" --slurpfile files <(
    cat <<<"$all"
  ) '{$sha256, files: $files[0]}'
}

# write_manifest FOLDER TEXT: replaces it in one step, so that there always is a whole one.
write_manifest() {
  cat >"$1/manifest.json.new" <<<"$2"
  sync -d -- "$1/manifest.json.new"
  mv -f -- "$1/manifest.json.new" "$1/manifest.json"
}

# begin_manifest: of the recording in $folder, from the options of scripts/record.
begin_manifest() {
  local text
  text=$(jq -n --arg name "${folder##*/}" --arg note "$note" --argjson start "$(instant "$EPOCHREALTIME")" \
    --arg host "$(uname -n)" --arg lcm_url "$lcm_url" --arg robot "$robot" \
    --arg lcm_version "$(dpkg-query -W -f '${Version}' liblcm-bin 2>/dev/null || true)" \
    --argjson source "$(source_version)" --slurpfile types <(message_types) \
    --slurpfile configuration <(configuration "$config_dir" "$robot_file") \
    --arg frames "$frames" --argjson split "${split:-null}" --argjson keep "${keep:-null}" --argjson min_free "$min_free" \
    '{format_version: 1, $name, $note, $start, end: null, ended_by: null, $host, $lcm_url, $robot, $lcm_version,
      $source, with_frames: ($frames == "yes"), split_mb: $split, keep_parts: $keep, min_free_mb: $min_free,
      types: $types[0], configuration: $configuration[0], logger: null, parts: [], parts_removed: 0, events: null,
      lost: null, damage: null, channels: null, gaps: []}') || return
  # A child that Ctrl-C ended leaves a text that is none.
  jq -e '.start.utime > 0' <<<"$text" >/dev/null || return
  write_manifest "$folder" "$text"
}

# begin_gap FROM STATUS REASON: notes in $folder's manifest that since FROM (as instant takes it) nothing is recorded, for
# that reason; STATUS as keep-logger exits. A thousand gaps are told one by one; after that the last one grows.
begin_gap() {
  local text exit_code signal=null
  exit_code=$(exit_code_of "$2")
  if ((exit_code > 128)); then signal=$((exit_code - 128)); fi
  text=$(jq --argjson from "$(instant "$1")" --argjson exit_code "$exit_code" --argjson signal "$signal" --arg reason "$3" \
    'if (.gaps | length) >= 1000 then .gaps[-1] |= (.to = null | .times += 1)
     else .gaps += [{$from, to: null, $exit_code, $signal, $reason, times: 1}] end' "$folder/manifest.json") || return
  write_manifest "$folder" "$text"
}

# end_gap TO: since TO it is recorded again.
end_gap() {
  local text
  text=$(jq --argjson to "$(instant "$1")" '.gaps[-1].to = $to' "$folder/manifest.json") || return
  write_manifest "$folder" "$text"
}

# gaps_of FOLDER: how long nothing was recorded, and why, in one line.
gaps_of() {
  jq -r '(.gaps | map(((.to // .from).utime - .from.utime) / 1e6) | add // 0) as $seconds |
    "\($seconds * 100 | round / 100) s are missing (" + (.gaps | map(.reason) | unique | join(", ")) + ")"' "$1/manifest.json"
}

# counts FOLDER: what log-tool finds in the recording; null where it cannot tell. A long recording takes minutes, which
# Ctrl-C ends, whatever it does here otherwise.
counts() {
  local status=0 report=''
  if [[ -z $(find "$1" -maxdepth 1 -name 'log.lcm*' -size +0) ]]; then
    echo '{"files": [], "channels": []}'
    return
  fi
  if [[ -x $log_tool ]]; then report=$(trap - INT TERM HUP; exec "$log_tool" info --json "$1" 2>/dev/null) || status=$?; fi
  # 1: it is damaged, and said where.
  if ((status > 1)) || ! jq -e 'type == "object"' <<<"$report" 2>/dev/null >&2; then report=null; fi
  printf '%s\n' "$report"
}

# complete_manifest FOLDER ENDED_BY END EXIT_CODE WORDS REMOVED: END as instant takes it, EXIT_CODE of lcm-logger (null:
# nobody saw it), WORDS what it said, REMOVED how many parts --keep has deleted.
complete_manifest() {
  local name text counted
  # Not beside jq: what bash runs beside something hears no Ctrl-C.
  counted=$(counts "$1")
  text=$(jq --arg ended_by "$2" --argjson ended "$(instant "$3")" --argjson exit_code "$4" --arg said "$5" --argjson removed "$6" \
    --slurpfile parts <(parts "$1" | while IFS= read -r name; do
      jq -cn --arg file "$name" --argjson bytes "$(stat -c %s -- "$1/$name")" '{$file, $bytes}'
    done | jq -cs .) \
    --slurpfile counts <(cat <<<"$counted") \
    '$counts[0] as $c | .gaps = [.gaps[]? | .to = (.to // $ended)] | .end = $ended | .ended_by = $ended_by | .logger = {$exit_code, $said} | .parts = $parts[0] |
      .parts_removed = $removed |
      if $c == null then . else
        .channels = $c.channels | .events = ($c.channels | map(.events) | add // 0) |
        .lost = ($c.channels | map(.lost // 0) | add // 0) |
        .damage = [$c.files[] | .path as $path | .damage[]? | {file: ($path | split("/") | last), offset, bytes}]
      end' \
    "$1/manifest.json")
  write_manifest "$1" "$text"
}

# told_of FOLDER: one line of what is in a completed recording.
told_of() {
  jq -r '(.parts | map(.bytes) | add // 0) as $bytes |
    "\((.end.utime - .start.utime) / 1e5 | round / 10) s, \($bytes / 1e5 | round / 10) MB in \(.parts | length) file(s)" +
    (if .events == null then ", not counted (scripts/log info counts)" else ", \(.events) messages on \(.channels | length) channels, \(.lost) lost" end) +
    (if (.gaps // []) == [] then "" else ", not recorded for \(.gaps | map((.to.utime - .from.utime) / 1e6) | add * 10 | round / 10) s" end) +
    (if (.damage // []) == [] then "" else ", torn at the end or damaged (scripts/log info tells where)" end)' \
    "$1/manifest.json"
}
