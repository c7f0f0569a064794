"""Draws maps side by side on what stands in the room."""
import math

import matplotlib

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import PatchCollection, PolyCollection  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.patches import Patch, Rectangle, Wedge  # noqa: E402

from judgement import LATTICE  # noqa: E402
from settings import FAR, NEAR  # noqa: E402

STANDS, OUTLINE, RIGHT, FALSE, MISSED, BEYOND, WAY = (
    '#dcdcdc', '#8c8c8c', '#1f4e79', '#e02020', '#ff9500', '#ffd591', '#2a9d4a')
WIDTH, HEAD, FOOT = 11.2, 0.58, 0.40  # [in]
ROOM, STRIP = 0.2, 0.35  # [m] around all that is drawn, and below it for the scale


def squares(points, size):
    return [Rectangle(point - size / 2, size, size) for point in points]


def frame_of(run, truth, verdicts):
    """Lower and upper corner of what is worth drawing."""
    way = np.array([base[:2, 3] for base, _ in run.poses.values()])
    points = np.concatenate([way] + [verdict.grid.marks for verdict in verdicts])
    corners = np.concatenate(truth.outlines)
    low = np.maximum(points.min(0), corners.min(0)) - [ROOM, ROOM + STRIP]
    return low, np.minimum(points.max(0), corners.max(0)) + ROOM


def draw_map(axes, run, truth, verdict):
    axes.add_collection(PolyCollection(truth.outlines, facecolor=STANDS, edgecolor=OUTLINE, linewidth=0.7))
    wrong, size = verdict.is_false, verdict.grid.resolution
    marks = verdict.grid.marks
    axes.add_collection(PatchCollection(squares(marks[~wrong], size), facecolor=RIGHT, edgecolor='none'))
    axes.add_collection(PatchCollection(squares(marks[wrong], size), facecolor=FALSE, edgecolor='none'))
    axes.add_collection(PatchCollection(squares(verdict.far.points, LATTICE), facecolor=BEYOND, edgecolor='none'))
    for missed in (verdict.before, verdict.near):
        axes.add_collection(PatchCollection(squares(missed.points, LATTICE), facecolor=MISSED, edgecolor='none'))
    way = np.array([run.poses[stamp][0] for stamp in sorted(run.poses)])
    axes.plot(way[:, 0, 3], way[:, 1, 3], color=WAY, linewidth=1.6, zorder=4)
    place, yaw = way[-1][:2, 3], math.degrees(math.atan2(way[-1][1, 0], way[-1][0, 0]))
    half = math.degrees(math.atan(run.info.width / 2 / run.info.K[0]))
    for reach in (NEAR, FAR):
        axes.add_patch(Wedge(place, reach, yaw - half, yaw + half, facecolor=WAY, alpha=0.08, edgecolor='none', zorder=0))
    axes.plot(*place, marker='o', markersize=6, color=WAY, zorder=5)


def draw_scale(axes, low):
    x, y = low + [0.15, STRIP / 2]
    axes.plot([x, x + 1.0], [y, y], color='black', linewidth=2.5, solid_capstyle='butt')
    axes.text(x + 1.1, y, '1 m', va='center', fontsize=10.5)


def title(each, verdict):
    missed, far = len(verdict.near.points) + len(verdict.before.points), len(verdict.far.points)
    return '%s\nmarked floor: %d cells; missed: %d, and %d beyond %g m' % (
        str(each).replace('`', ''), verdict.is_false.sum(), missed, far, NEAR)


def draw(path, run, truth, panels):
    """panels: map and verdict, from left to right."""
    low, high = frame_of(run, truth, [verdict for _, verdict in panels])
    height = (WIDTH - 0.2) / len(panels) * (high - low)[1] / (high - low)[0]
    figure, row = plt.subplots(1, len(panels), figsize=(WIDTH, height + HEAD + FOOT))
    for axes, (each, verdict) in zip(np.atleast_1d(row), panels):
        draw_map(axes, run, truth, verdict)
        draw_scale(axes, low)
        axes.set_xlim(low[0], high[0])
        axes.set_ylim(low[1], high[1])
        axes.set_aspect('equal')
        axes.set_xticks([])
        axes.set_yticks([])
        axes.set_title(title(each, verdict), fontsize=11.5, loc='left')
    figure.legend(handles=[
        Patch(facecolor=STANDS, edgecolor=OUTLINE, label='stands there'),
        Patch(facecolor=RIGHT, label='marked: obstacle'),
        Patch(facecolor=FALSE, label='marked: floor'),
        Patch(facecolor=MISSED, label='seen, not marked'),
        Patch(facecolor=BEYOND, label='the same beyond %g m' % NEAR),
        Line2D([], [], color=WAY, marker='o', label='way; view of %g and 5 m' % NEAR)],
        loc='lower center', ncol=6, frameon=False, fontsize=10.5, handlelength=1.2, columnspacing=1.2)
    whole = height + HEAD + FOOT
    figure.subplots_adjust(left=0.005, right=0.995, top=1 - HEAD / whole, bottom=FOOT / whole, wspace=0.02)
    figure.savefig(path, dpi=100)
    plt.close(figure)
