"""Run the command as ``python -m stochgeom``."""

import sys

from stochgeom.cli.main import main

sys.exit(main())
