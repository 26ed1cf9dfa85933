"""What every test run begins with."""

import signal

# Where a run was started with Ctrl-C ignored, as in the background of a shell, the processes that tests start would
# inherit that, and those that are interrupted would run on.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
