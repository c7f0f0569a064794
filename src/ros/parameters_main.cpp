// Prints the node's parameters as a Markdown table.
#include <iostream>

#include "polygonal_perception/ros/node_parameters.hpp"

int main()
{
  std::cout << polygonal_perception::parameterTable();
}
