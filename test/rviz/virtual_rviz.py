"""rviz on a screen that nobody sees, and what is on it."""
import os
import shutil
import subprocess
import tempfile
import time

import numpy as np


def what_is_missing():
    """The programs that this needs and that are not there; empty if all are."""
    return ' and '.join(program for program in ('Xvfb', 'rosrun') if shutil.which(program) is None)


class VirtualRviz:
    """Xvfb and in it rviz, with a view. Close it."""

    def __init__(self, view, width=1000, height=900):
        self.folder = tempfile.TemporaryDirectory()
        self.processes = []
        try:
            environment = dict(os.environ, DISPLAY=self._start_screen(width, height), LIBGL_ALWAYS_SOFTWARE='1',
                               HOME=self.folder.name, XDG_RUNTIME_DIR=self.folder.name, QT_SCALE_FACTOR='1')
            self.rviz = self._start(['rosrun', 'rviz', 'rviz', '--display-config', view, '--splash-screen', ''],
                                    env=environment)
        except Exception:
            self.close()
            raise

    def _start(self, command, **options):
        self.processes.append(subprocess.Popen(command, **options))
        return self.processes[-1]

    def _start_screen(self, width, height):
        """Returns the screen's name; Xvfb takes a free number and writes it down."""
        read, write = os.pipe()
        self._start(['Xvfb', '-displayfd', str(write), '-screen', '0', '%dx%dx24' % (width, height),
                     '-fbdir', self.folder.name, '-nolisten', 'tcp'], pass_fds=[write])
        os.close(write)
        with os.fdopen(read) as numbers:
            number = numbers.readline().strip()
        if not number:
            raise AssertionError('Xvfb did not start')
        return ':' + number

    def wait_for(self, condition, what, seconds):
        """Waits until condition() gives something, and returns it. Fails at once if rviz ends."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            result = condition()
            if result:
                return result
            # Neither connections nor pixels notify of changes; the end of rviz does.
            try:
                raise AssertionError('rviz has ended with code %d' % self.rviz.wait(0.05))
            except subprocess.TimeoutExpired:
                pass
        raise AssertionError('waited %.0f s in vain for %s' % (seconds, what))

    def pixels(self):
        """The screen as rows x columns x (red, green, blue)."""
        # Xvfb keeps the screen in a file of the format XWD: a header of big-endian numbers, the color map, the pixels.
        data = np.fromfile(os.path.join(self.folder.name, 'Xvfb_screen0'), dtype=np.uint8)
        header = data[:100].view('>u4')
        header_size, width, height, bytes_per_line, colors = header[0], header[4], header[5], header[12], header[19]
        begin = header_size + 12 * colors
        lines = data[begin:begin + height * bytes_per_line].reshape(height, bytes_per_line)
        return lines[:, :4 * width].reshape(height, width, 4)[:, :, 2::-1]

    def close(self):
        for process in reversed(self.processes):
            process.terminate()
            try:
                process.wait(10.0)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        self.folder.cleanup()
