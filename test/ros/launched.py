"""Programs that run as long as a context lasts."""
import os
import signal
import subprocess

import roslib.packages


def program(name):
    """The path of one of the package's programs.

    rosrun asks which one where the sources hold more than one build, and does not look into a folder `build` of theirs.
    """
    found = roslib.packages.find_node('polygonal_perception', name)
    assert found, 'no program %s was built' % name
    return found[0]


NODE = program('polygonal_perception_node')


class Started:
    """A command, ended by the interrupt key's signal."""

    def __init__(self, *command, **environment):
        self.command, self.environment = command, dict(os.environ, **environment)

    def __enter__(self):
        self.process = subprocess.Popen(self.command, env=self.environment)
        return self

    def __exit__(self, *_):
        self.end()

    def end(self):
        """As often as one likes; returns the exit code."""
        self.process.send_signal(signal.SIGINT)
        return self.process.wait()

    def crash(self):
        self.process.kill()
        self.process.wait()


class Launched(Started):
    """A launch file of this package."""

    def __init__(self, name, **args):
        super().__init__('roslaunch', 'polygonal_perception', name, *('%s:=%s' % item for item in args.items()))


class Manager(Started):
    """A nodelet manager."""

    def __init__(self, name, namespace='/'):
        super().__init__('rosrun', 'nodelet', 'nodelet', 'manager', '__name:=' + name, '__ns:=' + namespace)
