#!/usr/bin/env python3
"""The nodelet comes and goes in a manager that lives on, while frames arrive."""
import sys
import threading
import unittest

import rospy
import rostest
from nodelet.srv import NodeletLoad, NodeletList, NodeletUnload

import scene
from node_client import DEADLINE, FOUND, Clock, NodeClient

LIVES = 15


class ReloadTest(unittest.TestCase):
    def test_every_life_ends_cleanly(self):
        services = {}
        for name, kind in (('load_nodelet', NodeletLoad), ('unload_nodelet', NodeletUnload), ('list', NodeletList)):
            rospy.wait_for_service('/manager/' + name, DEADLINE)
            services[name] = rospy.ServiceProxy('/manager/' + name, kind)
        client = NodeClient(outputs=(), runs=False)
        client.read('polygons')
        client.read('floor')
        camera, clock = scene.Camera(), Clock()
        depth = camera.render([scene.Box((1.82, 2.22), (-0.38, 0.12), (0, 0.3))])
        running = threading.Event()
        running.set()

        def publish():
            while running.is_set():
                client.send(camera.cloud(depth, clock.tick()))

        publisher = threading.Thread(target=publish)
        publisher.start()
        try:
            for life in range(LIVES):
                loaded = services['load_nodelet'](name='/polygonal_perception', my_argv=[], bond_id='',
                                                  type='polygonal_perception/PolygonalPerception',
                                                  remap_source_args=['/points'], remap_target_args=['/camera/depth/points'])
                self.assertTrue(loaded.success)
                if life % 3 == 2:
                    # It lives until it has answered; the others end at once.
                    # A fresh reader, since rospy may have missed that the topic was away for a moment.
                    client.stop_reading('floor')
                    client.read('floor')
                    begin = clock.now.to_nsec()
                    client.wait_for(lambda: any(k > begin and a['floor'].status == FOUND
                                                for k, a in client.answers.items() if 'floor' in a),
                                    'a floor in life %d' % life)
                self.assertEqual(list(services['list']().nodelets), ['/polygonal_perception'])
                self.assertTrue(services['unload_nodelet'](name='/polygonal_perception').success)
                self.assertEqual(list(services['list']().nodelets), [])
        finally:
            running.clear()
            publisher.join()


if __name__ == '__main__':
    rospy.init_node('test_reload')
    rostest.rosrun('polygonal_perception', 'test_reload', ReloadTest, sys.argv)
