"""The nodes under test, for tests of all of them: each with a client, good input for it, and what is a good answer."""
import scene
from map_client import MapClient, observation
from node_client import FOUND, NodeClient
from path_client import PathClient, polygons


class Perception:
    """The node of one sensor, which reads clouds or depth images."""

    NAME, OUTPUT, PROGRAM, NODELET = '/polygonal_perception', 'floor', 'polygonal_perception_node', 'PolygonalPerception'
    REMAPPED = {'points': '/camera/depth/points'}
    PARAMETERS = {}

    def __init__(self, depth=False, **options):
        self.depth, self.camera = depth, scene.Camera()
        self.image = self.camera.render()
        self.client = NodeClient(depth=depth, **options)

    def messages(self, stamp):
        if self.depth:
            return [self.camera.image(self.image, stamp), self.camera.info(stamp)]
        return [self.camera.cloud(self.image, stamp)]

    def is_good(self, answer):
        return answer['floor'].status == FOUND and abs(answer['floor'].distance - self.camera.height) < 0.005


class Map:
    """The map's node."""

    NAME, OUTPUT, PROGRAM, NODELET = '/polygon_map', 'polygons', 'polygon_map_node', 'PolygonMap'
    REMAPPED = {}
    # Long, for a busy machine: what comes before /tf_static does is lost.
    PARAMETERS = {'tf_timeout': 1.0}

    def __init__(self, **options):
        self.client = MapClient(**options)

    @staticmethod
    def messages(stamp):
        return [observation(stamp, hits=[(1.02, 0.03, 1)])]

    @staticmethod
    def is_good(answer):
        return answer['polygons'].floor_status == FOUND and len(answer['polygons'].polygons) > 0


class Path:
    """The planner's node."""

    NAME, OUTPUT, PROGRAM, NODELET = '/shortest_path', 'path', 'shortest_path_node', 'ShortestPath'
    REMAPPED = {}
    PARAMETERS = {'tf_timeout': 1.0}

    def __init__(self, **options):
        self.client = PathClient(**options)

    @staticmethod
    def messages(stamp):
        return [polygons(stamp)]

    @staticmethod
    def is_good(answer):
        return len(answer['path'].poses) == 4


SUBJECTS = {'perception': Perception, 'map': Map, 'path': Path}


def subject_of(kind, **options):
    """@param kind  of input: cloud, depth, cells or polygons"""
    others = {'cells': Map, 'polygons': Path}
    return others[kind](**options) if kind in others else Perception(depth=kind == 'depth', **options)
