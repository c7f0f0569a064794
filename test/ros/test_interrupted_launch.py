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
    def setUp(self):
        self.args = {'respawn': 'true' if rospy.get_param('~respawn') else 'false'}

    @staticmethod
    def wait_for_a_floor(launch):
        client = NodeClient(outputs=(), runs=False)
        client.read('floor')
        client.wait_for(lambda: client.answers or launch.process.poll() is not None, 'a floor', 2 * DEADLINE)
        client.close()

    @staticmethod
    def interrupt(launch, count):
        """Ends a launch that has started so many processes, and returns what was not clean, and the exit codes."""
        # As from a terminal: what roslaunch starts has a process group of its own, and is told by roslaunch.
        code = launch.end()
        codes = launch.exit_codes()
        problems = ['roslaunch ended with %d' % code] if code else []
        problems += ['%s ended with %s' % item for item in codes.items() if item[1] != 0]
        problems += ['there is a core file' for _ in launch.core_files()]
        if len(codes) != count:
            problems.append('%s were started, expected %d' % (sorted(codes), count))
        if problems:
            print('%s\n%s' % ('; '.join(problems), launch.output()))
        return problems, codes

    def check(self, live, what):
        launches = rospy.get_param('~launches')
        ends = []
        for _ in range(launches):
            with tempfile.TemporaryDirectory() as folder:
                ends.append(live(folder))
        aborts = sum(-6 in codes.values() for _, codes in ends)
        bad = ['launch %d: %s' % (k, '; '.join(problems)) for k, (problems, _) in enumerate(ends) if problems]
        summary = '%s: %d of %d ended cleanly, in %d a process aborted' % (what, launches - len(bad), launches, aborts)
        print(summary)
        self.assertFalse(bad, '%s; expected exit code 0 of every process, saw\n%s' % (summary, '\n'.join(bad)))

    def test_camera_and_pipeline_in_one_launch(self):
        def live(folder):
            with Interrupted(folder, 'demo.launch', rviz='false', rate='10', **self.args) as launch:
                self.wait_for_a_floor(launch)
                return self.interrupt(launch, 3)
        self.check(live, 'one launch')

    def test_the_camera_ends_before_the_pipeline(self):
        """The pipeline's own launch is still there when the manager ends, as where a driver was started elsewhere."""
        def live(folder):
            other = os.path.join(folder, 'pipeline')
            os.mkdir(other)
            with Interrupted(folder, 'simulated_camera.launch', scene='office', trajectory='robotino', seed='1', rate='10',
                             respawn='false') as camera, \
                    Interrupted(other, 'polygonal_perception.launch', manager='camera_manager', **self.args) as pipeline:
                self.wait_for_a_floor(pipeline)
                problems, codes = self.interrupt(camera, 2)
                more_problems, _ = self.interrupt(pipeline, 1)
                return problems + more_problems, codes
        self.check(live, "the camera's launch before the pipeline's")


if __name__ == '__main__':
    rospy.init_node('test_interrupted_launch')
    rostest.rosrun('polygonal_perception', 'test_interrupted_launch', InterruptedLaunchTest, sys.argv)
