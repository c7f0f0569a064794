// Prints the node's parameters as a Markdown table.
#include <iostream>

#include "ros/perception/node_parameters.hpp"

int main()
{
  std::cout << polygonal_perception::ros_perception::parameterTable();
}
