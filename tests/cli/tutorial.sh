# SPDX-License-Identifier: LGPL-2.1-or-later
# Every command of doc/tutorial.md runs, and shows what the page says.
/usr/bin/python3 -c 'import matplotlib, h5py' 2>/dev/null || exit 77
exec /usr/bin/python3 "$2/tests/cli/tutorial.py" "$1" "$2"
