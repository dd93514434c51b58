# SPDX-License-Identifier: LGPL-2.1-or-later
# The manual of the headers builds without a warning: every @param is one, every link leads somewhere.
command -v doxygen >/dev/null || { echo 'doxygen is not installed'; exit 77; }
# Doxygen makes references of the paths of its pages, and stops at a blank in them.
case "$2" in *' '*) echo "Doxygen cannot read pages under a path with a blank: $2"; exit 77 ;; esac
here=$(pwd)
cd "$2"
{ cat Doxyfile; echo "OUTPUT_DIRECTORY = $here"; } | doxygen - >/dev/null 2>"$here/warnings.txt"
[ ! -s "$here/warnings.txt" ] || { cat "$here/warnings.txt"; exit 1; }
[ -e "$here/html/index.html" ]
