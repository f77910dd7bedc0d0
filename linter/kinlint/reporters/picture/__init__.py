"""Pictures of robots: links, joints and loops, with the findings marked on what they are about."""
