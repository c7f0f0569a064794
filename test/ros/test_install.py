#!/usr/bin/env python3
"""Installs into a fresh prefix and uses the package from there: from outside, and as the examples in doc/ do."""
import os
import re
import signal
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET

import rospy
import rostest

import scene
from node_client import Clock, NodeClient

SOURCE = os.path.abspath(os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..'))
# What points at other workspaces than the installed one.
WORKSPACE_VARIABLES = ['CMAKE_PREFIX_PATH', 'LD_LIBRARY_PATH', 'PKG_CONFIG_PATH', 'PYTHONPATH', 'ROS_PACKAGE_PATH']


def files_below(folder):
    return sorted(os.path.relpath(os.path.join(at, name), folder) for at, _, names in os.walk(folder) for name in names)


class InstallTest(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.build = rospy.get_param('~build_folder')
        cls.folder = tempfile.TemporaryDirectory()
        # Not with --prefix: catkin's own files go to the prefix that it was configured with.
        cls.check(['cmake', '--install', cls.build], env=dict(os.environ, DESTDIR=cls.folder.name))
        cls.prefix = cls.folder.name + cls.configured_prefix()
        cls.share = os.path.join(cls.prefix, 'share', 'polygonal_perception')
        plain = {name: value for name, value in os.environ.items() if name not in WORKSPACE_VARIABLES}
        lines = cls.check(['bash', '-c', '. "$1/setup.bash" && env -0', 'bash', cls.prefix], env=plain).split('\0')
        cls.environment = dict(line.split('=', 1) for line in lines if line)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def configured_prefix(cls):
        with open(os.path.join(cls.build, 'CMakeCache.txt')) as cache:
            return next(line for line in cache if line.startswith('CMAKE_INSTALL_PREFIX:')).strip().split('=', 1)[1]

    @staticmethod
    def check(command, **kwargs):
        """Runs a command that has to succeed and returns what it printed."""
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True, **kwargs)
        if done.returncode != 0:
            raise AssertionError('%s ended with %d:\n%s' % (' '.join(command), done.returncode, done.stdout))
        return done.stdout

    def run_installed(self, *command):
        return self.check(list(command), env=self.environment)

    def build_outside(self, *path):
        """Builds a project of this folder against what is installed, and returns its build folder."""
        build = os.path.join(self.folder.name, path[-1])
        self.run_installed('cmake', '-S', os.path.join(SOURCE, *path), '-B', build)
        self.run_installed('cmake', '--build', build)
        return build

    def start(self, *command):
        process = subprocess.Popen(command, env=self.environment)

        def stop():
            process.send_signal(signal.SIGINT)
            process.wait()
        self.addCleanup(stop)

    def test_files(self):
        self.assertEqual(self.run_installed('rospack', 'find', 'polygonal_perception').strip(), self.share)
        for folder in ['launch', 'config', 'rviz', 'msg']:
            source, target = os.path.join(SOURCE, folder), os.path.join(self.share, folder)
            self.assertTrue(files_below(source), folder)
            missing = [name for name in files_below(source) if not os.path.exists(os.path.join(target, name))]
            if folder == 'rviz':  # its plugin's sources may lie beside the view
                missing = [name for name in missing if name.endswith('.rviz')]
            self.assertEqual(missing, [], folder)

    def test_headers(self):
        """Those of the rooms whose library was built, and what is generated for messages and services; no other."""
        headers = files_below(os.path.join(SOURCE, 'include', 'polygonal_perception'))
        self.assertTrue(headers)
        messages = [os.path.splitext(name)[0] + '.h' for name in files_below(os.path.join(SOURCE, 'msg'))]
        for name in files_below(os.path.join(SOURCE, 'srv')):
            messages += [os.path.splitext(name)[0] + part + '.h' for part in ('', 'Request', 'Response')]
        self.assertEqual(files_below(os.path.join(self.prefix, 'include', 'polygonal_perception')),
                         sorted([name for name in headers if self.is_built(os.path.dirname(name))] + messages))
        self.assertEqual(os.listdir(os.path.join(self.prefix, 'include')), ['polygonal_perception'])

    def is_built(self, folder):
        """Whether the library is that has its public headers in a folder below include/polygonal_perception."""
        if folder in ['', 'parameters']:  # headers are all that there is of them
            return True
        names = folder.split('/')
        library = {'cameras': names[1:2], 'ros': names[:2]}.get(names[0], names[:1])
        return os.path.exists(os.path.join(self.build, 'devel', 'lib', 'libpolygonal_perception_%s.so' % '_'.join(library)))

    def test_plugins(self):
        """Each library that a plugin description names is installed if it was built, and finds what it links with."""
        checked = 0
        for export in ET.parse(os.path.join(self.share, 'package.xml')).getroot().find('export'):
            description = export.get('plugin', '').replace('${prefix}', self.share)
            if not description:
                continue
            for library in ET.parse(description).getroot().iter('library'):
                name = library.get('path') + '.so'
                if not os.path.exists(os.path.join(self.build, 'devel', name)):
                    continue
                links = self.run_installed('ldd', os.path.join(self.prefix, name))
                self.assertNotIn('not found', links, name)
                checked += 1
        self.assertGreater(checked, 0)

    def test_programs(self):
        table = self.run_installed('rosrun', 'polygonal_perception', 'polygonal_perception_parameters')
        self.assertIn('| `robot_radius` |', table)
        message = self.run_installed('rosmsg', 'show', 'polygonal_perception/PolygonArray')
        for field in ['uint8 floor_status', 'float64 inflation_radius', 'geometry_msgs/Polygon extent']:
            self.assertIn(field, message)
        done = subprocess.run(['rosrun', 'polygonal_perception', 'map_from_bag', 'none.bag'], env=self.environment, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        self.assertEqual((done.returncode, done.stdout), (1, 'map_from_bag: none.bag: there is no such file\n'))

    def test_an_outside_project_links_the_core_library(self):
        output = self.run_installed(os.path.join(self.build_outside('test', 'outside_project'), 'outside_project'))
        height, *polygons = output.splitlines()
        self.assertAlmostEqual(float(height.replace('camera height', '')), 1.0, delta=0.01, msg=output)
        self.assertEqual([line.split()[0] for line in polygons], ['polygon'], output)
        numbers = [float(word) for word in polygons[0].split()[1:]]
        x, y = numbers[0::2], numbers[1::2]
        # The box's front is 2 m ahead and 0.4 m wide; robot_radius, a cell and the tolerance come on top.
        for what, got, bare in [('front', min(x), 2.0 - 0.3), ('right', min(y), -0.2 - 0.3), ('left', -max(y), -0.2 - 0.3)]:
            self.assertLessEqual(got, bare + 0.02, what + '\n' + output)
            self.assertGreater(got, bare - 0.15, what + '\n' + output)

    def test_the_documentation_shows_what_the_examples_do(self):
        with open(os.path.join(SOURCE, 'doc', 'consumers.md')) as page:
            blocks = re.findall(r'```(cpp|python)\n(.*?)```', page.read(), re.DOTALL)
        self.assertEqual([language for language, _ in blocks], ['cpp', 'python'])
        for language, code in blocks:
            name = {'cpp': 'is_free.cpp', 'python': 'is_free.py'}[language]
            with open(os.path.join(SOURCE, 'doc', 'examples', name)) as example:
                self.assertIn(code, example.read(), name)

    def test_examples(self):
        self.start('roslaunch', 'polygonal_perception', 'polygonal_perception.launch')
        client = NodeClient(['polygons'])
        build = self.build_outside('doc', 'examples')
        self.start(os.path.join(build, 'is_free'), '__name:=of_cpp')
        self.start(os.path.join(SOURCE, 'doc', 'examples', 'is_free.py'), '__name:=of_python')
        client.wait_for(lambda: len(self.readers()) >= 3, 'both examples to subscribe')
        camera, clock = scene.Camera(), Clock()
        views = [('blocked', camera.render([scene.Box((1.6, 2.0), (-0.3, 0.3), (0, 0.4))])),
                 ('free', camera.render([scene.Box((1.6, 2.0), (0.7, 1.1), (0, 0.4))])),
                 ('unknown', camera.render(floor=False))]
        for expected, depth in views:
            self.assertTrue(client.reset().success)
            for example in ['/of_cpp', '/of_python']:
                # The master lists a reader before it is connected: what it misses is asked once more.
                def says():
                    client.ask(camera.cloud(depth, clock.tick()))
                    return any(m.name == example and m.msg == '1.5 m ahead: ' + expected for m in list(client.logs))
                client.wait_for(says, '%s to say %s' % (example, expected))

    @staticmethod
    def readers():
        _, _, (_, subscribers, _) = rospy.get_master().getSystemState()
        return dict(subscribers).get('/polygonal_perception/polygons', [])


if __name__ == '__main__':
    rospy.init_node('test_install')
    rostest.rosrun('polygonal_perception', 'test_install', InstallTest, sys.argv)
