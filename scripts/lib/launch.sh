# shellcheck shell=bash disable=SC2154 # variables of the sourcing script
# How each service of a stack is run: from the options that it was started with, those given now on top, and asked of
# the service itself before anything is changed. To be sourced after supervision.sh; works on scripts/stack's variables:
# given (options by name), extra_arguments (text by service) and runtime_dir.
# In the runtime folder: launch/SERVICE, a script that runs it; options/SERVICE, what that was made from. What is not yet
# decided is in launch.new and options.new.

# load_options FILE NAME: reads the options in FILE, where there is one, into the associative array NAME.
load_options() {
  local -n __into=$2
  local __key __value
  if [[ ! -f $1 ]]; then return 0; fi
  while IFS='=' read -r -d '' __key __value; do __into["$__key"]=$__value; done <"$1"
}

# keep_options FILE NAME: the other way round.
keep_options() {
  local -n __from=$2
  local __key
  for __key in "${!__from[@]}"; do printf '%s=%s\0' "$__key" "${__from[$__key]}"; done >"$1"
}

# stack_options NAME: how the whole stack is run, into the associative array NAME: as it was started, or, where there is
# none, by default.
stack_options() {
  local -n __options=$1
  __options=([build_dir]=$default_build_dir [config_dir]=$default_config_dir
    [robot_file]=$default_config_dir/robot.yaml [robot]='' [lcm_url]=$named_lcm_url [profile]=sim)
  load_options "$runtime_dir/options/stack" "$1"
}

# words_of SERVICE TEXT: TEXT as a shell would split it, one word a line.
words_of() {
  # xargs splits at spaces and takes quotes off as a shell does, without running anything.
  xargs -r printf '%s\n' <<<"$2" || fail_with 2 "--args $1: quotes do not match"
}

# merged_arguments OLD NEW: arguments, one a line: those of OLD, but options that NEW names too, then NEW.
merged_arguments() {
  local line name keep=yes
  local -A anew=()
  while IFS= read -r line; do
    if [[ $line == --* ]]; then anew[${line%%=*}]=yes; fi
  done <<<"$2"
  while IFS= read -r line; do
    # An option's value goes with it.
    if [[ $line == --* ]]; then
      name=${line%%=*}
      keep=${anew[$name]:+no}
    fi
    if [[ -n $line && ${keep:-yes} == yes ]]; then printf '%s\n' "$line"; fi
  done <<<"$1"
  if [[ -n $2 ]]; then printf '%s\n' "$2"; fi
}

# check_executable FOLDER SERVICE
check_executable() {
  [[ -x $1/bin/$2 ]] || fail "$1/bin/$2 does not exist: run $get_programs"
}

# plan_launch SERVICE: writes how the next start of SERVICE shall run it.
plan_launch() {
  local service=$1 key words scene arguments=()
  local -A options=()
  stack_options options
  load_options "$runtime_dir/options/$service" options
  for key in "${!given[@]}"; do options[$key]=${given[$key]}; done
  if [[ -v extra_arguments[$service] ]]; then
    words=$(words_of "$service" "${extra_arguments[$service]}") || exit
    # None at all takes off those that there were.
    if [[ -n $words ]]; then words=$(merged_arguments "${options[args]-}" "$words"); fi
    options[args]=$words
  fi
  check_executable "${options[build_dir]}" "$service"
  [[ -f ${options[robot_file]} ]] || fail_with 2 "--robot-file ${options[robot_file]}: no such file"
  if [[ -f ${options[config_dir]}/$service.conf ]]; then arguments+=(--config "${options[config_dir]}/$service.conf"); fi
  arguments+=(--robot-file "${options[robot_file]}")
  # A scene belongs to the settings beside it; the project's own is the simulator's default.
  scene=${options[config_dir]}/scenes/shelf.yaml
  if [[ $service == simulator && -f $scene && ${options[config_dir]} != "$repository/config" ]] &&
    ! grep -qE '^--scene(=|$)' <<<"${options[args]-}"; then
    arguments+=(--scene "$scene")
  fi
  # Where scripts/page finds it: in a folder that its user alone can enter.
  if [[ $service == mmi ]] && ! grep -qE '^--listen(=|$)' <<<"${options[args]-}"; then
    arguments+=(--listen "$runtime_dir/page.sock")
  fi
  # One for each start of the stack, whatever mmi's own restarts are; scripts/page gives it to the browser.
  if [[ $service == mmi ]] && grep -qxE -- '--enable-commands' <<<"${options[args]-}" &&
    ! grep -qE '^--command-token-file(=|$)' <<<"${options[args]-}"; then
    arguments+=(--command-token-file "$runtime_dir/page.token")
  fi
  if [[ -n ${options[robot]} ]]; then arguments+=(--robot "${options[robot]}"); fi
  if [[ -n ${options[lcm_url]} ]]; then arguments+=(--lcm-url "${options[lcm_url]}"); fi
  if [[ -n ${options[args]-} ]]; then mapfile -t -O ${#arguments[@]} arguments <<<"${options[args]}"; fi
  keep_options "$runtime_dir/options.new/$service" options
  write_launch "$service" "${options[build_dir]}/bin/$service" "${arguments[@]}"
}

# write_launch SERVICE COMMAND [ARGUMENT...]
write_launch() {
  local service=$1
  shift
  # A file of its own spares the arguments supervisor's rules for %, quotes and comments.
  printf '# How scripts/stack runs %s.\ncd %q\nif (($# == 0)); then source %q %q; fi\nexec %s "$@"\n' "$service" "$repository" \
    "$repository/scripts/lib/pause-before-start.sh" "$runtime_dir/starts/$service" "${*@Q}" \
    >"$runtime_dir/launch.new/$service"
}

# plan_watch: how stack-watch shall be run; false where there is none.
plan_watch() {
  local -A options=()
  stack_options options
  local key url
  for key in "${!given[@]}"; do options[$key]=${given[$key]}; done
  url=${options[lcm_url]:-$default_lcm_url}
  if [[ $watched == no || ! -x ${options[build_dir]}/bin/stack-watch ]] || ! is_multicast "$url"; then return 1; fi
  local arguments=(${url:+--lcm-url "$url"} --supervisor "$runtime_dir/supervisor.sock" --socket "$runtime_dir/watch.sock")
  if [[ -n ${options[robot]} ]]; then arguments+=(--robot "${options[robot]}"); fi
  write_launch stack-watch "${options[build_dir]}/bin/stack-watch" "${arguments[@]}"
}

# plan_launches SERVICE...: plans all of them and lets each say whether it would run so. If one would not, this says what
# they object to, forgets the plan and ends the script: nothing was changed.
plan_launches() {
  local service pids=() bad=no
  forget_plan
  mkdir -- "$runtime_dir/launch.new" "$runtime_dir/options.new"
  for service; do plan_launch "$service"; done
  # Side by side: each reads its files, and there are as many cores as there are.
  for service; do
    timeout --foreground 30 bash "$runtime_dir/launch.new/$service" --check \
      >"$runtime_dir/launch.new/$service.said" 2>&1 </dev/null 9>&- &
    pids+=($!)
  done
  for service; do
    if ! wait "${pids[0]}"; then
      bad=yes
      tail -n 3 -- "$runtime_dir/launch.new/$service.said" >&2
      warn "$service would not run so"
    fi
    pids=("${pids[@]:1}")
    rm -f -- "$runtime_dir/launch.new/$service.said"
  done
  if [[ $bad == yes ]]; then
    forget_plan
    fail_with 2 "nothing was changed"
  fi
}

forget_plan() { rm -rf -- "${runtime_dir:?}/launch.new" "${runtime_dir:?}/options.new"; }

# carry_out_plan: from now on the services are run as planned.
carry_out_plan() {
  mkdir -p -- "$runtime_dir/launch" "$runtime_dir/options" "$runtime_dir/starts"
  find "$runtime_dir/launch.new" -type f -exec mv -ft "$runtime_dir/launch" -- {} +
  find "$runtime_dir/options.new" -type f -exec mv -ft "$runtime_dir/options" -- {} +
  forget_plan
}

# remember_stack: from now on this call's options are the whole stack's.
remember_stack() {
  local key
  local -A options=()
  stack_options options
  for key in "${!given[@]}"; do options[$key]=${given[$key]}; done
  mkdir -p -- "$runtime_dir/options"
  keep_options "$runtime_dir/options/stack" options
}
