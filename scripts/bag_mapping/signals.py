"""What ends a process, held back until the process can take it."""
import contextlib
import signal

ENDING = (signal.SIGINT, signal.SIGTERM)


@contextlib.contextmanager
def held_back():
    """While a process is forked: it has its parent's handlers until it sets its own, and then calls let_through."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, ENDING)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def let_through():
    signal.pthread_sigmask(signal.SIG_UNBLOCK, ENDING)
