# SPDX-License-Identifier: LGPL-2.1-or-later
# Links and paths in the documents lead somewhere, and every source that is cited is in doc/references.bib.
/usr/bin/python3 "$2/scripts/check_documents.py"
