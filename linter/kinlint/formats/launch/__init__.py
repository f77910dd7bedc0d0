"""Launch files of ROS, which pass arguments to the xacro of a robot."""
