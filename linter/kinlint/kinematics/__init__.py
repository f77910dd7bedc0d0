"""The kinematic structure of robots, as the store of an examination has it."""
