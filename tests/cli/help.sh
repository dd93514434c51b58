# SPDX-License-Identifier: LGPL-2.1-or-later
# Every help topic answers on standard output, with status 0 and nothing on standard error.
program=$1

# answers WORDS ARGUMENTS...
answers() {
  words=$1
  shift
  "$program" "$@" >out.txt 2>err.txt
  grep -q -- "$words" out.txt || { echo "'$words' is not in the output of: $*"; cat out.txt; exit 1; }
  [ ! -s err.txt ] || { cat err.txt; exit 1; }
}

answers 'whipple run SCENE' help
answers 'whipple run SCENE'
answers 'scene_files.md' help scene
answers 'studies.md' help study
answers '^## polygon' help shapes
answers 'body tags' help effects
answers 'aluminium' help materials
answers '^  noh: ' help 'exact solutions'
answers '^Whipple [0-9]' --version
answers '^  johnson-cook ' help effects
"$program" help models >models.md
diff -u "$2/doc/models.md" models.md || { echo "doc/models.md is stale: whipple help models > doc/models.md"; exit 1; }
"$program" help shapes >shapes.md
diff -u "$2/doc/shapes.md" shapes.md || { echo "doc/shapes.md is stale: whipple help shapes > doc/shapes.md"; exit 1; }
