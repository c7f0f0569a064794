"""Shows a simulated camera's frames to several costmaps at once, and holds each map against what stands in the room.

Made for scripts/compare_costmaps, which starts it. Prints a table for each case.
"""
import argparse
import sys

import numpy as np
import rospy

from judgement import judge
from picture import draw
from settings import Case, Map
from world import RATE, Failure, World


def parse():
    parser = argparse.ArgumentParser(prog='scripts/compare_costmaps', add_help=False)
    parser.add_argument('--programs', required=True)
    parser.add_argument('--cases', nargs='+', type=Case, default=[
        Case(c) for c in ('nao', 'nao!', 'robotino', 'robotino+1', 'robotino+2')])
    parser.add_argument('--maps', nargs='+', type=Map, default=[
        Map(m) for m in ('voxel:0.08', 'voxel:0.15', 'voxel:0.08@5', 'obstacle:0.08', 'scan', 'map')])
    parser.add_argument('--seeds', nargs='+', type=int, default=[1, 2, 3])
    parser.add_argument('--scene', default='office')
    parser.add_argument('--seconds', type=float, default=30.0)
    parser.add_argument('--width', type=int, default=320)
    parser.add_argument('--picture')
    parser.add_argument('--pictured', nargs='+', type=Map, default=[Map('voxel:0.08'), Map('scan')])
    options = parser.parse_args(rospy.myargv()[1:])
    options.frames = round(options.seconds * RATE)
    return options


def share(parts):
    """Of all cells those that are missed, and those that are missed in the open."""
    total = sum(part.total for part in parts)
    missed, free = sum(len(part.points) for part in parts), sum(part.are_open.sum() for part in parts)
    return '%.1f / %.1f %%' % (100.0 * missed / total, 100.0 * free / total) if total else '-'


def row(each, verdicts, cpus):
    false = [int(verdict.is_false.sum()) for verdict in verdicts]
    cells = ['%s' % each, '%.0f' % np.mean([len(verdict.is_false) for verdict in verdicts]), '%.1f' % np.mean(false),
             '%d' % max(false), '%.1f' % np.mean([verdict.false_near for verdict in verdicts])]
    for name in ('near', 'far', 'before'):
        cells.append(share([getattr(verdict, name) for verdict in verdicts]))
    return '| ' + ' | '.join(cells + ['%.1f' % (1000 * np.mean(cpus))]) + ' |'


def cpu_of(each, run):
    """[s] a frame: of all that stands between the cloud and the map."""
    names = [each.node] if each.reads_cloud else [each.node, 'polygonal_perception']
    return sum(run.cpu[name] for name in names)


def main():
    options = parse()
    rospy.set_param('/use_sim_time', True)
    rospy.init_node('compare_costmaps', disable_signals=True)
    world = World(options)
    picture = options.picture
    for case in options.cases:
        verdicts, cpus = {each: [] for each in options.maps}, {each: [] for each in options.maps}
        print('\n%s.\n' % case)
        for seed in options.seeds:
            run = world.make_run(case, seed)
            truth, found = judge(run)
            for each in options.maps:
                verdicts[each] += found[each]
                cpus[each].append(cpu_of(each, run))
            pitch, roll = np.degrees(run.mount.sway)
            way = sum(np.linalg.norm(np.diff([run.poses[s][0][:2, 3] for s in sorted(run.poses)], axis=0), axis=1))
            print('Seed %d: the camera is %.2f m up and looks %.0f degrees down, but for %.1f; it rolls up to %.1f; '
                  '%.1f m of way; %d answers late' % (
                      seed, run.mount.height, np.degrees(run.mount.pitch), pitch, roll, way, run.late),
                  file=sys.stderr, flush=True)
            if picture:
                by_name = {each.name: found[each][-1] for each in options.maps}
                draw(picture, run, truth, [(each, by_name[each.name]) for each in options.pictured])
                picture = None
        print('| | marked | of these floor | at most | up to 2.5 m | missed up to 2.5 m | missed from 2.5 to 5 m '
              '| missed out of view | CPU [ms] |\n|' + 9 * '---|')
        for each in options.maps:
            print(row(each, verdicts[each], cpus[each]), flush=True)


if __name__ == '__main__':
    try:
        main()
    except Failure as failure:
        sys.exit('scripts/compare_costmaps: %s' % failure)
    except KeyboardInterrupt:
        sys.exit(130)
