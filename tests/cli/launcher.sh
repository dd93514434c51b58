# SPDX-License-Identifier: LGPL-2.1-or-later
# Where the launcher builds, with stand-ins for the tools that build: a clone that was copied is configured anew, and one
# that may not be written into is used as it is built, or built in the user's own folder.
source=$2

mkdir tools clone
cp "$source/whipple" clone/whipple
cat >tools/cmake <<'END'
#!/bin/sh
while [ $# -gt 0 ]; do
  case $1 in -S) source=$2 ;; -B) build=$2 ;; esac
  shift
done
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$source" >"$build/CMakeCache.txt"
echo "configured for $source" >>"$LOG"
: >"$build/build.ninja"
END
cat >tools/ninja <<'END'
#!/bin/sh
printf '#!/bin/sh\necho "built in %s: $*"\n' "$2" >"$2/whipple"
chmod +x "$2/whipple"
END
printf '#!/bin/sh\necho installed\n' >tools/dpkg-query
chmod +x tools/*
export LOG="$PWD/log.txt" PATH="$PWD/tools:$PATH" HOME="$PWD/home"
unset XDG_CACHE_HOME WHIPPLE_SETTINGS

says() {
  folder=$1
  "$folder/whipple" run x >out.txt 2>err.txt || { cat err.txt; exit 1; }
  grep -qxF "$2" out.txt || { cat out.txt err.txt; exit 1; }
}
says clone "built in $PWD/clone/build: run x"
says clone "built in $PWD/clone/build: run x"
[ "$(wc -l <log.txt)" -eq 1 ] || { echo 'configured again:'; cat log.txt; exit 1; }

cp -r clone copy
says copy "built in $PWD/copy/build: run x"
grep -q 'made for another folder' err.txt
[ "$(tail -n 1 log.txt)" = "configured for $PWD/copy" ]

# as another user, since nothing is read-only for root
[ "$(id -u)" -eq 0 ] && command -v setpriv >/dev/null || exit 0
mkdir -m 777 home
cp -r clone bare
rm -r bare/build
chmod -R a+rX clone bare tools .
: >log.txt
chmod 666 log.txt
reach=$PWD
while [ "$reach" != / ]; do # other users must be able to come here
  [ -n "$(find "$reach" -maxdepth 0 -perm -001)" ] || exit 0
  reach=$(dirname "$reach")
done
as_user() {
  setpriv --reuid=65534 --regid=65534 --clear-groups "$1/whipple" run x >out.txt 2>err.txt || { cat err.txt; exit 1; }
}
as_user "$PWD/clone"
grep -qxF "built in $PWD/clone/build: run x" out.txt || { cat out.txt err.txt; exit 1; }
[ ! -s log.txt ]
as_user "$PWD/bare"
grep -qxF "built in $PWD/home/.cache/whipple$PWD/bare/build: run x" out.txt || { cat out.txt err.txt; exit 1; }
