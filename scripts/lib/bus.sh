# shellcheck shell=bash disable=SC2034 # variables of the sourcing script
# The bus as the scripts know it: its address, and the services that are started on it. To be sourced after project.sh.

# ask_defaults FOLDER: sets what holds on the bus where nobody says otherwise, by the word of a program in FOLDER; all
# empty before it is built.
#   default_lcm_url, raw_frames_need (bytes of receive buffer), clock_tolerance_s (how far ahead a clock may be)
ask_defaults() {
  local name value
  default_lcm_url='' raw_frames_need='' clock_tolerance_s=''
  while IFS='=' read -r name value; do
    case $name in
      url) default_lcm_url=$value ;;
      raw-frames-need) raw_frames_need=$value ;;
      clock-tolerance-s) clock_tolerance_s=$value ;;
    esac
  done < <(MARKSERVO_LCM_URL='' LCM_DEFAULT_URL='' "$1/bus-census" --defaults 2>/dev/null) # what it refuses is no matter here
}
ask_defaults "${programs-$repository/build/release/bin}"

# The bus that the environment names, as programs and services take it: ours counts before the variable that all of LCM's
# own programs obey. Empty where neither names one.
named_lcm_url=${MARKSERVO_LCM_URL:-${LCM_DEFAULT_URL-}}

# told_by URL: " (the bus that LCM_DEFAULT_URL names)" where it is LCM's variable that names it: who set it for other
# programs may not think of ours.
told_by() {
  if [[ -n ${LCM_DEFAULT_URL-} && -z ${MARKSERVO_LCM_URL-} && $1 == "$LCM_DEFAULT_URL" ]]; then
    printf ' (the bus that LCM_DEFAULT_URL names)'
  fi
}

# is_multicast URL: whether others can hear what is said there; without an address it is the programs' own default.
is_multicast() { [[ ${1:-udpm://} == udpm://* ]]; }

# Profiles of scripts/stack: a file each with the services that it starts, a line each; a ? after one: where it is built.
profiles_dir=${default_config_dir-$repository/config}/profiles
if [[ ! -d $profiles_dir ]]; then profiles_dir=$repository/config/profiles; fi

# services_of PROFILE FOLDER: the services of a profile, as built in FOLDER, one a line; fails for a name that is none.
services_of() {
  [[ $1 =~ ^[a-z][a-z0-9-]*$ && -f $profiles_dir/$1 ]] || return 1
  local service
  awk '{ sub(/#.*/, "") } NF { print $1 }' "$profiles_dir/$1" | while IFS= read -r service; do
    if [[ $service != *\? || -x $2/bin/${service%\?} ]]; then printf '%s\n' "${service%\?}"; fi
  done
}

# profiles: their names, as a sentence has them.
profiles() { find "$profiles_dir" -maxdepth 1 -type f -printf '%f\n' | sort | paste -sd ' '; }
