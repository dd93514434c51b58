# SPDX-License-Identifier: LGPL-2.1-or-later
# What wrong input must lead to; sourced by the scripts beside this folder. Needs $program.

# refuses WORDS COMMAND...: status 2 and one line on standard error that holds WORDS; what was said is in out.txt, err.txt
refuses() {
  words=$1
  shift
  status=0
  "$@" >out.txt 2>err.txt || status=$?
  [ "$status" -eq 2 ] || { echo "status $status, not 2: $*"; cat err.txt; exit 1; }
  [ "$(wc -l <err.txt)" -eq 1 ] || { echo "not one line: $*"; cat err.txt; exit 1; }
  grep -qF -- "$words" err.txt || { echo "'$words' is not in:"; cat err.txt; exit 1; }
}

# refuses_quietly WORDS COMMAND...: the same, and nothing on standard output
refuses_quietly() {
  refuses "$@"
  [ ! -s out.txt ] || { echo "output despite wrong input: $*"; exit 1; }
}

# refuses_settings WORDS SCENE SETTING...: a scene with these entries, each 'Section/Name = value'
refuses_settings() {
  expected=$1
  settings_of=$2
  shift 2
  for setting; do
    set -- "$@" --set "$setting"
    shift
  done
  refuses_quietly "$expected" "$program" run "$settings_of" --validate "$@"
}
