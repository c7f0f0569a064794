#!/usr/bin/env python3
"""Ctrl-C ends a launch file cleanly: with exit code 0 of roslaunch and of all that it started, and without a core file."""
import glob
import os
import re
import resource
import subprocess
import sys
import tempfile
import unittest

import rospy
import rostest

from launched import Launched
from node_client import DEADLINE, NodeClient

# roslaunch says only in its debug log how a process ended that ended by itself while it was about to be told to.
LOGGING = '''{version: 1, disable_existing_loggers: false, formatters: {plain: {format: "%(message)s"}},
  handlers: {console: {class: logging.StreamHandler, formatter: plain}},
  root: {level: DEBUG, handlers: [console]}}
'''
STARTED = re.compile(r'process\[(\S+)\]: started with pid')
ENDED = [re.compile(r'process\[(\S+)\]: SIG(?:INT|TERM) killed with return value (-?\d+)'),
         re.compile(r'process\[(\S+)\]\.stop\(\): process has already returned (-?\d+)'),
         re.compile(r'\[(\S+)\] process has died \[pid \d+, exit code (-?\d+)')]


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

    def exit_codes(self):
        """Those of what it started, by name; None where roslaunch does not know."""
        output = self.output()
        codes = dict.fromkeys(STARTED.findall(output))
        for pattern in ENDED:
            codes.update((name, int(code)) for name, code in pattern.findall(output))
        return codes

    def core_files(self):
        """Where the kernel puts them into the process's folder."""
        return glob.glob(os.path.join(self.folder, 'core*'))


class InterruptedLaunchTest(unittest.TestCase):
    def interrupt(self):
        """What was not clean about one launch, and the exit codes."""
        with tempfile.TemporaryDirectory() as folder:
            with Interrupted(folder, 'demo.launch', rviz='false', rate='10', respawn=self.respawn) as launch:
                client = NodeClient(outputs=(), runs=False)
                client.read('floor')
                client.wait_for(lambda: client.answers or launch.process.poll() is not None, 'a floor', 2 * DEADLINE)
                # As from a terminal: what roslaunch starts has a process group of its own, and is told by roslaunch.
                code = launch.end()
                client.close()
            codes = launch.exit_codes()
            problems = ['roslaunch ended with %d' % code] if code else []
            problems += ['%s ended with %s' % item for item in codes.items() if item[1] != 0]
            problems += ['there is a core file' for _ in launch.core_files()]
            if len(codes) < 3:
                problems.append('only %s started, expected a manager, a camera and the pipeline' % sorted(codes))
            if problems:
                print('%s\n%s' % ('; '.join(problems), launch.output()))
            return problems, codes

    def test_all_that_was_started_ends_with_0(self):
        self.respawn = 'true' if rospy.get_param('~respawn') else 'false'
        launches = rospy.get_param('~launches')
        ends = [self.interrupt() for _ in range(launches)]
        aborts = sum(-6 in codes.values() for _, codes in ends)
        bad = ['launch %d: %s' % (k, '; '.join(problems)) for k, (problems, _) in enumerate(ends) if problems]
        summary = '%d of %d launches ended cleanly, in %d a process aborted' % (launches - len(bad), launches, aborts)
        print(summary)
        self.assertFalse(bad, '%s; expected exit code 0 of every process, saw\n%s' % (summary, '\n'.join(bad)))


if __name__ == '__main__':
    rospy.init_node('test_interrupted_launch')
    rostest.rosrun('polygonal_perception', 'test_interrupted_launch', InterruptedLaunchTest, sys.argv)
