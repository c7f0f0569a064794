#!/usr/bin/env python3
"""openni2.launch with each of its drivers, on the virtual device, and the choice between them.

Where openni2_launch is installed, that is what runs, with openni2_camera; else a stand-in for it."""
import functools
import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

import rospkg
import rospy
import rostest
from geometry_msgs.msg import TransformStamped
from nodelet.srv import NodeletList, NodeletLoad
from sensor_msgs.msg import CameraInfo, Image, PointCloud2
from tf2_msgs.msg import TFMessage

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path.insert(0, os.path.join(HERE, '..', 'ros'))
from launched import Started  # noqa: E402
from node_client import DEADLINE, FOUND, NodeClient  # noqa: E402

STAND_IN = os.path.join(HERE, 'openni2_launch_stand_in.xml')
CHOICE = os.path.join(HERE, '..', '..', 'scripts', 'openni2_driver')
MANAGER = '/camera/camera_nodelet_manager'
PACKAGE = '''<package format="2">
  <name>openni2_launch</name> <version>0.0.0</version> <description>a stand-in</description>
  <maintainer email="nobody@localhost">nobody</maintainer> <license>BSD-3-Clause</license>
</package>
'''
CALIBRATION = '''
image_width: 320
image_height: 240
camera_name: depth_VIRTUAL0001
camera_matrix: {rows: 3, cols: 3, data: [280.0, 0, 161.0, 0, 281.0, 121.0, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0.01, 0, 0, 0, 0]}
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
projection_matrix: {rows: 3, cols: 4, data: [280.0, 0, 161.0, 0, 0, 281.0, 121.0, 0, 0, 0, 1, 0]}
'''


def has_openni2_launch():
    try:
        return bool(rospkg.RosPack().get_path('openni2_launch'))
    except rospkg.ResourceNotFound:
        return False


def loads(nodelet):
    """Whether a nodelet of another package can be loaded at all."""
    with Started('rosrun', 'nodelet', 'nodelet', 'manager', '__name:=probe'):
        rospy.wait_for_service('/probe/load_nodelet', DEADLINE)
        try:
            return rospy.ServiceProxy('/probe/load_nodelet', NodeletLoad)(name='/probed', type=nodelet).success
        except rospy.ServiceException:
            return False


def needs_image_nodelets(test):
    """Debian 11 describes the nodelets of depth_image_proc and image_proc so that nobody finds their library."""
    @functools.wraps(test)
    def checked(self):
        if not self.has_image_nodelets:
            self.skipTest('the nodelets of depth_image_proc do not load')
        test(self)
    return checked


class OpenNI2DriversTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.has_image_nodelets = loads('depth_image_proc/point_cloud_xyz')
        if not cls.has_image_nodelets:
            rospy.logwarn('skipped: what needs the nodelets of depth_image_proc, which do not load here')

    def setUp(self):
        runtime = rospy.get_param('~runtime')
        self.plug = os.path.join(runtime, 'plug_of_drivers')
        self.put_in()
        self.addCleanup(os.remove, self.plug)
        self.environment = {
            'LD_LIBRARY_PATH': os.pathsep.join([runtime, os.environ.get('LD_LIBRARY_PATH', '')]),
            'POLYGONAL_PERCEPTION_VIRTUAL_PLUG': self.plug,
        }

    def put_in(self):
        open(self.plug, 'w').close()

    def install_openni2_launch(self):
        if has_openni2_launch():
            return
        # Not in this package's folder, where roslaunch would find two files of one name.
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        package = os.path.join(folder.name, 'openni2_launch')
        os.makedirs(os.path.join(package, 'launch'))
        with open(os.path.join(package, 'package.xml'), 'w') as file:
            file.write(PACKAGE)
        shutil.copy(STAND_IN, os.path.join(package, 'launch', 'openni2.launch'))
        self.environment['ROS_PACKAGE_PATH'] = os.pathsep.join([os.environ['ROS_PACKAGE_PATH'], folder.name])

    def launch(self, name='openni2.launch', package='polygonal_perception', **args):
        command = ['roslaunch', package, name] + ['%s:=%s' % item for item in args.items()]
        program = Started(*command, **self.environment)
        program.__enter__()
        self.addCleanup(program.__exit__)

    def place(self, *frames):
        """What a robot's own driver publishes: each frame at the origin of the one before, the first at odom's."""
        self.tf = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
        transforms = [TransformStamped(child_frame_id=frame) for frame in frames]
        for transform, parent in zip(transforms, ('odom',) + frames):
            transform.header.frame_id = parent
            transform.transform.rotation.w = 1.0
        self.tf.publish(TFMessage(transforms))
        self.addCleanup(self.tf.unregister)

    def check_polygons(self, frame='camera_depth_optical_frame'):
        """The floor is found in frames of the device, by our nodelet in the driver's manager."""
        client = NodeClient(outputs=())
        client.read('floor')
        client.read('polygons')

        def complete():
            return [a for a in list(client.answers.values()) if {'floor', 'polygons'} <= set(a) and a['floor'].status == FOUND]
        answers = client.wait_for(lambda: len(complete()) >= 3 and complete(), 'three floors', 60.0)
        self.assertEqual(answers[0]['floor'].header.frame_id, frame)
        self.assertLessEqual({'/polygonal_perception', '/camera/driver'}, self.nodelets())
        return answers[0]['polygons']

    @staticmethod
    def wait_for_silence(client):
        """Until there has been no answer for a second."""
        last = {}

        def is_silent():
            if last.get('count') != len(client.answers):
                last.update(count=len(client.answers), time=time.monotonic())
            return time.monotonic() > last['time'] + 1.0
        client.wait_for(is_silent, 'the answers to end', 60.0)

    @staticmethod
    def next_message(topic, kind):
        return rospy.wait_for_message(topic, kind, 60.0)

    @staticmethod
    def nodelets():
        rospy.wait_for_service(MANAGER + '/list', DEADLINE)
        return set(rospy.ServiceProxy(MANAGER + '/list', NodeletList)().nodelets)

    def is_openni2_launch(self):
        return '/camera/depth_metric_rect' in self.nodelets()

    @needs_image_nodelets
    def test_builtin(self):
        self.launch(driver='builtin', depth_mode=8)
        self.check_polygons()
        self.assertFalse(self.is_openni2_launch())
        self.assertEqual(self.next_message('/camera/depth/image_rect', Image).encoding, '16UC1')
        self.assertEqual(self.next_message('/camera/depth/points', PointCloud2).width, 320)

    def test_builtin_registered(self):
        self.launch(driver='builtin', depth_mode=8, depth_registration='true')
        self.check_polygons(frame='camera_rgb_optical_frame')

    @needs_image_nodelets
    def test_builtin_with_a_calibration(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, 'depth_VIRTUAL0001.yaml'), 'w') as file:
                file.write(CALIBRATION)
            self.launch(driver='builtin', depth_mode=8, depth_camera_info_url='file://' + folder + '/${NAME}.yaml')
            self.check_polygons()
            info = self.next_message('/camera/depth/camera_info', CameraInfo)
        # That of the infrared camera, 2.5 and 2 pixels beside which the depth is.
        self.assertEqual(list(info.K), [280.0, 0, 158.5, 0, 281.0, 119.0, 0, 0, 1])
        self.assertEqual(list(info.P), [280.0, 0, 158.5, 0, 0, 281.0, 119.0, 0, 0, 0, 1, 0])
        self.assertEqual(info.D[0], 0.01)
        self.assertEqual(info.header.frame_id, 'camera_depth_optical_frame')

    @needs_image_nodelets
    def test_openni2_launch(self):
        self.install_openni2_launch()
        self.launch(driver='openni2_launch', depth_mode=11)
        self.check_polygons()
        self.assertTrue(self.is_openni2_launch())
        self.assertEqual(self.next_message('/camera/depth/image_raw', Image).width, 160)

    @needs_image_nodelets
    def test_openni2_launch_registered(self):
        self.install_openni2_launch()
        self.launch(driver='openni2_launch', depth_mode=8, depth_registration='true')
        self.check_polygons(frame='camera_rgb_optical_frame')

    @needs_image_nodelets
    def test_openni2_launch_while_the_camera_is_unplugged_and_back(self):
        self.install_openni2_launch()
        self.launch(driver='openni2_launch', depth_mode=8)
        client = NodeClient(outputs=())
        client.read('polygons')
        for _ in range(2):
            client.wait_for(lambda: client.answers, 'polygons', 60.0)
            os.remove(self.plug)
            self.wait_for_silence(client)
            client.answers.clear()
            self.put_in()
        client.wait_for(lambda: client.answers, 'polygons', 60.0)

    @needs_image_nodelets
    def test_openni2_launch_in_metres(self):
        self.install_openni2_launch()
        self.launch(driver='openni2_launch', depth_mode=8, image='camera/depth/image_rect')
        self.check_polygons()
        self.assertEqual(self.next_message('/camera/depth/image_rect', Image).encoding, '32FC1')

    @needs_image_nodelets
    def test_openni2_launch_with_clouds(self):
        self.install_openni2_launch()
        self.launch(driver='openni2_launch', depth_mode=8, input='cloud')
        self.check_polygons()

    @needs_image_nodelets
    def test_auto_takes_openni2_launch_where_it_is_installed(self):
        self.install_openni2_launch()
        self.launch(depth_mode=11)
        self.check_polygons()
        self.assertTrue(self.is_openni2_launch())
        self.assertEqual(self.next_message('/camera/depth/image_raw', Image).width, 160)

    @unittest.skipIf(has_openni2_launch(), 'openni2_launch is installed')
    def test_auto_takes_the_builtin_one_else(self):
        self.launch(depth_mode=8)
        self.check_polygons()
        self.assertFalse(self.is_openni2_launch())

    def test_auto_takes_the_builtin_one_for_a_file(self):
        self.install_openni2_launch()
        self.launch(device_id=STAND_IN)
        NodeClient(outputs=()).wait_for(lambda: '/camera/driver' in self.nodelets(), 'the driver', 60.0)
        self.assertFalse(self.is_openni2_launch())

    def test_auto_takes_the_one_that_runs(self):
        self.install_openni2_launch()
        self.launch(package='openni2_launch')
        rospy.wait_for_service(MANAGER + '/list', 30.0)
        output = subprocess.check_output([sys.executable, CHOICE, 'camera:=camera'],
                                         env=dict(os.environ, **self.environment), universal_newlines=True)
        self.assertIn(MANAGER + ' runs', output)

    def test_robotino(self):
        self.place('base_link')
        self.launch('robotino.launch', driver='builtin', depth_mode=8)
        self.assertEqual(self.check_polygons().header.frame_id, 'odom')

    def test_nao(self):
        self.place('base_footprint', 'Head')
        self.launch('nao.launch', driver='builtin', depth_mode=8)
        client = NodeClient(outputs=())
        client.read('polygons')
        # Whether there is a floor or not: the device is held higher than a Nao's head.
        answer = client.wait_for(lambda: list(client.answers.values()), 'polygons', 60.0)[0]
        self.assertEqual(answer['polygons'].header.frame_id, 'odom')

    @needs_image_nodelets
    def test_a_driver_that_is_started_later(self):
        self.launch(start_driver='false')
        self.install_openni2_launch()
        self.launch(package='openni2_launch')
        self.check_polygons()


if __name__ == '__main__':
    rospy.init_node('test_openni2_drivers')
    rostest.rosrun('polygonal_perception', 'test_openni2_drivers', OpenNI2DriversTest, sys.argv)
