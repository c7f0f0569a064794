# For the other scripts to source: stands in the project's folder, with the system's python3 (catkin's modules are not
# in any other) and ROS where it is not part of the system itself.
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit
export PATH=/usr/bin:$PATH

# ROS's own setup files use variables that are not set.
source_setup() {
  set +u
  # shellcheck source=/dev/null
  . "$1"
  set -u
}
if [ -z "${ROS_DISTRO:-}" ] && [ -f /opt/ros/noetic/setup.bash ]; then
  source_setup /opt/ros/noetic/setup.bash
fi
