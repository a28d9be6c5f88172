"""``python -m verification`` is the ``sensortrack`` command."""

import sys

from verification.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
