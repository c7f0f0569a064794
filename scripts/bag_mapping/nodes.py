"""A roscore and the nodes of one run: nobody else's, and gone with it."""
import contextlib
import os
import pathlib
import re
import signal
import socket
import subprocess
import time

import roslib.packages
import rosgraph

from bag_mapping.bag_reading import BagError

DEADLINE = 60.0  # [s] for what is to start or to answer, on a busy machine


def program(name):
    """The path of one of the package's programs."""
    found = roslib.packages.find_node('polygonal_perception', name)
    if not found:
        raise BagError('no program %s was built' % name)
    return found[0]


def wait_for(condition, what, alive=lambda: None):
    """Until condition() gives something, of which nobody is notified. alive() raises when there is nothing to wait for."""
    end = time.monotonic() + DEADLINE
    while True:
        result = condition()
        if result:
            return result
        alive()
        if time.monotonic() > end:
            raise BagError('waited %.0f s in vain for %s' % (DEADLINE, what))
        time.sleep(0.005)


@contextlib.contextmanager
def running(command, log):
    """A program, in a process group of its own: an interrupt key reaches it through us, when its turn has come."""
    process = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT, start_new_session=True)
    try:
        yield process
    finally:
        process.send_signal(signal.SIGINT)
        try:
            process.wait(10.0)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


class Nodes:
    """A roscore and programs that talk through it, until they are closed."""

    def __init__(self, folder):
        self._stack, self._programs = contextlib.ExitStack(), []
        self._log_path = folder / 'nodes.log'
        self._log = self._stack.enter_context(open(str(self._log_path), 'wb'))
        os.environ.update(ROS_HOSTNAME='localhost', ROS_LOG_DIR=str(folder), ROSCONSOLE_FORMAT='[${severity}] ${message}')
        for name in ('ROS_IP', 'ROS_NAMESPACE', 'ROSCONSOLE_STDOUT_LINE_BUFFERED'):
            os.environ.pop(name, None)

    def __enter__(self):
        try:
            self._start_master()
        except BaseException:
            self._stack.close()
            raise
        return self

    def __exit__(self, *_):
        self._stack.close()

    def _start_master(self):
        # Whoever else takes the port in between, rosmaster ends then.
        for _ in range(10):
            with socket.socket() as free:
                free.bind(('', 0))
                port = free.getsockname()[1]
            os.environ['ROS_MASTER_URI'] = 'http://localhost:%d' % port
            process = self._stack.enter_context(running(['rosmaster', '--core', '-p', str(port)], self._log))
            wait_for(lambda: process.poll() is not None or rosgraph.is_master_online(), 'roscore')
            if process.poll() is None:
                self._programs.append(('roscore', process))
                return
        raise BagError('roscore does not start: %s' % self.last_lines())

    def start(self, name, node, *remappings):
        command = [program(name), '__name:=' + node.strip('/')] + ['%s:=%s' % pair for pair in remappings]
        self._programs.append((node, self._stack.enter_context(running(command, self._log))))

    def check_alive(self):
        for name, process in self._programs:
            if process.poll() is not None:
                raise BagError('%s has ended with %d: %s' % (name, process.returncode, self.last_lines()))

    def last_lines(self, count=3):
        lines = [line.strip() for line in self._log_path.read_text(errors='replace').splitlines() if line.strip()]
        return ' / '.join(lines[-count:]) or 'it said nothing'

    def complaints(self, severities='WARN|ERROR|FATAL'):
        """What the nodes wrote as warnings and errors, each once."""
        plain = re.sub(r'\x1b\[[0-9;]*m', '', self._log_path.read_text(errors='replace'))
        found = re.findall(r'^\[(?:%s)\] (?:\[/\w+\] )?(.*)$' % severities, plain, re.MULTILINE)
        return list(dict.fromkeys(found))
