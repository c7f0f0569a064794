#include <iostream>

#include "plugins/global_planner_parameters.hpp"
#include "polygonal_perception/ros/common/parameter_list.hpp"

int main()
{
  namespace common = polygonal_perception::ros_common;
  polygonal_perception::plugins::GlobalPlannerParameters defaults;
  std::cout << common::parameterTable(common::listParameters(defaults));
}
