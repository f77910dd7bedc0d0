"""YAML files of ros2_control and MoveIt, which name the joints of a robot."""
