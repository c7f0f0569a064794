# For scripts/test to source: the tests with gcc's sanitizers.
#
# Each process writes its reports to a file, since nobody looks at what a node or a nodelet manager prints, or at its
# exit code. test/sanitizers/thread.supp and scripts/sanitizer_reports have what is not ours, and why.

# use_sanitizers <list> <build folder>: for all programs that are started from here on.
use_sanitizers() {
  local sanitize=$1 build=$2 runtime=
  sanitizer_reports=$build/sanitizer_reports
  rm -rf "$sanitizer_reports"
  mkdir -p "$sanitizer_reports"
  local options="log_path=$sanitizer_reports/report:log_exe_name=1:print_suppressions=0"
  # Not by the exit code: scripts/sanitizer_reports knows more than the suppressions.
  export TSAN_OPTIONS="$options:suppressions=$PWD/test/sanitizers/thread.supp:second_deadlock_stack=1:history_size=7:exitcode=0"
  export ASAN_OPTIONS="$options:detect_stack_use_after_return=1:handle_abort=1"
  # It writes to no file itself. It aborts, and AddressSanitizer reports that.
  export UBSAN_OPTIONS="$options:print_stacktrace=1:halt_on_error=1:abort_on_error=1"
  # For what a test builds against us.
  export CXXFLAGS="-fsanitize=$sanitize"
  case $sanitize in
    *address*) runtime=libasan.so ;;
    *thread*) runtime=libtsan.so ;;
  esac
  [ -z "$runtime" ] || preload "$build" "$(gcc -print-file-name=$runtime)"
}

# preload <build folder> <runtime>: nodelet managers and rviz load our libraries, but no sanitizer, which has to be there
# first. A workspace below ours has programs of their names that see to it. Our libraries come with it, since the
# sanitizers name no function of what is loaded after their first report.
preload() {
  local workspace=$1/preloaded ours="$1/devel/lib/libpolygonal_perception_*ros*.so" program original
  # LC_ALL: in any other locale rviz hangs in glibc under gcc 12's ThreadSanitizer.
  for program in nodelet rviz; do
    original=$(catkin_find --first-only --libexec $program $program) || continue
    mkdir -p "$workspace/lib/$program"
    # shellcheck disable=SC2016 # the program's own arguments
    printf '#!/bin/sh\nLC_ALL=C LD_PRELOAD="%s $(echo %s)" exec %s "$@"\n' "$2" "$ours" "$original" > "$workspace/lib/$program/$program"
    chmod +x "$workspace/lib/$program/$program"
  done
  touch "$workspace/.catkin"
  export CMAKE_PREFIX_PATH=$workspace${CMAKE_PREFIX_PATH:+:$CMAKE_PREFIX_PATH}
}
