# For the other scripts to source, first of all: stands in the project's folder, with the system's python3 (catkin's
# modules are not in any other) and ROS where it is not part of the system itself.
called_from=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit
export PATH=/usr/bin:$PATH

# Where everything is built, relative to the project. What is built otherwise, with sanitizers or clang, goes beside it.
build=$(realpath -m "${POLYGONAL_PERCEPTION_BUILD:-build}")

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

# usage [exit code]: the comment at the script's head.
usage() {
  sed -n '/^#!/d; s/^# \{0,1\}//p; /^set/q' "scripts/$(basename "$0")"
  exit "${1:-0}"
}

# configure [option...]: the build folder; quiet unless it fails.
configure() {
  mkdir -p "$build"
  cmake -S . -B "$build" "$@" > "$build/configure.log" 2>&1 || {
    cat "$build/configure.log" >&2
    exit 1
  }
}

# build_target TARGET...: configures the folder where that has not been done.
build_target() {
  [ -f "$build/cmake_install.cmake" ] || configure
  cmake --build "$build" -j"$(nproc)" --target "$@"
}

# program NAME: the path of one that was built.
program() { echo "$build/devel/lib/polygonal_perception/$1"; }

free_port() { python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])'; }

# What runs in the background: add its process id. It ends with the script, the last first.
background=()
end_background() {
  local i
  for ((i = ${#background[@]} - 1; i >= 0; --i)); do
    kill "${background[i]}" 2> /dev/null || true
    wait "${background[i]}" || true
  done
  background=()
}
trap end_background EXIT

# start_roscore: a private one, whatever runs on this machine, for all that is started from here on.
start_roscore() {
  local port deadline=$((SECONDS + 60))
  port=$(free_port)
  export ROS_MASTER_URI=http://localhost:$port
  roscore -p "$port" > /dev/null 2>&1 &
  background+=($!)
  until rosparam list > /dev/null 2>&1; do
    if ! kill -0 "${background[-1]}" || [ $SECONDS -gt $deadline ]; then
      echo "$0: no roscore" >&2
      exit 1
    fi
  done
}
