"""What is wrong with a map."""
import math

import cv2
import numpy as np

from poses import OPTICAL
from settings import FAR, NEAR

TOLERANCE = 0.15  # [m] a mark so near to an obstacle is one of it; what has a mark so near is not missed
LATTICE = 0.05  # [m] cells in which obstacles are seen
FINE = 0.01  # [m] on which the truth is drawn
LOW, MARGIN = 0.05, 0.03  # [m] pixels count from this height above the floor on, up to so far below max_height
OFF = 0.05  # [m] and so near to an obstacle
PIXELS = 5  # in a cell of one frame: there it is seen plainly
LOOK = 3  # frames from one that is looked at to the next
VIEWS = 3  # of these in which a cell was seen plainly
WAY_STEP = 10  # frames from one place of the way to the next
DELAY, RECENT = 0.2, 1.0  # [s] what was seen plainly in the second that ended so long before a map is in view
SETTLE, EACH = 3.0, 1.0  # [s] from the start to the first map that is judged, and from one to the next


class Truth:
    """The outlines of what stands, and how far from it a point is."""

    def __init__(self, message):
        self.outlines = [np.array([(p.x, p.y) for p in polygon.boundary.points]) for polygon in message.polygons]
        corners = np.concatenate(self.outlines)
        self.low = corners.min(0) - 1.0
        self.size = np.ceil((corners.max(0) + 1.0 - self.low) / FINE).astype(int)
        free = np.full(self.size[::-1], 255, np.uint8)
        for outline in self.outlines:
            cv2.fillPoly(free, [np.round((outline - self.low) / FINE - 0.5).astype(np.int32)], 0)
        self.field = FINE * cv2.distanceTransform(free, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)

    def distances(self, points):
        index = np.floor((points - self.low) / FINE).astype(int)
        inside = ((index >= 0) & (index < self.size)).all(1)
        x, y = np.clip(index, 0, self.size - 1).T
        return np.where(inside, self.field[y, x], np.inf)


class Sightings:
    """The cells of obstacles that single frames show plainly, by the camera's true pose."""

    def __init__(self, run, truth):
        self.times, self.cells, self.ranges = [], [], []
        k = np.reshape(run.info.K, (3, 3))
        for stamp in sorted(run.images)[::LOOK]:
            if stamp not in run.poses:
                continue
            base, body = run.poses[stamp]
            camera = base @ body @ OPTICAL
            depth = run.images[stamp] / 1000.0
            v, u = np.nonzero(depth)
            z = depth[v, u]
            points = np.stack([(u - k[0, 2]) * z / k[0, 0], (v - k[1, 2]) * z / k[1, 1], z], 1)
            points = points @ camera[:3, :3].T + camera[:3, 3]
            points = points[(points[:, 2] > LOW) & (points[:, 2] < run.case.max_height - MARGIN)][:, :2]
            points = points[truth.distances(points) < OFF]
            cells, counts = np.unique(np.floor(points / LATTICE).astype(int), axis=0, return_counts=True)
            cells = cells[counts >= PIXELS]
            self.times.append(stamp / 1e9)
            self.cells.append(cells)
            self.ranges.append(np.hypot(*(centres(cells) - camera[:2, 3]).T))

    def until(self, time):
        """Cells that are in view at a time, with their ranges, and those that were in view before."""
        recent, earlier = {}, {}
        for when, cells, ranges in zip(self.times, self.cells, self.ranges):
            if when > time - DELAY:
                break
            seen = recent if when > time - DELAY - RECENT else earlier
            for cell, distance in zip(map(tuple, cells), ranges):
                views, nearest = seen.get(cell, (0, math.inf))
                seen[cell] = views + 1, min(nearest, distance)
        in_view = {cell: distance for cell, (views, distance) in recent.items() if views >= VIEWS}
        before = {cell: distance for cell, (views, distance) in earlier.items() if views >= VIEWS and cell not in recent}
        return in_view, before


def centres(cells):
    return (np.reshape(cells, (-1, 2)) + 0.5) * LATTICE


class Grid:
    """A map, and how far from its marks a point is."""

    def __init__(self, message):
        info = message.info
        self.resolution = info.resolution
        self.low = np.array([info.origin.position.x, info.origin.position.y])
        occupied = np.array(message.data, np.int8).reshape(info.height, info.width) == 100
        rows, columns = np.nonzero(occupied)
        self.marks = self.low + (np.stack([columns, rows], 1) + 0.5) * self.resolution
        if len(rows):
            free = (~occupied).astype(np.uint8)
            self.field = self.resolution * cv2.distanceTransform(free, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
        else:
            self.field = np.full(occupied.shape, np.inf)

    def are_inside(self, points):
        index = self._index(points)
        return ((index >= 0) & (index < self.field.shape[::-1])).all(1)

    def distances(self, points):
        x, y = self._index(points).T
        return self.field[y, x]

    def _index(self, points):
        return np.floor((points - self.low) / self.resolution).astype(int)


class Missed:
    """Of some cells that were seen those that no mark is near to."""

    def __init__(self, grid, cells, robot):
        points = centres(cells)
        points = points[grid.are_inside(points)]
        self.total = len(points)
        self.points = points[grid.distances(points) > TOLERANCE]
        # What the robot cannot reach on a straight line without a mark in its way is no danger from where it is.
        self.are_open = np.array([self._is_open(grid, robot, point) for point in self.points], bool)

    @staticmethod
    def _is_open(grid, robot, point):
        steps = np.arange(0.0, np.linalg.norm(point - robot), grid.resolution / 2)
        line = robot + steps[:, None] * (point - robot) / np.linalg.norm(point - robot)
        return (grid.distances(line) > grid.resolution).all()


class Verdict:
    """Of one map at one time, when the robot has come along a way."""

    def __init__(self, grid, truth, sightings, time, way):
        self.time, self.grid = time, grid
        self.is_false = truth.distances(grid.marks) > TOLERANCE
        apart = grid.marks[self.is_false][:, None] - way[None, ::-WAY_STEP]
        self.false_near = int((np.hypot(apart[..., 0], apart[..., 1]).min(1) < NEAR).sum()) if self.is_false.any() else 0
        in_view, before = sightings.until(time)
        self.near = Missed(grid, [cell for cell, distance in in_view.items() if distance < NEAR], way[-1])
        self.far = Missed(grid, [cell for cell, distance in in_view.items() if NEAR <= distance < FAR], way[-1])
        self.before = Missed(grid, [cell for cell, distance in before.items() if distance < NEAR], way[-1])


def judge(run):
    """Verdicts by map, of maps EACH seconds apart; the last is that of the end."""
    truth = Truth(run.truth)
    sightings = Sightings(run, truth)
    verdicts = {}
    stamps = sorted(run.poses)
    way, times = np.array([run.poses[stamp][0][:2, 3] for stamp in stamps]), np.array(stamps) / 1e9
    for each, grids in run.grids.items():
        chosen, due = [], run.start + SETTLE
        for time, message in grids:
            if time >= due or (time, message) == grids[-1]:
                chosen.append(Verdict(Grid(message), truth, sightings, time, way[times < time + 1e-3]))
                due = time + EACH - 1e-3
        verdicts[each] = chosen
    return truth, verdicts
