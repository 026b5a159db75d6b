#!/usr/bin/env python3
"""Checks each verdict in a certificate against the text of its document.

    python3 scripts/check_cert.py [--quiet] DOCUMENT.md CERTIFICATE.json [DOCUMENT.md CERTIFICATE.json]…

Of several pairs each has a line with its document's name first.

Exit code 0: all accepted. 1: something was rejected. 2: something was unreadable.
"""

from check_cert.main import main

if __name__ == "__main__":
    main()
