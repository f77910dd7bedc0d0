"""xacro: the robot that a file expands to, with every place in the file that wrote it."""
