"""Starts the SCARA arm with its controllers and RViz."""

from launch import LaunchDescription
from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    share = FindPackageShare("scara_description")
    description = Command(["xacro ", PathJoinSubstitution([share, "urdf", "scara.urdf"])])
    controllers = PathJoinSubstitution([share, "config", "controllers.yaml"])
    display = PathJoinSubstitution([share, "rviz", "scara.rviz"])
    return LaunchDescription(
        [
            Node(
                package="controller_manager",
                executable="ros2_control_node",
                parameters=[{"robot_description": description}, controllers],
            ),
            Node(package="rviz2", executable="rviz2", arguments=["-d", display]),
        ]
    )
