#!/usr/bin/env python3
"""Launch files and their managers end cleanly: with exit code 0 of roslaunch and of all that it started, and without a core file."""
import glob
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
import unittest

import rospy
import rostest
from nodelet.srv import NodeletList

from launched import Launched
from node_client import DEADLINE, NodeClient

MANAGER = 'camera_manager-1'  # as roslaunch numbers what it starts
NODELETS = {'/simulated_camera', '/polygonal_perception'}
PROCESSES = 3  # the manager, a loader for the camera, one for the pipeline
# roslaunch says only in its debug log how a process ended that ended by itself while it was about to be told to.
LOGGING = '''{version: 1, disable_existing_loggers: false, formatters: {plain: {format: "%(message)s"}},
  handlers: {console: {class: logging.StreamHandler, formatter: plain}},
  root: {level: DEBUG, handlers: [console]}}
'''
STARTED = re.compile(r'process\[(\S+)\]: started with pid \[(\d+)\]')
ENDED = [re.compile(r'process\[(\S+)\]: SIG(?:INT|TERM) killed with return value (-?\d+)'),
         re.compile(r'process\[(\S+)\]\.stop\(\): process has already returned (-?\d+)'),
         re.compile(r'\[([^\s[]+)\] process has died \[pid \d+, exit code (-?\d+)')]


class Interrupted(Launched):
    """A launch file in a folder of its own, to which its output and its core files go."""

    def __init__(self, folder, name, **args):
        super().__init__(name, **args)
        config = os.path.join(folder, 'logging.yaml')
        with open(config, 'w') as file:
            file.write(LOGGING)
        self.environment.update(ROS_HOME=folder, ROS_LOG_DIR=folder, ROS_PYTHON_LOG_CONFIG_FILE=config, PYTHONUNBUFFERED='1')
        self.folder = folder

    def __enter__(self):
        with open(self.path(), 'w') as output:
            self.process = subprocess.Popen(self.command, env=self.environment, stdout=output, stderr=subprocess.STDOUT,
                                            preexec_fn=self.allow_core_files)
        return self

    def path(self):
        return os.path.join(self.folder, 'output.txt')

    @staticmethod
    def allow_core_files():
        _, most = resource.getrlimit(resource.RLIMIT_CORE)
        resource.setrlimit(resource.RLIMIT_CORE, (most, most))

    def output(self):
        with open(self.path(), errors='replace') as file:
            return file.read()

    def pids(self):
        """Of what it started, by name."""
        return {name: int(pid) for name, pid in STARTED.findall(self.output())}

    def exit_codes(self):
        """(name, code) of what has ended."""
        output = self.output()
        return sorted({(name, int(code)) for pattern in ENDED for name, code in pattern.findall(output)})

    def core_files(self):
        """Where the kernel puts them into the process's folder."""
        return glob.glob(os.path.join(self.folder, 'core*'))


class InterruptedLaunchTest(unittest.TestCase):
    def setUp(self):
        self.respawn = rospy.get_param('~respawn')

    @staticmethod
    def all_is_loaded():
        try:
            return NODELETS <= set(rospy.ServiceProxy('/camera_manager/list', NodeletList)().nodelets)
        except rospy.ServiceException:
            return False

    @staticmethod
    def bonds():
        """The programs that keep bonds with the manager. What a bond does in the end depends on the nodelets' names, too."""
        publishers = dict(rospy.get_master().getSystemState()[2][0])
        return publishers.get('/camera_manager/bond', [])

    def live(self, folder, at_once, end_manager):
        """Starts a camera and the pipeline in a manager, ends them, and returns what was not clean, and the exit codes."""
        with Interrupted(folder, 'demo.launch', rviz='false', rate='10',
                         respawn='true' if self.respawn else 'false') as launch:
            client = NodeClient(outputs=(), runs=False)
            if at_once:
                client.wait_for(self.all_is_loaded, 'the nodelets in their manager', 2 * DEADLINE)
            else:
                client.read('floor')
                client.wait_for(lambda: client.answers, 'a floor', 2 * DEADLINE)
            bonds = self.bonds()
            if end_manager:
                os.kill(launch.pids()[MANAGER], signal.SIGINT)
                client.wait_for(lambda: MANAGER in dict(launch.exit_codes()), 'the manager to end')
                if self.respawn:
                    client.wait_for(self.all_is_loaded, 'the nodelets to come back', 2 * DEADLINE)
            client.close()
            # As from a terminal: what roslaunch starts has a process group of its own, and is told by roslaunch.
            code = launch.end()
        codes = launch.exit_codes()
        problems = ['roslaunch ended with %d' % code] if code else []
        problems += ['%s ended with %d' % item for item in codes if item[1] != 0]
        problems += ['there is a core file' for _ in launch.core_files()]
        if len(launch.pids()) != PROCESSES or set(launch.pids()) != set(dict(codes)):
            problems.append('%s were started and %s ended, expected %d' % (sorted(launch.pids()), codes, PROCESSES))
        if bool(bonds) != self.respawn:
            problems.append('there are bonds of %s, expected %s' % (bonds or 'none', 'some' if self.respawn else 'none'))
        if problems:
            print('%s\n%s' % ('; '.join(problems), launch.output()))
        return problems, codes

    def check(self, at_once, end_manager=False):
        launches = rospy.get_param('~launches')
        ends = []
        for _ in range(launches):
            with tempfile.TemporaryDirectory() as folder:
                ends.append(self.live(folder, at_once, end_manager))
        aborts = sum(-signal.SIGABRT in [code for _, code in codes] for _, codes in ends)
        bad = ['launch %d: %s' % (k, '; '.join(problems)) for k, (problems, _) in enumerate(ends) if problems]
        summary = '%d of %d launches ended cleanly, in %d a process aborted' % (launches - len(bad), launches, aborts)
        print('%s: %s' % (self.id().split('.')[-1], summary))
        self.assertFalse(bad, '%s; expected exit code 0 of every process, saw\n%s' % (summary, '\n'.join(bad)))

    def test_ctrl_c_after_an_answer(self):
        self.check(at_once=False)

    def test_ctrl_c_as_soon_as_all_is_loaded(self):
        self.check(at_once=True)

    def test_the_manager_ends_before_its_loaders(self):
        """As by rosnode kill, or where it belongs to a driver's launch file."""
        self.check(at_once=True, end_manager=True)


if __name__ == '__main__':
    rospy.init_node('test_interrupted_launch')
    rostest.rosrun('polygonal_perception', 'test_interrupted_launch', InterruptedLaunchTest, sys.argv)
