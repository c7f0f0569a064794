"""Bags one after the other or side by side, each in a process of its own: a process can talk to one roscore only."""
import contextlib
import multiprocessing
import multiprocessing.connection
import os
import signal
import sys
import time
import traceback

from bag_mapping import signals
from bag_mapping.bag_reading import BagError
from bag_mapping.parameters import ParameterError
from bag_mapping.run import Run


class Progress:
    """A bar, where somebody watches."""

    def __init__(self, bags):
        self._bags, self._done, self._frames = bags, 0, {}
        self._shown = sys.stderr.isatty()
        self._begin = time.monotonic()

    def frames(self, path, done, total):
        self._frames[path] = (done, total)
        self._show()

    def bag_done(self, path):
        self._done += 1
        done, total = self._frames.pop(path, (0, 0))
        self._frames[None] = tuple(a + b for a, b in zip(self._frames.get(None, (0, 0)), (done, total)))
        self.clear()

    def clear(self):
        if self._shown:
            sys.stderr.write('\r\033[K')
            sys.stderr.flush()

    def _show(self):
        if not self._shown:
            return
        done, total = (sum(numbers) for numbers in zip(*self._frames.values()))
        bags = '' if self._bags == 1 else ', %d of %d bags done' % (self._done, self._bags)
        rate = done / max(time.monotonic() - self._begin, 1e-3)
        sys.stderr.write('\r[%-40s] %d of %d frames, %.0f a second%s\033[K' % ('#' * (40 * done // max(total, 1)), done, total, rate, bags))
        sys.stderr.flush()


def work(path, options, pipe, ends_of_others):
    """In the bag's own process."""
    for end in ends_of_others:
        end.close()  # or nobody would notice that the reader has gone

    def stop(*_):
        # Once: what is cleaned up then is not to be interrupted.
        for number in signals.ENDING:
            signal.signal(number, lambda *_: None)
        raise KeyboardInterrupt
    for number in signals.ENDING:
        signal.signal(number, stop)
    signals.let_through()
    last = 0.0

    def progress(done, total):
        nonlocal last
        now = time.monotonic()
        if now - last > 0.1 or done == total:
            last = now
            pipe.send(('frames', done, total))  # fails when nobody is there any more
    try:
        result = ('done', Run(path, options, progress).make())
    except (BagError, ParameterError, OSError) as error:
        result = ('failed', str(error))
    except KeyboardInterrupt:
        result = ('failed', 'interrupted')
    except Exception:
        result = ('failed', traceback.format_exc())
    with contextlib.suppress(BrokenPipeError):
        pipe.send(result)
    # rospy's threads have nothing more to say, and its shutdown would wait for a roscore that is gone.
    os._exit(0)


def run_all(paths, options):
    """Makes all maps, at most options.jobs at once. Prints what became of each; whether all were made."""
    processes = multiprocessing.get_context('fork')  # newer Pythons would begin anew
    progress, waiting, running, good = Progress(len(paths)), list(paths), {}, True
    try:
        while waiting or running:
            while waiting and len(running) < options.jobs:
                path = waiting.pop(0)
                pipe, other = processes.Pipe(duplex=False)
                process = processes.Process(target=work, args=(path, options, other, [pipe, *running]))
                with signals.held_back():
                    process.start()
                    running[pipe] = (path, process)
                other.close()
            for pipe in multiprocessing.connection.wait(list(running)):
                path, process = running[pipe]
                try:
                    kind, *content = pipe.recv()
                except EOFError:
                    kind, content = 'failed', ['its process ended without a word']
                if kind == 'frames':
                    progress.frames(path, *content)
                    continue
                process.join()
                del running[pipe]
                progress.bag_done(path)
                if kind == 'done':
                    print(content[0], flush=True)
                else:
                    good = False
                    print('map_from_bag: %s: %s' % (path, content[0]), file=sys.stderr, flush=True)
    finally:
        for _, process in running.values():
            process.terminate()
        for _, process in running.values():
            process.join()
        progress.clear()
    return good
