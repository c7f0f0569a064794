"""What is compared: the cases of a robot and its tf, and the maps."""
import argparse
import math
import os
import re

import yaml

CONFIG = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..', 'config')
RAW_CLOUD = '/camera/depth/points'
UPDATES = 5.0  # [Hz] of a costmap, as config/costmap_scan.yaml has it
# [m] obstacle_range of costmap_2d by default, and of config/costmap_scan.yaml.
NEAR, FAR = 2.5, 4.99
LAYERS = {'voxel': 'costmap_2d::VoxelLayer', 'obstacle': 'costmap_2d::ObstacleLayer'}


def read_config(name):
    with open(os.path.join(CONFIG, name)) as file:
        return yaml.safe_load(file)


class Case:
    """nao or robotino, and what tf does not know.

    nao walks and nods, and tf has its camera where it is on average. robotino drives with a camera that is where tf says;
    robotino+1 with one that looks a degree farther down than tf says, so that the floor seems to rise, robotino-1 a degree
    less. With ! tf knows every motion of the camera, as of no real robot.
    """

    def __init__(self, text):
        match = re.fullmatch(r'(nao|robotino)(!?)([+-][0-9.]+)?', text)
        if not match:
            raise argparse.ArgumentTypeError("'%s' is no case; such are nao, nao!, robotino and robotino+1" % text)
        self.robot, self.tf_knows, self.error = match[1], bool(match[2]), math.radians(float(match[3] or 0))
        self.parameters = read_config(self.robot + '.yaml')
        self.max_height = self.parameters['max_height']

    def __str__(self):
        text = '%s %s' % ((self.robot, 'walks') if self.robot == 'nao' else (self.robot, 'drives'))
        if self.tf_knows:
            return text + '; tf knows every motion of the camera'
        if self.error:
            degrees = round(abs(math.degrees(self.error)), 2)
            return '%s; the camera looks %g degree%s %s down than tf says' % (
                text, degrees, '' if degrees == 1 else 's', 'farther' if self.error > 0 else 'less')
        return text + '; tf has the camera where it is on average'


class Map:
    """scan, map, voxel:HEIGHT or obstacle:HEIGHT, the last two with @RANGE or without.

    scan is costmap_2d with config/costmap_scan.yaml; map is what polygon_map_node calls occupied; the others are a layer of
    costmap_2d on the raw cloud, whose points count from this height on and up to this range [m].
    """

    def __init__(self, text):
        match = re.fullmatch(r'(scan|map)|(voxel|obstacle):([0-9.]+)(?:@([0-9.]+))?', text)
        if not match:
            raise argparse.ArgumentTypeError("'%s' is no map; such are scan, map, voxel:0.08 and obstacle:0.08" % text)
        self.name, self.kind, self.height = text, match[1] or match[2], float(match[3] or 0)
        self.range = float(match[4] or NEAR)
        self.reads_cloud = match[1] is None
        self.is_costmap = self.kind != 'map'
        self.node = re.sub(r'\W', '_', text) + '_map'
        if self.is_costmap:
            self.topic = '/%s/costmap/costmap' % self.node
        else:
            self.topic = '/%s/occupancy_grid' % self.node

    def __str__(self):
        if self.kind == 'scan':
            return 'obstacle layer on `~scan`'
        if self.kind == 'map':
            return '`polygon_map_node`'
        return '%s layer on the cloud, from %g cm, to %g m' % (self.kind, 100 * self.height, self.range)

    def parameters(self, case):
        parameters = read_config('costmap_scan.yaml')
        if self.reads_cloud:
            # All but the layer is the same.
            parameters['plugins'][0]['type'] = LAYERS[self.kind]
            parameters['obstacles'] = self._raw_layer(case.max_height)
        # Every update is published, and whole.
        parameters.update(publish_frequency=10 * UPDATES, always_send_full_costmap=True)
        return parameters

    def _raw_layer(self, max_height):
        """Voxels, and by default ranges, as in costmap_2d's own launch/example_params.yaml.

        It takes a laser's points from 8 cm on. The points of the floor clear, as a source of their own, or nothing would
        clear where there is only floor.
        """
        source = {'topic': RAW_CLOUD, 'data_type': 'PointCloud2', 'obstacle_range': self.range,
                  'raytrace_range': self.range + 0.5, 'expected_update_rate': 0.5}
        layer = {
            'track_unknown_space': False, 'max_obstacle_height': max_height, 'observation_sources': 'marking clearing',
            'marking': dict(source, marking=True, clearing=False,
                            min_obstacle_height=self.height, max_obstacle_height=max_height),
            'clearing': dict(source, marking=False, clearing=True, min_obstacle_height=-1.0, max_obstacle_height=3.0)}
        if self.kind == 'voxel':
            layer.update(origin_z=0.0, z_resolution=0.2, z_voxels=10, unknown_threshold=10, mark_threshold=0)
        return layer
