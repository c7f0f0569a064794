"""A roscore and the nodes of one run: nobody else's, and gone with it."""
import os
import re
import signal
import subprocess
import time

import rosmaster.master

from bag_mapping.bag_reading import BagError

DEADLINE = 60.0  # [s] for what is to start or to answer, on a busy machine


def program(name):
    """The path of one of the package's programs. roslib would look through all of the package's folder, each time."""
    for prefix in os.environ.get('CMAKE_PREFIX_PATH', '').split(os.pathsep) + ['/usr']:
        path = os.path.join(prefix, 'lib', 'polygonal_perception', name)
        if os.access(path, os.X_OK):
            return path
    raise BagError('no program %s was built' % name)


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


class Nodes:
    """A roscore, in this process, and programs that talk through it, until they are closed."""

    def __init__(self, folder):
        self._programs, self._log_path = [], folder / 'nodes.log'
        self._log = open(str(self._log_path), 'wb')
        os.environ.update(ROS_HOSTNAME='localhost', ROS_LOG_DIR=str(folder), ROSCONSOLE_FORMAT='[${severity}] ${message}')
        for name in ('ROS_IP', 'ROS_NAMESPACE', 'ROSCONSOLE_STDOUT_LINE_BUFFERED'):
            os.environ.pop(name, None)
        self._master = rosmaster.master.Master(port=0)  # any that is free

    def __enter__(self):
        self._master.start()
        os.environ['ROS_MASTER_URI'] = self._master.uri
        return self

    def __exit__(self, *_):
        for _, process in self._programs:
            process.send_signal(signal.SIGINT)
        for _, process in self._programs:
            try:
                process.wait(10.0)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        self._master.stop()
        self._log.close()

    def start(self, name, node, *remappings):
        command = [program(name), '__name:=' + node.strip('/')] + ['%s:=%s' % pair for pair in remappings]
        # In a process group of its own: an interrupt key reaches it through us, when its turn has come.
        self._programs.append((node, subprocess.Popen(command, stdout=self._log, stderr=subprocess.STDOUT, start_new_session=True)))

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
