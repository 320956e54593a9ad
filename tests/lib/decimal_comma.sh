# shellcheck shell=bash
# A language whose numbers have a comma, for tests. To be sourced.

# make_comma_locale FOLDER: compiles German there, for who has it not installed. With a blank in no path: localedef takes none.
make_comma_locale() {
  mkdir -p -- "$1"
  localedef --no-archive -i de_DE -f UTF-8 "$1/de_DE.UTF-8" >/dev/null
  comma_locales=$1
}

# with_commas COMMAND...: as somebody runs it who works in German; what this test has set for itself does not count.
with_commas() {
  env -u LC_NUMERIC -u LC_TIME -u LC_COLLATE -u LC_CTYPE LOCPATH="$comma_locales" LANG=de_DE.UTF-8 LANGUAGE=de LC_ALL=de_DE.UTF-8 "$@"
}

# with_points COMMAND...: likewise, without any language.
with_points() { env -u LC_NUMERIC -u LC_TIME -u LC_COLLATE -u LC_CTYPE -u LANGUAGE LANG=C LC_ALL=C "$@"; }
