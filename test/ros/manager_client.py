"""Loads nodelets into a manager that runs, and unloads them."""
import rospy
from nodelet.srv import NodeletList, NodeletLoad, NodeletUnload

from node_client import DEADLINE


class ManagerClient:
    def __init__(self, test, manager='/manager'):
        """@param test  an object with assertTrue() and the like"""
        self.test, self.services = test, {}
        for name, kind in (('load_nodelet', NodeletLoad), ('unload_nodelet', NodeletUnload), ('list', NodeletList)):
            rospy.wait_for_service(manager + '/' + name, DEADLINE)
            self.services[name] = rospy.ServiceProxy(manager + '/' + name, kind)

    def loaded(self):
        return self.services['list']().nodelets

    def load(self, name, nodelet, remapped):
        answer = self.services['load_nodelet'](
            name=name, type='polygonal_perception/' + nodelet, my_argv=[], bond_id='',
            remap_source_args=list(remapped), remap_target_args=list(remapped.values()))
        self.test.assertTrue(answer.success, name)
        self.test.assertIn(name, self.loaded())

    def unload(self, name):
        self.test.assertTrue(self.services['unload_nodelet'](name=name).success, name)
        self.test.assertNotIn(name, self.loaded())

    def unload_all(self):
        for name in self.loaded():
            self.services['unload_nodelet'](name=name)
