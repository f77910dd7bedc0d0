"""YAML files of ROS, which name the parts of a robot."""
