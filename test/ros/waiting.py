"""Waits for what callbacks bring."""
import time

DEADLINE = 20.0  # [s]


def wait_for(changed, condition, what, deadline=DEADLINE, seen=lambda: ''):
    """Waits until condition() gives something, and returns it.

    changed is the threading.Condition that callbacks notify; connections come and go without. When it takes too long the error
    has what was seen instead.
    """
    end = time.monotonic() + deadline
    with changed:
        while True:
            result = condition()
            if result:
                return result
            if time.monotonic() > end:
                raise AssertionError('waited %.0f s in vain for %s%s' % (deadline, what, seen()))
            changed.wait(0.05)
