# SPDX-License-Identifier: LGPL-2.1-or-later
# Every source file is as .clang-format says, starts with its licence, and stays below 500 lines.
cd "$2"
find include source tests -name '*.h' -o -name '*.cc' | sort | xargs clang-format --dry-run --Werror
failed=0
for file in $(find include source tests -name '*.h' -o -name '*.cc' | sort); do
  head -n 1 "$file" | grep -q '^// SPDX-License-Identifier: LGPL-2.1-or-later$' || { echo "$file: no SPDX line"; failed=1; }
  [ "$(wc -l <"$file")" -lt 500 ] || { echo "$file: 500 lines or more"; failed=1; }
done
exit $failed
